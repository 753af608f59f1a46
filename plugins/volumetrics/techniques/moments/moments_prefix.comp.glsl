// Weighted prefix averages of moments along the rows of the rectified map (Peters et al. 2017, sections 5.1.1, 5.3, 5.4), for K
// reference inclinations, and the prefix minimum and maximum.
// Inputs: Slice buffer; rectified map (slices x columns). Outputs, slices x columns x K layers: four or six quantised (or, in
// 32-bit float, plain) moments; RG16: prefix minimum and maximum of the normalised inclination.
// Moments are made here from the rectified depth, not stored in between: without filtered resampling a texel holds one depth.
// Weights: exp(-u x) (1 - exp(-x)) with x = sigma_t * width of a column / sin(theta_k); kept as a running average, so that no
// precision is lost to large sums.
// Schemes: one invocation a slice; or 8x8 blocks (appendix C): eight invocations a slice, each of which forms all sums of its
// slice but stores only those of its own column in each block.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "lib/moments.glsl"
#include "stages/rectified.h"

layout(local_size_x_id = 10, local_size_y_id = 11) in;  // 32 x 1: row scheme; 8 x 8: block scheme
layout(constant_id = 0) const int kMoments = 6;
layout(constant_id = 1) const int kReferenceRays = 1;
layout(constant_id = 2) const bool kQuantise = true;
layout(constant_id = 3) const bool kBounds = true;
layout(constant_id = 4) const bool kThreeAndThree = false;  // 10-bit: three channels in each image
layout(binding = 0, scalar) uniform Frame { RectifiedBlock frame; };
layout(binding = 1, scalar) uniform Light { RectifiedSunBlock light; };
layout(binding = 2, scalar) readonly buffer Slices { Slice slices[]; };
layout(binding = 3) uniform sampler2D rectified;
layout(binding = 4) uniform writeonly image2DArray momentsA;  // four moments, or b1 b3 b5 (+ b2 at 16 and 32 bit)
layout(binding = 5) uniform writeonly image2DArray momentsB;  // b2 b4 b6 (10 bit), or b4 b6
layout(binding = 6) uniform writeonly image2D bounds;

const int kMaxRays = 6;
const int kWeightsTransmittance = 1;

void store(ivec3 at, vec3 odd, vec3 even) {
  if (kMoments == 4) {
    vec4 b = vec4(odd.x, even.x, odd.y, even.y);
    imageStore(momentsA, at, kQuantise ? quantise4(b) : b);
    return;
  }
  if (kQuantise) {
    odd = quantise6Odd(odd);
    even = quantise6Even(even);
  }
  if (kThreeAndThree) {
    imageStore(momentsA, at, vec4(odd, 0.0));
    imageStore(momentsB, at, vec4(even, 0.0));
  } else {
    imageStore(momentsA, at, vec4(odd, even.x));
    imageStore(momentsB, at, vec4(even.yz, 0.0, 0.0));
  }
}

void main() {
  uint slice = gl_GlobalInvocationID.x;
  if (slice >= light.epipolar.slices) return;
  Slice record = slices[slice];
  int columns = int(light.epipolar.columns);
  float width = (record.last - record.first) / float(columns);

  float falloff[kMaxRays];
  float power[kMaxRays];
  float total[kMaxRays];
  vec3 odd[kMaxRays];
  vec3 even[kMaxRays];
  for (int k = 0; k < kReferenceRays; ++k) {
    float node = mix(record.nodeLow, record.nodeHigh, 0.5 + 0.5 * chebyshevNode(k, kReferenceRays));
    float x = frame.rectified.weights == kWeightsTransmittance ? frame.rays.sigma_t * width * exp(-node) : 0.0;
    falloff[k] = exp(-x);
    power[k] = 1.0;
    total[k] = 0.0;
    odd[k] = vec3(0.0);
    even[k] = vec3(0.0);
  }
  float lowest = 1.0;
  float highest = 0.0;
  for (int column = 0; column < columns; ++column) {
    float depth = texelFetch(rectified, ivec2(slice, column), 0).x;
    lowest = min(lowest, depth);
    highest = max(highest, depth);
    float z = 2.0 * depth - 1.0;
    float z2 = z * z;
    vec3 newOdd = z * vec3(1.0, z2, z2 * z2);
    vec3 newEven = z2 * vec3(1.0, z2, z2 * z2);
    bool mine = uint(column) % gl_WorkGroupSize.y == gl_LocalInvocationID.y;
    for (int k = 0; k < kReferenceRays; ++k) {
      total[k] += power[k];
      float share = power[k] / total[k];
      power[k] *= falloff[k];
      odd[k] += (newOdd - odd[k]) * share;
      even[k] += (newEven - even[k]) * share;
      if (mine) store(ivec3(slice, column, k), odd[k], even[k]);
    }
    // Rounding to 16 bit is allowed for where they are read.
    if (kBounds && mine) imageStore(bounds, ivec2(slice, column), vec4(lowest, highest, 0.0, 0.0));
  }
}
