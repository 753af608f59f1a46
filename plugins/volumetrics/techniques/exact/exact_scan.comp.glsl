// Builds the wavelet matrix of a rectified row by one workgroup: what exact_build.comp does, with the row in shared memory and sums by subgroup
// scans. Inputs and outputs as there, without `order`.
// Sorting: stable four-way splits by two bits of the depth's bin at a time: as long for every row. Once a node is no larger than what a
// subgroup holds, subgroups need not wait for each other.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#include "lib/portable.h"
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "lib/local_row.glsl"
#include "lib/local_light.glsl"
#include "lib/wavelet.glsl"
#include "stages/rectified.h"
#include "techniques/exact/tree.glsl"

layout(local_size_x_id = 10) in;
layout(constant_id = 1) const int kReferenceRays = 1;
layout(constant_id = 3) const bool kBounds = true;
layout(constant_id = 10) const int kLanes = 32;      // whole subgroups
layout(constant_id = 26) const int kStaged = 1;      // texels, packed to 16 bit, that wait in shared memory to be stored side by side; 1: none
const bool kFiltered = false;
layout(binding = 0, scalar) uniform Frame { RectifiedBlock frame; };
layout(binding = 1, scalar) uniform Light { RectifiedLightBlock light; };
layout(binding = 2, scalar) readonly buffer Slices { Slice slices[]; };
layout(binding = 3) uniform sampler2DArray rectified;
layout(binding = 4) uniform sampler2DArray projective;
layout(binding = 5) uniform writeonly image2D bounds;
layout(binding = 6) uniform writeonly image2DArray levels;
layout(binding = 7) uniform writeonly image2D ranks;
layout(binding = 20) uniform sampler2DArray columnWeights;  // kShaped

#include "stages/rows.glsl"
#include "stages/reference_rays.glsl"
#include "stages/texel_depths.glsl"
#include "stages/channels.glsl"
#include "techniques/exact/weights.glsl"

const int kOwn = kElements / kLanes;       // elements of an invocation, neighbours
const int kSums = 1 + 2 * kChannels;  // zeros; their weight and that of all, in each channel
const int kQuads = (kSums + 3) / 4;

shared uint element[kElements + kElements / kOwn];
shared vec4 before[kLanes * kQuads];   // sums of all invocations before this one, or of those of the subgroup
shared vec4 partial[kLanes * kQuads];  // of whole subgroups
shared uvec2 counted[kLanes];          // the same for two pairs of 16-bit counts
shared uvec2 staged[kStaged > 1 ? kStaged + kStaged / kOwn : 1];

// Place of an element in shared memory: neighbouring invocations, kOwn elements apart, must not meet in a bank.
int padded(int i) { return i + i / kOwn; }

uint lane() { return gl_SubgroupID * gl_SubgroupSize + gl_SubgroupInvocationID; }

// Waits for the workgroup, or for the subgroup alone.
void wait(bool wide) {
  if (wide)
    barrier();
  else
    subgroupBarrier();
}

// Stores the exclusive sums over the workgroup, or over the subgroup, into before[]; they hold until the next call.
void scanSums(vec4 own[kQuads], bool wide) {
  vec4 sum[kQuads];
  for (int q = 0; q < kQuads; ++q) sum[q] = subgroupInclusiveAdd(own[q]);
  if (wide) {
    if (gl_SubgroupInvocationID == gl_SubgroupSize - 1u)
      for (int q = 0; q < kQuads; ++q) partial[gl_SubgroupID * uint(kQuads) + uint(q)] = sum[q];
    barrier();
    for (uint i = 0u; i < gl_SubgroupID; ++i)
      for (int q = 0; q < kQuads; ++q) sum[q] += partial[i * uint(kQuads) + uint(q)];
  }
  for (int q = 0; q < kQuads; ++q) before[lane() * uint(kQuads) + uint(q)] = sum[q] - own[q];
  wait(wide);
}

