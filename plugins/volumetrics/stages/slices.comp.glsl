// One record per slice: its columns' span, its range of reference inclinations, its direction in the shadow map.
// Input: the epipolar frame (uniform). Output: Slice buffer.
// Spans: the ray from the axis in the slice's azimuth, cut by the convex region in which light can be blocked. Range of theta: the
// half-plane of the slice cut by the frustum's side planes, at the slice's middle and both borders. Projective maps have one
// span for all slices along e1. Spot and point lights: the angles at the light in which cone and range let light meet view rays, at the slice's
// middle and both borders.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "lib/local_row.glsl"
#include "lib/local_light.glsl"
#include "stages/rectified.h"

layout(local_size_x = 64) in;
layout(constant_id = 0) const int kReferenceRays = 1;
layout(binding = 0, scalar) uniform Frame { RectifiedBlock frame; };
layout(binding = 1, scalar) uniform Light { RectifiedLightBlock light; };
layout(binding = 2, scalar) buffer Slices { Slice slices[]; };

#include "stages/rows.glsl"
#include "stages/reference_rays.glsl"

const int kBisectrix = 0, kMean = 2;
const float kMostLookBack = 8.0;
const int kByTransmittance = 1;

// Inclinations of the frustum in the half-plane of a direction along (e1, e2).
vec2 thetaRange(vec2 direction) {
  vec2 interval = vec2(0.0, kPi);
  for (uint i = 0u; i < opaque(light.map.planeCount); ++i) {
    vec3 n = light.map.planes[i];
    interval = clipToFrustumPlane(interval, n.z, dot(n.xy, direction));
  }
  return interval;
}

