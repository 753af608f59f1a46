// What order_build.comp does, by one workgroup a row, with the row in shared memory. No sum of weights is needed and ties may come in any order, so
// bins are counted and filled by shared atomics, and everything else is bits.
// Steps: 1 count the columns of each bin; 2 sum up the bins, which is the table of ranks; 3 put each column where its bin says; 4 planes of block
// numbers; 5 counts of each record, and 6 of all records before it; 7 the rank of each column in its block; 8 store.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#include "lib/portable.h"
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "lib/wavelet.glsl"
#include "lib/depth_order.glsl"
#include "stages/rectified.h"

layout(local_size_x_id = 10) in;
layout(constant_id = 10) const int kLanes = 32;  // whole subgroups
const bool kFiltered = false;
layout(binding = 1, scalar) uniform Light { RectifiedLightBlock light; };
layout(binding = 3) uniform sampler2DArray rectified;
layout(binding = 4) uniform sampler2DArray projective;
layout(binding = 5) uniform writeonly uimage2D order;
layout(binding = 6) uniform writeonly uimage2D places;
layout(binding = 7) uniform writeonly image2D ranks;

#include "stages/rows.glsl"
#include "stages/texel_depths.glsl"
#include "techniques/exact/order_rows.glsl"

const int kRecords = kElements / 32;
const int kOwnBins = (kBins + kLanes) / kLanes;  // of kBins + 1, neighbours

shared uint bins[kBins + 1];
shared uint element[kElements];
shared uint blockPlane[kRecords * kBlockBits];
shared uint recordCount[kRecords * kCountWords];
shared uint placePlane[kRecords * kPlaceBits + 1];
shared uint ofSubgroup[kLanes];

// Elements of a record whose block has this number.
uint inBlock(int record, uint block) {
  uint m = 0xffffffffu;
  for (int j = 0; j < kBlockBits; ++j) m &= planeWhere(blockPlane[record * kBlockBits + j], block >> uint(j));
  return m;
}

void main() {
  int slice = int(gl_WorkGroupID.x);
  int lane = int(gl_SubgroupID * gl_SubgroupSize + gl_SubgroupInvocationID);
  int columns = int(totalColumns());
  int records = (columns + 31) / 32;
  uint shift = uint(rowShift());

  for (int i = lane; i <= kBins; i += kLanes) bins[i] = 0u;
  for (int i = lane; i < kRecords * kBlockBits; i += kLanes) blockPlane[i] = 0u;
  for (int i = lane; i < kRecords * kPlaceBits; i += kLanes) placePlane[i] = 0u;
  barrier();
  // 1
  for (int column = lane; column < columns; column += kLanes)
    atomicAdd(bins[waveletBin(texelDepths(ivec2(slice, column)).x, kBinBits)], 1u);
  barrier();
  // 2
  uint own = 0u;
  for (int i = 0; i < kOwnBins; ++i) own += lane * kOwnBins + i <= kBins ? bins[lane * kOwnBins + i] : 0u;
  uint before = subgroupExclusiveAdd(own);
  if (gl_SubgroupInvocationID == gl_SubgroupSize - 1u) ofSubgroup[gl_SubgroupID] = before + own;
  barrier();
  for (uint i = 0u; i < gl_SubgroupID; ++i) before += ofSubgroup[i];
  for (int i = 0; i < kOwnBins; ++i) {
    int b = lane * kOwnBins + i;
    if (b > kBins) break;
    uint count = bins[b];
    bins[b] = before;
    imageStore(ranks, ivec2(slice, b), vec4(float(before) / kCountScale));
    before += count;
  }
  barrier();
  // 3
  for (int column = lane; column < columns; column += kLanes)
    element[atomicAdd(bins[waveletBin(texelDepths(ivec2(slice, column)).x, kBinBits)], 1u)] = uint(column);
  barrier();
  // 4
  for (int i = lane; i < columns; i += kLanes) {
    uint block = element[i] >> shift;
    for (int j = 0; j < kBlockBits; ++j)
      if ((block >> uint(j) & 1u) != 0u) atomicOr(blockPlane[(i >> 5) * kBlockBits + j], 1u << uint(i & 31));
  }
  barrier();
  // 5
  const int perWord = 32 / kCountBits;
  for (int i = lane; i < records * kCountWords; i += kLanes) {
    int record = i / kCountWords, word = i % kCountWords;
    uint present = lowBits(min(columns - 32 * record, 32));
    uint packed = 0u;
    for (int j = 0; j < perWord; ++j) packed |= uint(bitCount(inBlock(record, uint(word * perWord + j)) & present)) << uint(j * kCountBits);
    recordCount[i] = packed;
  }
  barrier();
  // 6
  for (int word = lane; word < kCountWords; word += kLanes) {
    uint sum = 0u;
    for (int record = 0; record < records; ++record) {
      uint count = recordCount[record * kCountWords + word];
      recordCount[record * kCountWords + word] = sum;
      sum += count;
    }
  }
  barrier();
  // 7
  for (int i = lane; i < columns; i += kLanes) {
    uint column = element[i];
    uint block = column >> shift;
    int at = int(block) * kCountBits;
    uint rank = bitfieldExtract(recordCount[(i >> 5) * kCountWords + (at >> 5)], at & 31, kCountBits) +
                uint(bitCount(inBlock(i >> 5, block) & lowBits(i & 31)));
    for (int j = 0; j < kPlaceBits; ++j)
      if ((rank >> uint(j) & 1u) != 0u) atomicOr(placePlane[int(column >> 5u) * kPlaceBits + j], 1u << (column & 31u));
  }
  barrier();
  // 8
  for (int i = lane; i < records * kRecordTexels; i += kLanes) {
    int record = i / kRecordTexels;
    uvec4 four = uvec4(0u);
    for (int j = 0; j < 4; ++j) {
      int word = 4 * (i % kRecordTexels) + j;
      if (word < kCountWords)
        four[j] = recordCount[record * kCountWords + word];
      else if (word < kCountWords + kBlockBits)
        four[j] = blockPlane[record * kBlockBits + word - kCountWords];
    }
    imageStore(order, ivec2(slice, i), four);
  }
  for (int i = lane; i < records * kPlaceTexels; i += kLanes) {
    uvec4 four = uvec4(0u);
    for (int j = 0; j < 4; ++j) {
      int plane = 4 * (i % kPlaceTexels) + j;
      if (plane < kPlaceBits) four[j] = placePlane[(i / kPlaceTexels) * kPlaceBits + plane];
    }
    imageStore(places, ivec2(slice, i), four);
  }
}
