// One record per slice: its columns' span, its range of reference inclinations, its direction in the shadow map.
// Input: the epipolar frame (uniform). Output: Slice buffer.
// Spans: the ray from the axis in the slice's azimuth, cut by the convex region in which light can be blocked. Range of theta: the
// half-plane of the slice cut by the frustum's side planes, at the slice's middle and both borders.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "stages/rectified.h"

layout(local_size_x = 64) in;
layout(constant_id = 0) const int kReferenceRays = 1;
layout(binding = 0, scalar) uniform Frame { RectifiedBlock frame; };
layout(binding = 1, scalar) uniform Light { RectifiedSunBlock light; };
layout(binding = 2, scalar) buffer Slices { Slice slices[]; };

const float kPi = 3.14159265358979;
const int kBisectrix = 0, kMean = 2;

vec2 thetaRange(float phi) {
  vec2 interval = vec2(0.0, kPi);
  float c = cos(phi);
  float s = sin(phi);
  for (uint i = 0u; i < light.epipolar.planeCount; ++i) {
    vec3 n = light.epipolar.planes[i];
    interval = clipToFrustumPlane(interval, n.z, n.x * c + n.y * s);
  }
  return interval;
}

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= light.epipolar.slices) return;
  float phi = light.epipolar.phiMin + (float(i) + 0.5) * light.epipolar.phiStep;
  vec2 direction = vec2(cos(phi), sin(phi));

  vec2 span = light.epipolar.polygonCount > 0u ? vec2(0.0, 1e30) : vec2(1.0, 0.0);
  for (uint j = 0u; j < light.epipolar.polygonCount; ++j) {
    vec3 halfPlane = light.epipolar.polygon[j];
    span = clipToHalfPlane(span, dot(halfPlane.xy, direction), halfPlane.z);
  }
  if (span.y <= span.x) span = vec2(0.0);

  vec2 theta = vec2(kPi, 0.0);
  for (int side = -1; side <= 1; ++side) {
    vec2 cut = thetaRange(phi + 0.5 * float(side) * light.epipolar.phiStep);
    if (cut.y >= cut.x) theta = vec2(min(theta.x, cut.x), max(theta.y, cut.y));
  }
  if (theta.y < theta.x) theta = vec2(light.epipolar.meanTheta);  // a slice that no pixel falls into
  float atLow = referenceCoordinate(theta.x);
  float atHigh = referenceCoordinate(theta.y);
  bool straddles = theta.x < 0.5 * kPi && theta.y > 0.5 * kPi;
  vec2 nodes = vec2(min(atLow, atHigh), straddles ? 0.0 : max(atLow, atHigh));
  if (kReferenceRays == 1) {
    if (frame.rectified.reference_ray == kBisectrix) nodes = vec2(referenceCoordinate(0.5 * (theta.x + theta.y)));
    if (frame.rectified.reference_ray == kMean) nodes = vec2(referenceCoordinate(light.epipolar.meanTheta));
  }

  vec3 world = direction.x * light.epipolar.e1 + direction.y * light.epipolar.e2;
  Slice record;
  record.first = span.x;
  record.last = span.y;
  record.nodeLow = nodes.x;
  record.nodeHigh = nodes.y;
  record.shadowStep = light.sun.shadowX * world.x + light.sun.shadowY * world.y + light.sun.shadowZ * world.z;
  record.unused_ = 0.0;
  slices[i] = record;
}
