// The answer of fully lit rays where light rays differ: for every reference ray and colour the sum of the weights times strengths of the columns
// up to each, over that of the weights alone. Invocations share a row: each adds up a run of columns, takes what the runs before it have, and
// goes through its run again. A segment starts anew.
// Inputs: Slice buffer; the weights of stages/shine.comp.glsl. Output: RGBA16 unorm array, slices x columns, see stages/channels.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "lib/local_row.glsl"
#include "stages/rectified.h"

layout(local_size_x = 8, local_size_y = 16) in;
const int kRuns = 16;
layout(constant_id = 1) const int kReferenceRays = 1;
layout(binding = 0, scalar) uniform Frame { RectifiedBlock frame; };
layout(binding = 1, scalar) uniform Light { RectifiedLightBlock light; };
layout(binding = 2, scalar) readonly buffer Slices { Slice slices[]; };
layout(binding = 3) uniform sampler2DArray weights;
layout(binding = 4) uniform writeonly image2DArray lit;

#include "stages/rows.glsl"
#include "stages/reference_rays.glsl"
#include "stages/channels.glsl"

shared float runTotal[8 * kRuns * kReferenceRays];
shared vec4 runSum[8 * kRuns * kChannelQuads];

void main() {
  int slice = min(int(gl_GlobalInvocationID.x), int(light.map.slices) - 1);
  uint segment = gl_WorkGroupID.y;
  if (segment >= light.map.segmentCount) return;
  Slice s = slices[slice];
  uint begin = segmentBorder(s, segment);
  uint end = segmentBorder(s, segment + 1u);
  uint run = (end - begin + uint(kRuns) - 1u) / uint(kRuns);
  uint from = min(begin + gl_LocalInvocationID.y * run, end);
  uint to = min(from + run, end);
  float key[kReferenceRays];
  float total[kReferenceRays];
  vec4 sum[kChannelQuads];
  for (int k = 0; k < kReferenceRays; ++k) {
    key[k] = referenceKey(s, k, kReferenceRays);
    total[k] = 0.0;
  }
  for (int i = 0; i < kChannelQuads; ++i) sum[i] = vec4(0.0);
  for (uint column = from; column < to; ++column) {
    for (int k = 0; k < kReferenceRays; ++k) total[k] += referenceWeight(s, key[k], float(column), float(column + 1u));
    for (int i = 0; i < kChannelQuads; ++i) sum[i] += texelFetch(weights, ivec3(slice, column, i), 0);
  }
  uint own = gl_LocalInvocationIndex;
  for (int k = 0; k < kReferenceRays; ++k) runTotal[own * uint(kReferenceRays) + uint(k)] = total[k];
  for (int i = 0; i < kChannelQuads; ++i) runSum[own * uint(kChannelQuads) + uint(i)] = sum[i];
  barrier();
  for (int k = 0; k < kReferenceRays; ++k) total[k] = 0.0;
  for (int i = 0; i < kChannelQuads; ++i) sum[i] = vec4(0.0);
  for (uint other = gl_LocalInvocationID.x; other < own; other += 8u) {
    for (int k = 0; k < kReferenceRays; ++k) total[k] += runTotal[other * uint(kReferenceRays) + uint(k)];
    for (int i = 0; i < kChannelQuads; ++i) sum[i] += runSum[other * uint(kChannelQuads) + uint(i)];
  }
  if (gl_GlobalInvocationID.x >= light.map.slices) return;
  for (uint column = from; column < to; ++column) {
    for (int k = 0; k < kReferenceRays; ++k) total[k] += referenceWeight(s, key[k], float(column), float(column + 1u));
    for (int i = 0; i < kChannelQuads; ++i) {
      sum[i] += texelFetch(weights, ivec3(slice, column, i), 0);
      vec4 share;
      for (int c = 0; c < 4; ++c) {
        float all_ = total[min((4 * i + c) / kColours, kReferenceRays - 1)];
        share[c] = all_ > 0.0 ? sum[i][c] / all_ : 0.0;
      }
      imageStore(lit, ivec3(slice, column, i), share);
    }
  }
}
