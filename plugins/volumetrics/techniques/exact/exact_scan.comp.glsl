// Builds the wavelet matrix of a rectified row by one workgroup: what exact_build.comp does, with the row in shared memory, sums by subgroup
// scans, and sorting by stable splits, one bit of the depth's bin at a time. Inputs and outputs as there, without orders.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#include "lib/portable.h"
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "lib/wavelet.glsl"
#include "stages/rectified.h"
#include "techniques/exact/tree.glsl"

layout(local_size_x_id = 10) in;
layout(constant_id = 1) const int kReferenceRays = 1;
layout(constant_id = 3) const bool kBounds = true;
layout(constant_id = 10) const int kLanes = 32;
const bool kFiltered = false;
layout(binding = 0, scalar) uniform Frame { RectifiedBlock frame; };
layout(binding = 1, scalar) uniform Light { RectifiedSunBlock light; };
layout(binding = 2, scalar) readonly buffer Slices { Slice slices[]; };
layout(binding = 3) uniform sampler2DArray rectified;
layout(binding = 4) uniform sampler2DArray projective;
layout(binding = 5) uniform writeonly image2D bounds;
layout(binding = 6) uniform writeonly image2DArray levels;
layout(binding = 7) uniform writeonly image2D ranks;

#include "stages/rows.glsl"
#include "stages/reference_rays.glsl"
#include "stages/texel_depths.glsl"
#include "techniques/exact/weights.glsl"

const int kOwn = kElements / kLanes;  // elements of an invocation, neighbours
const int kSums = 1 + 2 * kReferenceRays;  // zeros; their weight and that of all, for each reference ray
const int kQuads = (kSums + 3) / 4;

shared uint element[kElements];
shared vec4 before[kLanes * kQuads];    // sums of all invocations before this one
shared vec4 partial[kLanes * kQuads];   // of whole subgroups
shared vec2 partialRange[kLanes];
shared uint zerosInRow;

// Stores the exclusive sums over the workgroup into before[]. Every invocation calls it; a barrier has to come before the next call.
void scanSums(vec4 own[kQuads]) {
  uint lane = gl_LocalInvocationIndex;
  vec4 sum[kQuads];
  for (int q = 0; q < kQuads; ++q) {
    sum[q] = subgroupExclusiveAdd(own[q]);
    vec4 all_ = subgroupAdd(own[q]);
    if (subgroupElect()) partial[gl_SubgroupID * uint(kQuads) + uint(q)] = all_;
  }
  barrier();
  for (uint i = 0u; i < gl_SubgroupID; ++i)
    for (int q = 0; q < kQuads; ++q) sum[q] += partial[i * uint(kQuads) + uint(q)];
  for (int q = 0; q < kQuads; ++q) before[lane * uint(kQuads) + uint(q)] = sum[q];
  barrier();
}

// Prefix minimum and maximum of the row's depths.
void storeBounds(int slice, int first, float depth[kOwn]) {
  vec2 range = vec2(1.0, 0.0);
  for (int i = 0; i < kOwn; ++i) range = vec2(min(range.x, depth[i]), max(range.y, depth[i]));
  vec2 all_ = vec2(subgroupMin(range.x), subgroupMax(range.y));
  vec2 earlier = vec2(subgroupExclusiveMin(range.x), subgroupExclusiveMax(range.y));
  if (gl_SubgroupInvocationID == 0u) earlier = vec2(1.0, 0.0);
  if (subgroupElect()) partialRange[gl_SubgroupID] = all_;
  barrier();
  for (uint i = 0u; i < gl_SubgroupID; ++i) earlier = vec2(min(earlier.x, partialRange[i].x), max(earlier.y, partialRange[i].y));
  int columns = int(totalColumns());
  for (int i = 0; i < kOwn && first + i < columns; ++i) {
    earlier = vec2(min(earlier.x, depth[i]), max(earlier.y, depth[i]));
    imageStore(bounds, ivec2(slice, first + i), vec4(earlier, 0.0, 0.0));
  }
}

// Puts the elements whose bit is 0 before the others, each half in its order.
void split(uint own[kOwn], int shift) {
  uint lane = gl_LocalInvocationIndex;
  int zeros = 0;
  for (int i = 0; i < kOwn; ++i) zeros += (own[i] >> shift & 1u) == 0u ? 1 : 0;
  vec4 sums[kQuads];
  for (int q = 0; q < kQuads; ++q) sums[q] = vec4(0.0);
  sums[0].x = float(zeros);
  scanSums(sums);
  int earlier = int(before[lane * uint(kQuads)].x);
  if (lane == uint(kLanes - 1)) zerosInRow = uint(earlier + zeros);
  barrier();
  int ones = int(zerosInRow) + int(lane) * kOwn - earlier;
  for (int i = 0; i < kOwn; ++i) {
    if ((own[i] >> shift & 1u) == 0u)
      element[earlier++] = own[i];
    else
      element[ones++] = own[i];
  }
  barrier();
}

