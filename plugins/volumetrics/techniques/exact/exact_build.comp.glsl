// Builds the wavelet matrix of rectified rows (Claude, Navarro, Ordonez 2015, "The wavelet matrix", in rank space): an invocation a row, or, for
// the levels below the first few, an invocation a node.
// Inputs: rectified maps, or the order of columns that an earlier pass left. Outputs: `levels` (RGBA16 unorm or RGBA32F, see tree.glsl);
// `ranks` (R16 unorm): texel b holds how many depths of the row lie in bins before b, over 65535; `bounds` (RG16 unorm): prefix
// minimum and maximum of the depth; `order` (R32 uint): rank << 16 | column, from pass to pass.
// Sorting: a counting sort by the depth's bin; equal bins keep their columns' order.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "lib/local_row.glsl"
#include "lib/local_light.glsl"
#include "lib/wavelet.glsl"
#include "stages/rectified.h"
#include "techniques/exact/tree.glsl"

layout(local_size_x = 32) in;
layout(constant_id = 1) const int kReferenceRays = 1;
layout(constant_id = 3) const bool kBounds = true;
layout(constant_id = 20) const int kFirst = 0;   // levels of this pass: [kFirst, kLast)
layout(constant_id = 21) const int kLast = 10;
layout(constant_id = 22) const bool kSort = true;   // starts from the map; otherwise from `order`
layout(constant_id = 25) const bool kPrivate = true;
layout(constant_id = 23) const bool kSave = false;  // leaves `order` for the next pass
const bool kFiltered = false;
layout(binding = 0, scalar) uniform Frame { RectifiedBlock frame; };
layout(binding = 1, scalar) uniform Light { RectifiedLightBlock light; };
layout(binding = 2, scalar) readonly buffer Slices { Slice slices[]; };
layout(binding = 3) uniform sampler2DArray rectified;
layout(binding = 4) uniform sampler2DArray projective;
layout(binding = 5) uniform writeonly image2D bounds;
layout(binding = 6) uniform writeonly image2DArray levels;
layout(binding = 7) uniform writeonly image2D ranks;
layout(binding = 8, r32ui) uniform uimage2D order;
layout(binding = 9, scalar) buffer Scratch { uint scratch[]; };
layout(binding = 20) uniform sampler2DArray columnWeights;  // kShaped

#include "stages/rows.glsl"
#include "stages/reference_rays.glsl"
#include "stages/texel_depths.glsl"
#include "stages/channels.glsl"
#include "techniques/exact/weights.glsl"

const int kMine = kElements >> kFirst;  // elements of this invocation

// Memory of an invocation: the elements of the present level and of the next, in turn, and the bins' counts. In registers and what backs them
// where that is a cache (kPrivate), else in a buffer, invocations side by side.
const int kCounts = 2 * kMine;
const int kWords = kCounts + (kSort ? kBins + 1 : 0);
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

// Ranks of the row's columns, in the order of columns.
void sortRow(int slice) {
  int columns = int(totalColumns());
  for (int b = 0; b <= kBins; ++b) store(kCounts + b, 0u);
  vec2 range = vec2(1.0, 0.0);
  for (int column = 0; column < kElements; ++column) {
    uint bin = uint(kBins);
    if (column < columns) {
      float depth = texelDepths(ivec2(slice, column)).x;
      range = vec2(min(range.x, depth), max(range.y, depth));
      if (kBounds) imageStore(bounds, ivec2(slice, column), vec4(range, 0.0, 0.0));
      bin = uint(waveletBin(depth, kBinBits));
    }
    store(column, bin);
    takeNext(kCounts + int(bin));
  }
  uint before = 0u;
  for (int b = 0; b <= kBins; ++b) {
    imageStore(ranks, ivec2(slice, b), vec4(float(before) / kCountScale));
    uint own = load(kCounts + b);
    store(kCounts + b, before);
    before += own;
  }
  for (int column = 0; column < kElements; ++column) {
    uint bin = load(column);
    store(column, takeNext(kCounts + int(bin)) << 16 | uint(column));
  }
}

void main() {
  int slice = int(gl_GlobalInvocationID.x);
  if (slice >= int(light.map.slices)) return;
  int base = int(gl_WorkGroupID.y) * kMine;
  scratchStride = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
  scratchBase = gl_WorkGroupID.y * uint(kWords) * scratchStride + gl_GlobalInvocationID.x;
  if (kSort) {
    sortRow(slice);
  } else {
    for (int i = 0; i < kMine; ++i) store(i, imageLoad(order, ivec2(slice, base + i)).x);
  }

  Slice s = slices[slice];
  Falloff falloff[kReferenceRays];
  float growth;
  setFalloff(s, falloff, growth);
  int from = 0;
  for (int level = kFirst; level < kLast; ++level) {
    int to = kMine - from;
    int size = kElements >> level;
    int start = 0;
    int zeros = 0;
    float ofZeros[kChannels];
    float ofAll[kChannels];
    for (int i = 0; i < kMine; ++i) {
      if ((i & (size - 1)) == 0) {  // a node begins
        start = i;
        zeros = 0;
        for (int k = 0; k < kChannels; ++k) {
          ofZeros[k] = 0.0;
          ofAll[k] = 0.0;
        }
      }
      uint own = load(from + i);
      bool one = waveletOne(int(own >> 16), level, kBits);
      int column = int(own & 0xffffu);
      store(to + start + (one ? size / 2 + i - start - zeros : zeros), own);
      zeros += one ? 0 : 1;
      vec4 texel[kVectors];
      texel[0].x = float(zeros) / kCountScale;
      float weight[kChannelSlots];
      columnWeight(slice, s, falloff, growth, column, weight);
      for (int k = 0; k < kChannels; ++k) {
        ofAll[k] += weight[k];
        ofZeros[k] += one ? 0.0 : weight[k];
        texel[(k + 1) / 4][(k + 1) % 4] = waveletShare(ofZeros[k], ofAll[k]);
      }
      for (int v = 0; v < kVectors; ++v) imageStore(levels, levelTexel(slice, base + i, level * kVectors + v), texel[v]);
    }
    from = to;
  }
  if (kSave)
    for (int i = 0; i < kMine; ++i) imageStore(order, ivec2(slice, base + i), uvec4(load(from + i)));
}
