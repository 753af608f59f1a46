// Prefix averages of four or six moments (Peters et al. 2017, sections 2.4, 5.3, 5.4 and appendix C).
// Inputs: Slice buffer; rectified maps (stages/prefix.glsl). Outputs, slices x columns, one layer a reference ray: the moments of
// the depth in [-1, 1], quantised where stored as unorm; prefix bounds RG16.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "lib/local_row.glsl"
#include "lib/local_light.glsl"
#include "lib/moments.glsl"
#include "stages/rectified.h"

layout(constant_id = 0) const int kMoments = 6;
layout(constant_id = 2) const bool kQuantise = true;
layout(constant_id = 4) const bool kThreeAndThree = false;  // 10-bit: three channels in each image
layout(binding = 6) uniform writeonly image2DArray momentsA;  // four moments, or b1 b3 b5 (+ b2 at 16 and 32 bit)
layout(binding = 7) uniform writeonly image2DArray momentsB;  // b2 b4 b6 (10 bit), or b4 b6

const int kVectors = kMoments == 4 ? 1 : 2;

#include "stages/prefix.glsl"

void basisAt(ivec2 at, float depth, int group, out vec4 v[kVectors]) {
  float z = 2.0 * depth - 1.0;
  float z2 = z * z;
  if (kMoments == 4) {
    v[0] = vec4(z, z2, z * z2, z2 * z2);
  } else {
    v[0] = vec4(z * vec3(1.0, z2, z2 * z2), 0.0);
    v[kVectors - 1] = vec4(z2 * vec3(1.0, z2, z2 * z2), 0.0);
  }
}

void storePrefix(ivec2 at, int k, int group, vec4 v[kVectors]) {
  ivec3 texel = ivec3(at, k);
  if (kMoments == 4) {
    imageStore(momentsA, texel, kQuantise ? quantise4(v[0]) : v[0]);
    return;
  }
  vec3 odd = v[0].xyz;
  vec3 even = v[kVectors - 1].xyz;
  if (kQuantise) {
    odd = quantise6Odd(odd);
    even = quantise6Even(even);
  }
  if (kThreeAndThree) {
    imageStore(momentsA, texel, vec4(odd, 0.0));
    imageStore(momentsB, texel, vec4(even, 0.0));
  } else {
    imageStore(momentsA, texel, vec4(odd, even.x));
    imageStore(momentsB, texel, vec4(even.yz, 0.0, 0.0));
  }
}
