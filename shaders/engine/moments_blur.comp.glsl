// One direction of the Gaussian that filters a four-moment shadow map (Peters et al. 2017, "Improved Moment Shadow Maps for
// Translucent Occluders, Soft Shadows and Single Scattering", sections 2.3, 2.4, appendix D.1 and D.2). The first, along rows,
// also turns depths into moments.
// In: shadow map (D32, 0 nearest the light), or the result along rows. Out: RGBA16 unorm, quantised (equation 3), or RGBA32F:
// means of z, z^2, z^3, z^4 of the linear depth z in [-1, 1]. One layer a face; at a face's border the last texel goes on.
// Each invocation makes four texels in a row, because they share most of their twelve inputs.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/portable.h"
#include "lib/moments.glsl"
#include "engine/include/linear_depth.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const bool FROM_DEPTH = true;  // along rows, from depths; else along columns, from moments
layout(constant_id = 1) const bool QUANTISE = true;
layout(push_constant) uniform Push { float depthCurve; };  // LightBlock.depthCurve
layout(binding = 0) uniform sampler2DArray source;
layout(binding = 1) uniform writeonly image2DArray moments;

// Nine taps of a Gaussian with a standard deviation of 1.5 texels, which end where it has fallen to 3 percent; they add up to 1.
const int kRadius = 4;
const int kRun = 4;

vec4 momentsAt(ivec3 at) {
  if (!FROM_DEPTH) return texelFetch(source, at, 0);
  float z = 2.0 * linearDepth(texelFetch(source, at, 0).x, depthCurve) - 1.0;
  float z2 = z * z;
  return vec4(z, z2, z * z2, z2 * z2);
}

float weight(int offset) {
  int o = abs(offset);
  if (o < 2) return o == 0 ? 0.26655997 : 0.21344454;
  if (o < 4) return o == 2 ? 0.10958608 : 0.03607497;
  return o == kRadius ? 0.00761442 : 0.0;
}

void store(ivec3 at, vec4 b) { imageStore(moments, at, FROM_DEPTH && QUANTISE ? quantise4(b) : b); }

void main() {
  // Component by component: Mesa 22.3 selects vectors by a specialization constant wrongly where all of it is constant.
  ivec2 along = ivec2(FROM_DEPTH ? 1 : 0, FROM_DEPTH ? 0 : 1);
  ivec2 size = textureSize(source, 0).xy;
  ivec2 first = ivec2(gl_GlobalInvocationID.xy) * (1 + (kRun - 1) * along);
  int layer = int(gl_GlobalInvocationID.z);
  if (any(greaterThanEqual(first, size))) return;
  vec4 sum0 = vec4(0.0), sum1 = vec4(0.0), sum2 = vec4(0.0), sum3 = vec4(0.0);
  for (int i = -kRadius; i < kRun + kRadius; ++i) {
    vec4 b = momentsAt(ivec3(clamp(first + i * along, ivec2(0), size - 1), layer));
    sum0 += weight(i) * b;
    sum1 += weight(i - 1) * b;
    sum2 += weight(i - 2) * b;
    sum3 += weight(i - 3) * b;
  }
  // Stores beyond the image are dropped.
  store(ivec3(first, layer), sum0);
  store(ivec3(first + along, layer), sum1);
  store(ivec3(first + 2 * along, layer), sum2);
  store(ivec3(first + 3 * along, layer), sum3);
}
