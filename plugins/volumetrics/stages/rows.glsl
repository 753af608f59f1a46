// From view rays to rows of the rectified map. Needs lib/epipolar.glsl and stages/rectified.h before it, and in scope:
// `light` (RectifiedLightBlock) and `slices[]` (Slice).

#include "stages/opaque.glsl"

const float kPi = 3.14159265358979;

// What the layout can come to: a branch that cannot be taken costs as much as one that is, on a device that runs both under masks.
layout(constant_id = 13) const bool kProjective = true;
layout(constant_id = 14) const bool kBorder = true;
layout(constant_id = 15) const bool kLocal = false;   // spot and point lights: columns are angles at the light
layout(constant_id = 27) const bool kShaped = false;  // light rays differ in strength: cones and cookies
layout(constant_id = 28) const bool kColoured = false;  // and in colour
bool byTangent() { return kProjective && opaque(light.map.slicing) == kSlicesByTangent; }
bool byBorder() { return kBorder && opaque(light.map.slicing) == kSlicesByBorder; }

// Slice coordinate of a direction with components p along (e1, e2): slice i covers [i, i + 1].
float sliceCoordinate(vec2 p) {
  if (byTangent()) return (p.y / p.x - light.map.sliceLow) / light.map.sliceStep;
  float phi = atan(p.y, p.x);
  if (!byBorder()) return (phi - light.map.sliceLow) / light.map.sliceStep;
  uint i = 0u;
  while (i + 1u < opaque(light.map.edgeCount) && phi > light.map.edges[i].phiEnd) ++i;
  BorderEdge edge = light.map.edges[i];
  float turn = edge.delta.x * p.y - edge.delta.y * p.x;
  float t = -(edge.start.x * p.y - edge.start.y * p.x) / (abs(turn) < 1e-12 ? 1e-12 : turn);
  return edge.sliceStart + clamp(t, 0.0, 1.0) * edge.sliceCount;
}

// Unit direction along (e1, e2) of a slice coordinate.
vec2 sliceDirection(float at) {
  if (byTangent()) return normalize(vec2(1.0, light.map.sliceLow + at * light.map.sliceStep));
  if (!byBorder()) {
    float phi = light.map.sliceLow + at * light.map.sliceStep;
    return vec2(cos(phi), sin(phi));
  }
  uint i = 0u;
  while (i + 1u < opaque(light.map.edgeCount) && at > light.map.edges[i].sliceStart + light.map.edges[i].sliceCount) ++i;
  BorderEdge edge = light.map.edges[i];
  float t = clamp((at - edge.sliceStart) / max(edge.sliceCount, 1e-6), 0.0, 1.0);
  return normalize(edge.start + t * edge.delta);
}

// Normalised depth in [0, 1], growing away from the light, of a point at distance c from the axis and height h along it; constant
// along a view ray, for which any point of it does.
float rectifiedDepth(float c, float h) {
  float depth = clamp((inclination(c, h) - light.map.depthLow) * light.map.depthScale, 0.0, 1.0);
  return opaque(light.map.depthPower) == 1.0 ? depth : pow(depth, light.map.depthPower);
}

uint totalColumns() { return opaque(light.map.columns * light.map.splits); }

// Distance from the axis, m, or angle at the light, rad, at a column coordinate in [0, totalColumns()].
float columnDistance(Slice s, float column) {
  float at = column / float(light.map.columns);
  if (!byTangent()) return mix(s.first, s.last, columnsReach(s.nearest, at));
  uint i = min(uint(at), light.map.splits - 1u);
  return s.perX / mix(light.map.inverse[i], light.map.inverse[i + 1u], at - float(i));
}

// Width of a column of a map that is not projective, m or rad.
float columnWidth(Slice s, float column) {
  float even = 1.0 / float(light.map.columns);
  return (s.last - s.first) * even * (s.nearest + (1.0 - s.nearest) * (2.0 * column + 1.0) * even);
}

// The column coordinate at distance (or angle) c from the axis, clamped to the map.
float columnAt(Slice s, float c) {
  float columns = float(light.map.columns);
  if (!byTangent())
    return s.last > s.first ? columnsWithin(s.nearest, clamp((c - s.first) / (s.last - s.first), 0.0, 1.0)) * columns : 0.0;
  if (s.last <= s.first) return 0.0;
  float inverse = s.perX / max(c, 1e-12);
  uint i = 0u;
  while (i + 1u < opaque(light.map.splits) && inverse < light.map.inverse[i + 1u]) ++i;
  float a = light.map.inverse[i];
  float b = light.map.inverse[i + 1u];
  return (float(i) + clamp((a - inverse) / (a - b), 0.0, 1.0)) * columns;
}

// Column at which segment i of a slice begins, i up to the number of segments (where the last ends).
uint segmentBorder(Slice s, uint i) {
  if (!kProjective || opaque(light.map.segmentsByDistance) == 0u) return light.map.segmentStart[i];
  if (i == 0u) return 0u;
  if (i >= opaque(light.map.segmentCount)) return light.map.columns;
  float reach = light.map.segmentDistance[i] * (opaque(light.map.fullCircle) != 0u ? 1.0 : s.perX);
  return min(8u * uint(columnAt(s, reach) * 0.125 + 0.5), light.map.columns);  // whole eights: mips do not mix two segments
}
