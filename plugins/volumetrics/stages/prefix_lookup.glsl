// meanVisibility() of the techniques that look up a prefix: one look-up per segment that the ray passes, K of them with reference
// rays, none where the prefix bounds settle it. Needs the bindings `bounds` and `lit` (stages/lit.comp.glsl) and, from the technique:
//   void visibilities(Place place, RowRay ray, out float v[kReferenceRays])   one for each reference ray, not yet clamped
// Segments are joined with the weights of the ray's own inclination: exact, whatever the reference rays.
#include "stages/reference_rays.glsl"
#include "stages/row_weights.glsl"
#include "stages/channels.glsl"
#include "stages/lit.glsl"
const float kHalfStep = 0.5 / 65535.0;  // of 16-bit unorm
const float kMipLevels = 4.0;           // of a prefix with mips
const float kWidestPixel = 8.0;         // slices

// Where in a prefix image the sums of one segment up to the ray's end lie.
struct Place {
  int rowA, rowB;         // slices
  float weightA, weightB;
  float columnA, columnB; // texel coordinates along y, of texel centres (+ 1/2)
  float slice;            // texel coordinate along x between both
  float wide;             // slices that the pixel covers
  float lod;
};

// Texel coordinate along y at which linear filtering gives the prefix up to `column`: texel j holds the prefix of columns up to and
// with j, so coordinate j + 1 is its centre (j + 1/2) plus a half. Clamped to the segment's own texels at mip level `lod`.
float prefixTexel(float column, vec2 segment, float lod) {
  float half_ = 0.5 * exp2(ceil(lod));
  return clamp(column - 0.5, segment.x + half_, max(segment.y - half_, segment.x + half_));
}

vec4 lookUp(sampler2DArray prefix, Place place, float layer) {
  vec2 inverse = 1.0 / vec2(textureSize(prefix, 0).xy);  // a further light's map is a part of it
  if (kRowFilter == kRowMipmapped) {
    float column = mix(place.columnB, place.columnA, place.weightA) * inverse.y;
    float taps = ceil(0.5 * place.wide * exp2(-place.lod));  // a trilinear tap spans two texels of its mip
    vec4 sum = vec4(0.0);
    for (float i = 0.5; i < taps; i += 1.0) {
      float slice = place.slice + place.wide * (i / taps - 0.5);
      if (opaque(light.map.fullCircle) != 0u) slice = mod(slice, float(light.map.slices));
      // No filter may reach beyond the light's own slices.
      float half_ = 0.5 * exp2(ceil(place.lod));
      slice = clamp(slice, half_, float(light.map.slices) - half_);
      sum += textureLod(prefix, vec3(slice * inverse.x, column, layer), place.lod);
    }
    return sum / taps;
  }
  // In a projective map both rows have the ray's end in the same column: the sampler interpolates them.
  if (kRowFilter == kRowLinear && byTangent())
    return textureLod(prefix, vec3(place.slice * inverse.x, place.columnA * inverse.y, layer), 0.0);
  vec4 value = textureLod(prefix, vec3((float(place.rowA) + 0.5) * inverse.x, place.columnA * inverse.y, layer), 0.0);
  if (kRowFilter == kRowLinear)
    value = value * place.weightA +
            textureLod(prefix, vec3((float(place.rowB) + 0.5) * inverse.x, place.columnB * inverse.y, layer), 0.0) * place.weightB;
  return value;
}

void visibilities(Place place, RowRay ray, out float v[kReferenceRays]);

// Prefix minimum and maximum of one row's segment up to the ray's end, without the columns that may hold the very surface that
// ends the ray.
vec2 rangeBefore(Row row, vec2 segment, float column) {
  float texel = floor(column) - (column < segment.y ? row.s.lookBack : 1.0);
  return texelFetch(bounds, ivec2(row.index, clamp(int(texel), int(segment.x), int(segment.y) - 1)), 0).xy;
}

