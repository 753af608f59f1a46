// What the rows make of each pixel: R slice coordinate over the number of slices, G inclination over pi, B error of the reference rays,
// A mean visibility of the nearest row. The error is that of the weights alone: the row's own visibility, texel by texel, averaged
// with the weights of the reference rays and interpolated, against averaged with the weights of the ray itself.
// Inputs: scene depth; Slice buffer; rectified maps. Output: RGBA32F.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"
#include "lib/cube_map.glsl"
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "lib/local_row.glsl"
#include "lib/local_light.glsl"
#include "stages/rectified.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 1) const int kReferenceRays = 1;
layout(constant_id = 8) const bool kFiltered = false;
const int kRowFilter = 0;
const bool kFirstLight = true;
layout(binding = 0, scalar) uniform Frame { RectifiedBlock frame; };
layout(binding = 1, scalar) uniform Light { RectifiedLightBlock light; };
layout(binding = 2) uniform sampler2D sceneDepth;
layout(binding = 3, scalar) readonly buffer Slices { Slice slices[]; };
layout(binding = 4) uniform sampler2DArray shadowMap;
layout(binding = 5, rgba32f) uniform image2D scatter;
layout(binding = 6) uniform sampler2DArray rectified;
layout(binding = 7) uniform sampler2DArray projective;
layout(binding = 21) uniform sampler2DArray unshadowed;

#define TY_OWN_MAIN
#include "stages/rays_on_rows.glsl"
#include "stages/reference_rays.glsl"
#include "stages/row_weights.glsl"
#include "stages/texel_depths.glsl"

vec3 meanVisibility(RowRay ray) { return vec3(1.0); }

// The true weight of columns along the ray, whatever weights the prefix has.
float rayWeight(RowRay ray, Slice s, float from, float to) {
  float a = columnDistance(s, from);
  float b = columnDistance(s, to);
  if (kLocal) return max(unshadowedTo(ray.theta, b) - unshadowedTo(ray.theta, a), 0.0);
  float safeSine = max(ray.sine, 1e-7);
  return transmittanceIntegral(frame.rays.sigma_t, a / safeSine, b / safeSine);
}

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(pixel, uvec2(imageSize(scatter))))) return;
  vec3 direction = rayDirection(frame.rays, pixel);
  float perAxial = length(direction);
  direction /= perAxial;
  float end = perAxial * axialDistance(frame.rays, texelFetch(sceneDepth, ivec2(pixel), 0).x);
  vec3 local = vec3(dot(direction, light.map.e1), dot(direction, light.map.e2), dot(direction, light.sun.towards));
  RowRay ray = rowRay(local, end, false);
  Slice s = ray.a.s;

  // Segment by segment, as the look-up does: interpolated between the reference rays, joined with the ray's own weights.
  float ownLit = 0.0;
  float ownAll = 0.0;
  float joined = 0.0;
  float joinedAll = 0.0;
  for (uint i = 0u; i < opaque(light.map.segmentCount) && float(segmentBorder(s, i)) < ray.a.column; ++i) {
    float first = float(segmentBorder(s, i));
    float lit[kReferenceRays];
    float all_[kReferenceRays];
    for (int k = 0; k < kReferenceRays; ++k) {
      lit[k] = 0.0;
      all_[k] = 0.0;
    }
    float segmentAll = 0.0;
    float last = min(float(segmentBorder(s, i + 1u)), ray.a.column);
    for (int column = int(first); float(column) < last; ++column) {
      vec3 depths = texelDepths(ivec2(ray.a.index, column));
      float visible = mix(ray.depth <= depths.x ? 1.0 : 0.0, ray.depth <= depths.y ? 1.0 : 0.0, depths.z);
      float to = min(float(column + 1), last);
      float weight = rayWeight(ray, s, float(column), to);
      ownLit += visible * weight;
      segmentAll += weight;
      for (int k = 0; k < kReferenceRays; ++k) {
        weight = referenceWeight(s, referenceKey(s, k, kReferenceRays), float(column), to);
        lit[k] += visible * weight;
        all_[k] += weight;
      }
    }
    float share[kReferenceRays];
    referenceShares(s.nodeLow, s.nodeHigh, ray.theta, columnDistance(s, last) - columnDistance(s, first), share);
    float interpolated = 0.0;
    for (int k = 0; k < kReferenceRays; ++k)
      interpolated += share[k] * (all_[k] > 0.0 ? lit[k] / all_[k] : 1.0);
    float weight = ownWeight(ray, s, first, last);
    joined += weight * clamp(interpolated, 0.0, 1.0);
    joinedAll += weight;
    ownAll += segmentAll;
  }
  float own = ownAll > 0.0 ? ownLit / ownAll : 1.0;
  float shown = joinedAll > 0.0 ? joined / joinedAll : 1.0;
  imageStore(scatter, ivec2(pixel), vec4(ray.slice / float(light.map.slices), ray.theta / kPi, abs(shown - own), own));
}