// Prefix minimum and maximum of the row's depths.
void storeBounds(int slice, int first, float depth[kOwn]) {
  vec2 range = vec2(1.0, 0.0);
  for (int i = 0; i < kOwn; ++i) range = vec2(min(range.x, depth[i]), max(range.y, depth[i]));
  vec2 inclusive = vec2(subgroupInclusiveMin(range.x), subgroupInclusiveMax(range.y));
  before[lane() * uint(kQuads)].xy = inclusive;
  barrier();
  vec2 earlier = gl_SubgroupInvocationID > 0u ? before[(lane() - 1u) * uint(kQuads)].xy : vec2(1.0, 0.0);
  for (uint i = 0u; i < gl_SubgroupID; ++i) {
    vec2 other = before[((i + 1u) * gl_SubgroupSize - 1u) * uint(kQuads)].xy;
    earlier = vec2(min(earlier.x, other.x), max(earlier.y, other.y));
  }
  int columns = int(totalColumns());
  for (int i = 0; i < kOwn && first + i < columns; ++i) {
    earlier = vec2(min(earlier.x, depth[i]), max(earlier.y, depth[i]));
    imageStore(bounds, ivec2(slice, first + i), vec4(earlier, 0.0, 0.0));
  }
  barrier();
}

// Leaves rank << 16 | column in element[], in the order of columns, and stores how many depths lie in bins before each.
void sortRow(int slice, int first, int bin[kOwn]) {
  for (int i = 0; i < kOwn; ++i) element[padded(first + i)] = uint(bin[i]) << 16 | uint(first + i);
  for (int bit = 0; bit <= kBinBits; bit += 2) {
    uint own[kOwn];
    uvec2 counts = uvec2(0u);  // of digits 0 and 1, 2 and 3
    for (int i = 0; i < kOwn; ++i) {
      own[i] = element[padded(first + i)];
      uint digit = own[i] >> (16 + bit) & 3u;
      uint one = 1u << (16u * (digit & 1u));
      counts += digit < 2u ? uvec2(one, 0u) : uvec2(0u, one);
    }
    uvec2 upTo = subgroupInclusiveAdd(counts);
    if (gl_SubgroupInvocationID == gl_SubgroupSize - 1u) counted[gl_SubgroupID] = upTo;
    barrier();
    uvec2 earlier = upTo - counts;
    uvec2 all_ = uvec2(0u);
    for (uint i = 0u; i < gl_NumSubgroups; ++i) {
      if (i < gl_SubgroupID) earlier += counted[i];
      all_ += counted[i];
    }
    // Where the next element of each digit goes.
    uint zero = earlier.x & 0xffffu;
    uint one = (all_.x & 0xffffu) + (earlier.x >> 16);
    uint two = (all_.x & 0xffffu) + (all_.x >> 16) + (earlier.y & 0xffffu);
    uint three = (all_.x & 0xffffu) + (all_.x >> 16) + (all_.y & 0xffffu) + (earlier.y >> 16);
    for (int i = 0; i < kOwn; ++i) {
      uint digit = own[i] >> (16 + bit) & 3u;
      uint to = digit == 0u ? zero++ : digit == 1u ? one++ : digit == 2u ? two++ : three++;
      element[padded(int(to))] = own[i];
    }
    barrier();
  }
  for (int b = int(lane()); b <= kBins; b += kLanes) {
    int low = 0;
    for (int step_ = kElements; step_ > 0; step_ >>= 1)
      if (low + step_ <= kElements && int(element[padded(low + step_ - 1)] >> 16) < b) low += step_;
    imageStore(ranks, ivec2(slice, b), vec4(float(low) / kCountScale));
  }
  uint own[kOwn];
  for (int i = 0; i < kOwn; ++i) own[i] = element[padded(first + i)];
  barrier();
  for (int i = 0; i < kOwn; ++i) element[padded(int(own[i] & 0xffffu))] = uint(first + i) << 16 | (own[i] & 0xffffu);
  barrier();
}