// Mean visibility of one segment's columns before `columnA` and `columnB` of the two rows, times their light rays' strength where those differ. A
// segment may be empty in a row.
vec3 segmentVisibility(RowRay ray, vec2 segmentA, vec2 segmentB, float columnA, float columnB, float wide, float lod) {
  bool hasA = segmentA.y > segmentA.x;
  bool hasB = kRowFilter != kRowNearest && segmentB.y > segmentB.x;
  if (!hasA && !hasB) return vec3(1.0);
  bool lit_ = false;
  if (kBounds) {
    vec2 range = vec2(1.0, 0.0);
    if (hasA) range = rangeBefore(ray.a, segmentA, columnA);
    if (hasB) {
      vec2 other = rangeBefore(ray.b, segmentB, columnB);
      range = vec2(min(range.x, other.x), max(range.y, other.y));
    }
    lit_ = ray.depth <= range.x - kHalfStep || range.x >= 1.0;
    if (lit_ && !kShaped) return vec3(1.0);
    if (!lit_ && ray.depth > range.y + kHalfStep) return vec3(0.0);
  }
  Place place;
  place.rowA = ray.a.index;
  place.rowB = ray.b.index;
  place.weightA = hasB ? (hasA ? ray.a.weight : 0.0) : 1.0;
  place.weightB = hasB ? (hasA ? ray.b.weight : 1.0) : 0.0;
  place.columnA = prefixTexel(columnA, segmentA, lod);
  place.columnB = prefixTexel(columnB, segmentB, lod);
  place.slice = ray.slice;
  place.wide = wide;
  place.lod = lod;
  float v[kReferenceRays];
  if (lit_)
    for (int k = 0; k < kReferenceRays; ++k) v[k] = 1.0;
  else
    visibilities(place, ray, v);
  float low = mix(ray.b.s.nodeLow, ray.a.s.nodeLow, ray.a.weight);
  float high = mix(ray.b.s.nodeHigh, ray.a.s.nodeHigh, ray.a.weight);
  float length_ = hasA ? columnDistance(ray.a.s, columnA) - columnDistance(ray.a.s, segmentA.x)
                       : columnDistance(ray.b.s, columnB) - columnDistance(ray.b.s, segmentB.x);
  float share[kReferenceRays];
  referenceShares(low, high, ray.theta, length_, share);
  if (!kShaped) {
    if (kReferenceRays == 1) return vec3(clamp(v[0], 0.0, 1.0));
    float sum = 0.0;
    for (int k = 0; k < kReferenceRays; ++k) sum += share[k] * v[k];
    return vec3(clamp(sum, 0.0, 1.0));
  }
  float value[kChannelSlots];
  litChannels(place.rowA, place.columnA, value);
  if (place.weightB > 0.0) {
    float other[kChannelSlots];
    litChannels(place.rowB, place.columnB, other);
    for (int i = 0; i < kChannels; ++i) value[i] = value[i] * place.weightA + other[i] * place.weightB;
  }
  for (int i = 0; i < kChannels; ++i) value[i] *= clamp(v[i / kColours], 0.0, 1.0);
  return max(betweenReferenceRays(value, share), vec3(0.0));
}

// Width of a pixel, in slices, as far as it is averaged.
float pixelSlices(RowRay ray) {
  if (kRowFilter != kRowMipmapped) return 1.0;
  vec2 size = frame.rays.pixelScale;
  vec3 right = frame.rays.right * size.x;
  vec3 up = frame.rays.up * size.y;
  uvec2 pixel = gl_GlobalInvocationID.xy;
  vec3 direction = rayDirection(frame.rays, pixel);
  float widest = 0.0;
  for (int i = 0; i < 2; ++i) {
    vec3 next = i == 0 ? direction + right : direction - up;
    float moved = abs(sliceCoordinate(vec2(dot(next, light.map.e1), dot(next, light.map.e2))) - ray.slice);
    if (opaque(light.map.fullCircle) != 0u) moved = min(moved, float(light.map.slices) - moved);
    widest = max(widest, moved);
  }
  return clamp(widest, 1.0, kWidestPixel);
}

vec3 meanVisibility(RowRay ray) {
  float wide = pixelSlices(ray);
  // A mip averages columns too, and with them the ends of rays: no more than a 512th of a row.
  float lod = clamp(log2(wide), 0.0, min(kMipLevels - 1.0, floor(log2(max(float(totalColumns()) / 512.0, 1.0)))));
  bool nearerA = ray.a.weight >= 0.5;
  float leading = nearerA ? ray.a.column : ray.b.column;
  float last = clamp(ceil(leading) - 1.0, 0.0, float(totalColumns()) - 1.0);
  Slice s = slices[nearerA ? ray.a.index : ray.b.index];
  vec3 sum = vec3(0.0);
  float total = 0.0;
  uint i = 0u;
  vec2 a = vec2(0.0, float(segmentBorder(ray.a.s, 1u)));
  vec2 b = vec2(0.0, float(segmentBorder(ray.b.s, 1u)));
  // Whole segments, and then the one in which the ray ends.
  while (i + 1u < opaque(light.map.segmentCount) && (nearerA ? a.y : b.y) <= last) {
    vec2 own = nearerA ? a : b;
    if (own.y > own.x) {
      float weight = ownWeight(ray, s, own.x, own.y);
      sum += weight * segmentVisibility(ray, a, b, a.y, b.y, wide, lod);
      total += weight;
    }
    ++i;
    a = vec2(a.y, float(segmentBorder(ray.a.s, i + 1u)));
    b = vec2(b.y, float(segmentBorder(ray.b.s, i + 1u)));
  }
  vec3 visible = segmentVisibility(ray, a, b, clamp(ray.a.column, a.x, a.y), clamp(ray.b.column, b.x, b.y), wide, lod);
  if (i == 0u) return visible;
  float start = nearerA ? a.x : b.x;
  float weight = ownWeight(ray, s, start, max(leading, start));
  sum += weight * visible;
  total += weight;
  return total > 0.0 ? sum / total : vec3(1.0);
}