void main() {
  int slice = int(gl_WorkGroupID.x);
  int columns = int(totalColumns());
  int first = int(gl_LocalInvocationIndex) * kOwn;
  Slice s = slices[slice];

  uint own[kOwn];
  float depth[kOwn];
  for (int i = 0; i < kOwn; ++i) {
    depth[i] = first + i < columns ? texelDepths(ivec2(slice, min(first + i, columns - 1))).x : 1.0;
    own[i] = uint(first + i < columns ? waveletBin(depth[i], kBinBits) : kBins) << 16 | uint(first + i);
  }
  if (kBounds) storeBounds(slice, first, depth);
  for (int bit = 0; bit <= kBinBits; ++bit) {
    if (bit > 0)
      for (int i = 0; i < kOwn; ++i) own[i] = element[first + i];
    split(own, 16 + bit);
  }
  for (int b = int(gl_LocalInvocationIndex); b <= kBins; b += kLanes) {
    int low = 0;
    for (int step_ = kElements; step_ > 0; step_ >>= 1)
      if (low + step_ <= kElements && int(element[low + step_ - 1] >> 16) < b) low += step_;
    imageStore(ranks, ivec2(slice, b), vec4(float(low) / kCountScale));
  }
  for (int i = 0; i < kOwn; ++i) own[i] = element[first + i];
  barrier();
  for (int i = 0; i < kOwn; ++i) element[own[i] & 0xffffu] = uint(first + i) << 16 | (own[i] & 0xffffu);
  barrier();

  float falloff[kReferenceRays];
  setFalloff(s, falloff);
  for (int level = 0; level < kLevels; ++level) {
    int size = kElements >> level;
    vec4 sums[kQuads];
    for (int q = 0; q < kQuads; ++q) sums[q] = vec4(0.0);
    for (int i = 0; i < kOwn; ++i) {
      own[i] = element[first + i];
      bool one = waveletOne(int(own[i] >> 16), level, kBits);
      sums[0].x += one ? 0.0 : 1.0;
      for (int k = 0; k < kReferenceRays; ++k) {
        float weight = columnWeight(s, falloff[k], int(own[i] & 0xffffu));
        sums[(2 * k + 1) / 4][(2 * k + 1) % 4] += one ? 0.0 : weight;
        sums[(2 * k + 2) / 4][(2 * k + 2) % 4] += weight;
      }
    }
    scanSums(sums);
    // Sums since the start of the node that this invocation begins in.
    int start = first & ~(size - 1);
    vec4 sinceStart[kQuads];
    for (int q = 0; q < kQuads; ++q)
      sinceStart[q] = before[gl_LocalInvocationIndex * uint(kQuads) + uint(q)] - before[(start / kOwn) * kQuads + q];
    int zeros = int(sinceStart[0].x);
    float ofZeros[kReferenceRays];
    float ofAll[kReferenceRays];
    for (int k = 0; k < kReferenceRays; ++k) {
      ofZeros[k] = max(sinceStart[(2 * k + 1) / 4][(2 * k + 1) % 4], 0.0);
      ofAll[k] = max(sinceStart[(2 * k + 2) / 4][(2 * k + 2) % 4], 0.0);
    }
    for (int i = 0; i < kOwn; ++i) {
      int at = first + i;
      if ((at & (size - 1)) == 0) {  // a node begins
        start = at;
        zeros = 0;
        for (int k = 0; k < kReferenceRays; ++k) {
          ofZeros[k] = 0.0;
          ofAll[k] = 0.0;
        }
      }
      bool one = waveletOne(int(own[i] >> 16), level, kBits);
      element[start + (one ? size / 2 + at - start - zeros : zeros)] = own[i];
      zeros += one ? 0 : 1;
      vec4 texel[kVectors];
      texel[0].x = float(zeros) / kCountScale;
      for (int k = 0; k < kReferenceRays; ++k) {
        float weight = columnWeight(s, falloff[k], int(own[i] & 0xffffu));
        ofAll[k] += weight;
        ofZeros[k] += one ? 0.0 : weight;
        texel[(k + 1) / 4][(k + 1) % 4] = waveletShare(ofZeros[k], ofAll[k]);
      }
      for (int v = 0; v < kVectors; ++v) imageStore(levels, ivec3(slice, at, level * kVectors + v), texel[v]);
    }
    barrier();
  }
}
