// Sorts the columns of rectified rows by depth, and stores what order_rows.glsl says: an invocation a row.
// Inputs: rectified maps. Outputs: `ranks` (R16 unorm), `order` and `places` (RGBA32 uint).
// Steps: 1 count the columns of each bin; 2 sum up the bins, which is the table of ranks; 3 put each column where its bin says, in any order within
// a bin; 4 go through the order, counting in blocks: a column's count is its rank in its block, 32 neighbours are a record.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "lib/wavelet.glsl"
#include "lib/depth_order.glsl"
#include "stages/rectified.h"

layout(local_size_x = 32) in;
layout(constant_id = 20) const int kFirst = 0;      // columns of the order that this pass makes records of: [kFirst, kLast)
layout(constant_id = 21) const int kLast = 1024;
layout(constant_id = 25) const bool kPrivate = true;
const bool kFiltered = false;
layout(binding = 1, scalar) uniform Light { RectifiedLightBlock light; };
layout(binding = 3) uniform sampler2DArray rectified;
layout(binding = 4) uniform sampler2DArray projective;
layout(binding = 5) uniform writeonly uimage2D order;
layout(binding = 6) uniform writeonly uimage2D places;
layout(binding = 7) uniform writeonly image2D ranks;
layout(binding = 9, scalar) buffer Scratch { uint scratch[]; };

#include "stages/rows.glsl"
#include "stages/texel_depths.glsl"
#include "techniques/exact/order_rows.glsl"

// Memory of an invocation: the order, the bins' counts, those of the blocks, planes of places. In registers and what backs them where that is a
// cache (kPrivate), else in a buffer, invocations side by side, where it stays from pass to pass.
const int kCounts = kElements;
const int kBlockCounts = kCounts + kBins + 1;
const int kPlanes = kBlockCounts + kCountWords;
const int kWords = kPlanes + (kElements / 32) * kPlaceBits;
uint word[kPrivate ? kWords : 1];
uint scratchBase, scratchStride;
uint load(int i) { return kPrivate ? word[kPrivate ? i : 0] : scratch[scratchBase + uint(i) * scratchStride]; }
void store(int i, uint value) {
  if (kPrivate)
    word[kPrivate ? i : 0] = value;
  else
    scratch[scratchBase + uint(i) * scratchStride] = value;
}
uint takeNext(int i) {  // the count before it grows by one
  uint before = load(i);
  store(i, before + 1u);
  return before;
}

// Steps 1 to 3.
void sortRow(int slice, int columns) {
  // 1
  for (int b = 0; b <= kBins; ++b) store(kCounts + b, 0u);
  for (int column = 0; column < columns; ++column) takeNext(kCounts + waveletBin(texelDepths(ivec2(slice, column)).x, kBinBits));
  // 2
  uint before = 0u;
  for (int b = 0; b <= kBins; ++b) {
    imageStore(ranks, ivec2(slice, b), vec4(float(before) / kCountScale));
    uint own = load(kCounts + b);
    store(kCounts + b, before);
    before += own;
  }
  // 3
  for (int column = 0; column < columns; ++column)
    store(int(takeNext(kCounts + waveletBin(texelDepths(ivec2(slice, column)).x, kBinBits))), uint(column));
  for (int i = kBlockCounts; i < kWords; ++i) store(i, 0u);
}

void main() {
  int slice = int(gl_GlobalInvocationID.x);
  if (slice >= int(light.map.slices)) return;
  scratchStride = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
  scratchBase = gl_GlobalInvocationID.x;
  int columns = int(totalColumns());
  int shift = rowShift();

  if (kFirst == 0) sortRow(slice, columns);
  // 4
  for (int first = kFirst; first < min(columns, kLast); first += 32) {
    uint record[4 * kRecordTexels];
    for (int i = 0; i < 4 * kRecordTexels; ++i) record[i] = i < kCountWords ? load(kBlockCounts + i) : 0u;
    int last = min(columns - first, 32);
    for (int i = 0; i < last; ++i) {
      uint column = load(first + i);
      uint block = column >> uint(shift);
      for (int j = 0; j < kBlockBits; ++j) record[kCountWords + j] |= (block >> uint(j) & 1u) << uint(i);
      int at = kBlockCounts + int(block * uint(kCountBits) >> 5u);
      uint bit = block * uint(kCountBits) & 31u;
      uint counts = load(at);
      uint rank = bitfieldExtract(counts, int(bit), kCountBits);
      store(at, counts + (1u << bit));
      for (int j = 0; j < kPlaceBits; ++j)
        if ((rank >> uint(j) & 1u) != 0u) {
          int plane = kPlanes + int(column >> 5u) * kPlaceBits + j;
          store(plane, load(plane) | 1u << (column & 31u));
        }
    }
    for (int t = 0; t < kRecordTexels; ++t)
      imageStore(order, ivec2(slice, (first >> 5) * kRecordTexels + t), uvec4(record[4 * t], record[4 * t + 1], record[4 * t + 2], record[4 * t + 3]));
  }
  if (kLast < columns) return;
  for (int first = 0; first < columns; first += 32)
    for (int t = 0; t < kPlaceTexels; ++t) {
      uvec4 four = uvec4(0u);
      for (int j = 0; j < 4; ++j)
        if (4 * t + j < kPlaceBits) four[j] = load(kPlanes + (first >> 5) * kPlaceBits + 4 * t + j);
      imageStore(places, ivec2(slice, (first >> 5) * kPlaceTexels + t), four);
    }
}