void main() {
  int slice = int(gl_WorkGroupID.x);
  int columns = int(totalColumns());
  int first = int(lane()) * kOwn;
  int heldBySubgroup = int(gl_SubgroupSize) * kOwn;
  Slice s = slices[slice];

  float depth[kOwn];
  int bin[kOwn];
  for (int i = 0; i < kOwn; ++i) {
    depth[i] = first + i < columns ? texelDepths(ivec2(slice, min(first + i, columns - 1))).x : 1.0;
    bin[i] = first + i < columns ? waveletBin(depth[i], kBinBits) : kBins;
  }
  if (kBounds) storeBounds(slice, first, depth);
  sortRow(slice, first, bin);

  Falloff falloff[kReferenceRays];
  float growth;
  setFalloff(s, falloff, growth);
  uint own[kOwn];
  for (int level = 0; level < kLevels; ++level) {
    int size = kElements >> level;
    bool wide = size > heldBySubgroup;
    // Weights of own elements, channel by channel.
    float weight[kOwn * kChannels];
    for (int i = 0; i < kOwn; ++i) {
      own[i] = element[padded(first + i)];
      float four[kChannelSlots];
      columnWeight(slice, s, falloff, growth, int(own[i] & 0xffffu), four);
      for (int k = 0; k < kChannels; ++k) weight[i * kChannels + k] = four[k];
    }
    int start = first;
    int zeros = 0;
    float ofZeros[kChannels];
    float ofAll[kChannels];
    for (int k = 0; k < kChannels; ++k) {
      ofZeros[k] = 0.0;
      ofAll[k] = 0.0;
    }
    if (size > kOwn) {
      vec4 sums[kQuads];
      for (int q = 0; q < kQuads; ++q) sums[q] = vec4(0.0);
      for (int i = 0; i < kOwn; ++i) {
        bool one = waveletOne(int(own[i] >> 16), level, kBits);
        sums[0].x += one ? 0.0 : 1.0;
        for (int k = 0; k < kChannels; ++k) {
          float own_ = weight[i * kChannels + k];
          sums[(2 * k + 1) / 4][(2 * k + 1) % 4] += one ? 0.0 : own_;
          sums[(2 * k + 2) / 4][(2 * k + 2) % 4] += own_;
        }
      }
      scanSums(sums, wide);
      // Sums since the start of the node.
      start = first & ~(size - 1);
      vec4 since[kQuads];
      for (int q = 0; q < kQuads; ++q)
        since[q] = max(before[lane() * uint(kQuads) + uint(q)] - before[(start / kOwn) * kQuads + q], vec4(0.0));
      zeros = int(since[0].x);
      for (int k = 0; k < kChannels; ++k) {
        ofZeros[k] = since[(2 * k + 1) / 4][(2 * k + 1) % 4];
        ofAll[k] = since[(2 * k + 2) / 4][(2 * k + 2) % 4];
      }
    }
    for (int i = 0; i < kOwn; ++i) {
      int at = first + i;
      if ((at & (size - 1)) == 0) {  // a node begins
        start = at;
        zeros = 0;
        for (int k = 0; k < kChannels; ++k) {
          ofZeros[k] = 0.0;
          ofAll[k] = 0.0;
        }
      }
      bool one = waveletOne(int(own[i] >> 16), level, kBits);
      element[padded(start + (one ? size / 2 + at - start - zeros : zeros))] = own[i];
      zeros += one ? 0 : 1;
      vec4 texel[kVectors];
      texel[0].x = float(zeros) / kCountScale;
      for (int k = 0; k < kChannels; ++k) {
        float own_ = weight[i * kChannels + k];
        ofAll[k] += own_;
        ofZeros[k] += one ? 0.0 : own_;
        texel[(k + 1) / 4][(k + 1) % 4] = waveletShare(ofZeros[k], ofAll[k]);
      }
      for (int v = 0; v < kVectors; ++v) {
        if (kStaged > 1)
          staged[kStaged > 1 ? padded(at * kVectors + v) : 0] = uvec2(packUnorm2x16(texel[v].xy), packUnorm2x16(texel[v].zw));
        else
          imageStore(levels, levelTexel(slice, at, level * kVectors + v), texel[v]);
      }
    }
    wait(wide);
    if (kStaged > 1) {
      int base = int(gl_SubgroupID) * heldBySubgroup;
      for (int i = int(gl_SubgroupInvocationID); i < heldBySubgroup; i += int(gl_SubgroupSize))
        for (int v = 0; v < kVectors; ++v) {
          uvec2 packed = staged[kStaged > 1 ? padded((base + i) * kVectors + v) : 0];
          imageStore(levels, levelTexel(slice, base + i, level * kVectors + v), vec4(unpackUnorm2x16(packed.x), unpackUnorm2x16(packed.y)));
        }
      wait(false);
    }
  }
}
