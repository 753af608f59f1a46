// Single scattering of one light from the prefix of moments (Peters et al. 2017, sections 5.3 and 5.4).
// Inputs: scene depth (D32, reversed); Slice buffer; the prefix images of moments_prefix.comp; shadow map (epipole block). Output:
// RGBA32F as in ray_march.comp. The steps around it: stages/rays_on_rows.glsl and stages/prefix_lookup.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"
#include "lib/cube_map.glsl"
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "lib/local_row.glsl"
#include "lib/local_light.glsl"
#include "lib/moments.glsl"
#include "stages/rectified.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const int kMoments = 6;
layout(constant_id = 1) const int kReferenceRays = 1;
layout(constant_id = 2) const bool kQuantise = true;
layout(constant_id = 3) const bool kBounds = true;
layout(constant_id = 4) const bool kThreeAndThree = false;
layout(constant_id = 5) const int kRowFilter = 1;
layout(constant_id = 6) const bool kFirstLight = true;
layout(binding = 0, scalar) uniform Frame { RectifiedBlock frame; };
layout(binding = 1, scalar) uniform Light { RectifiedLightBlock light; };
layout(binding = 2) uniform sampler2D sceneDepth;
layout(binding = 3, scalar) readonly buffer Slices { Slice slices[]; };
layout(binding = 4) uniform sampler2DArray shadowMap;
layout(binding = 5, rgba32f) uniform image2D scatter;
layout(binding = 21) uniform sampler2DArray unshadowed;
layout(binding = 22) uniform sampler2DArray lit;
layout(binding = 6) uniform sampler2D bounds;          // nearest
layout(binding = 7) uniform sampler2DArray momentsA;   // linear filter
layout(binding = 8) uniform sampler2DArray momentsB;

#define TY_ROW_COOKIES
#include "stages/rays_on_rows.glsl"
#include "stages/prefix_lookup.glsl"

const int kLower = 0, kHalf = 1, kUpper = 2;

void visibilities(Place place, RowRay ray, out float v[kReferenceRays]) {
  float z = 2.0 * ray.depth - 1.0;
  float halfSine = sin(0.5 * ray.theta);
  float beta = opaque(frame.overestimation) == kLower ? 0.0
             : opaque(frame.overestimation) == kHalf  ? 0.5
             : opaque(frame.overestimation) == kUpper ? 1.0
                                              : halfSine * halfSine;  // section 5.3.1
  for (int k = 0; k < kReferenceRays; ++k) {
    vec4 first = lookUp(momentsA, place, float(k));
    if (kMoments == 4) {
      vec4 moments = kQuantise ? dequantise4(first) : first;
      v[k] = visibility4(bias4(moments, frame.momentBias, frame.biasTarget), z, beta);
      continue;
    }
    vec4 second = lookUp(momentsB, place, float(k));
    vec3 odd = first.xyz;
    vec3 even = kThreeAndThree ? second.xyz : vec3(first.w, second.xy);
    if (kQuantise) {
      odd = dequantise6Odd(odd);
      even = dequantise6Even(even);
    }
    v[k] = visibility6(bias6Odd(odd, frame.momentBias), bias6Even(even, frame.momentBias), z, beta);
  }
}