// Angles at the light, rad, at which light rays of a slice meet view rays of inclinations in `theta`. Without a range up to pi - theta; a
// range cuts the light rays that pass it before they meet the view rays, which is the case at both ends of the interval of each view ray.
vec2 localSpan(vec2 direction, vec2 theta) {
  vec2 span = vec2(0.0, kPi - theta.x);
  if (opaque(light.local.kind) == kLocalSpot) {
    vec3 e = direction.x * light.map.e1 + direction.y * light.map.e2;
    vec3 normal = direction.x * light.map.e2 - direction.y * light.map.e1;
    vec2 cone = coneAngles(-dot(light.sun.towards, light.local.axis), dot(e, light.local.axis), dot(normal, light.local.axis),
                           light.local.cosOuter, light.local.sinOuter);
    span = vec2(max(span.x, cone.x), min(span.y, cone.y));
  }
  float range = opaque(light.local.range);
  if (range > 0.0 && range < light.distance) {
    // A chord of the range's sphere: psi = pi/2 - theta -+ acos(D sin(theta)/range), over the inclinations that meet the sphere.
    float most = asin(light.local.range / light.distance);
    vec2 met = vec2(theta.x, min(theta.y, most));
    vec2 chord = vec2(kPi, 0.0);
    for (int step_ = 0; step_ <= 16 && met.x <= met.y; ++step_) {
      float at = mix(met.x, met.y, float(step_) / 16.0);
      float half_ = acos(min(light.distance * sin(at) / light.local.range, 1.0));
      chord = vec2(min(chord.x, 0.5 * kPi - at - half_), max(chord.y, 0.5 * kPi - at + half_));
    }
    span = vec2(max(span.x, chord.x), min(span.y, chord.y));
  }
  return span;
}

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= light.map.slices) return;
  Slice record;
  record.direction = sliceDirection(float(i) + 0.5);
  record.perX = 1.0 / max(record.direction.x, 1e-6);

  vec2 theta = vec2(kPi, 0.0);
  for (int side = 0; side <= 2; ++side) {
    vec2 cut = thetaRange(sliceDirection(float(i) + 0.5 * float(side)));
    if (cut.y >= cut.x) theta = vec2(min(theta.x, cut.x), max(theta.y, cut.y));
  }
  if (theta.y < theta.x) theta = vec2(light.map.meanTheta);  // a slice that no pixel falls into
  vec2 span = opaque(light.map.polygonCount) > 0u ? vec2(0.0, 1e30) : vec2(1.0, 0.0);
  if (kLocal) {
    span = vec2(kPi, 0.0);
    for (int side = 0; side <= 2; ++side) {
      vec2 part = localSpan(sliceDirection(float(i) + 0.5 * float(side)), theta);
      if (part.y > part.x) span = vec2(min(span.x, part.x), max(span.y, part.y));
    }
  } else if (byTangent()) {
    if (opaque(light.map.polygonCount) > 0u) span = record.perX / vec2(light.map.inverse[0], light.map.inverse[light.map.splits]);
  } else {
    for (uint j = 0u; j < opaque(light.map.polygonCount); ++j) {
      vec3 halfPlane = light.map.polygon[j];
      span = clipToHalfPlane(span, dot(halfPlane.xy, record.direction), halfPlane.z);
    }
  }
  if (span.y <= span.x) span = vec2(0.0);
  record.first = span.x;
  record.last = span.y;

  if (kLocal) {
    vec2 ends = vec2(referencePosition(theta.x), referencePosition(theta.y));
    if (kReferenceRays == 1)
      ends = vec2(opaque(frame.rectified.reference_ray) == kBisectrix ? referencePosition(0.5 * (theta.x + theta.y))
                  : opaque(frame.rectified.reference_ray) == kMean    ? referencePosition(light.map.meanTheta)
                                                              : 0.5 * (ends.x + ends.y));
    record.nodeLow = ends.x;
    record.nodeHigh = ends.y;
  } else {
    float kappa = referenceKappa();
    float atLow = cosecant(theta.x);
    float atHigh = cosecant(theta.y);
    bool straddles = theta.x < 0.5 * kPi && theta.y > 0.5 * kPi;
    vec2 ends = vec2(straddles ? 1.0 : min(atLow, atHigh), max(atLow, atHigh));
    if (kReferenceRays == 1) {
      // Klehm's rays are those of the longest and the shortest path: the bisectrix lies between their inclinations.
      float farEnd = atLow > atHigh ? theta.x : theta.y;
      float nearEnd = straddles ? 0.5 * kPi : atLow > atHigh ? theta.y : theta.x;
      ends = vec2(opaque(frame.rectified.reference_ray) == kBisectrix ? cosecant(0.5 * (nearEnd + farEnd))
                  : opaque(frame.rectified.reference_ray) == kMean    ? cosecant(light.map.meanTheta)
                                                              : sqrt(ends.x * ends.y));  // Klehm et al. 2014, section 3.2
    }
    vec2 nodes = vec2(referenceCoordinate(ends.x, kappa), referenceCoordinate(ends.y, kappa));
    record.nodeLow = nodes.x;
    record.nodeHigh = nodes.y;
  }

  record.nearest = 1.0;
  if (!kLocal && !byTangent() && opaque(frame.rectified.column_spacing) == kByTransmittance) {
    float middle = referenceCosecant(0.5 * (record.nodeLow + record.nodeHigh), referenceKappa());
    record.nearest = nearestForTransmittance(frame.rays.sigma_t * middle * (span.y - span.x));
  }

  vec3 world = record.direction.x * light.map.e1 + record.direction.y * light.map.e2;
  record.shadowStep = light.sun.shadowX * world.x + light.sun.shadowY * world.y + light.sun.shadowZ * world.z;
  // A resampled blocker may stand as far off as one shadow texel; a rasterised one as far as half a column, to either side.
  float texelsAColumn = (kLocal ? 1.0 / light.local.texelAngle : length(record.shadowStep.xy)) * (span.y - span.x) * record.nearest / float(light.map.columns);
  record.lookBack = byTangent() ? 2.0 : 1.0 + clamp(ceil(1.0 / max(texelsAColumn, 1e-6)), 1.0, kMostLookBack - 1.0);
  slices[i] = record;
}
