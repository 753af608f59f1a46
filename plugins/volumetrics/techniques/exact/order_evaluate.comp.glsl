// Single scattering of one light by rows in the order of depth: of the columns that hide a ray it is counted how many lie in each block of
// neighbours, and a block counts by what it weighs along the ray itself.
// Inputs: scene depth (D32, reversed); Slice buffer; `ranks`, `order` and `places` (order_rows.glsl); `strengths`, the mean strength of a block's
// columns up to each (kShaped); shadow map (epipole block). Output: RGBA32F as in ray_march.comp, or, with kShowSteps, the blocks
// looked at.
// Approximation: within a block, weight and visibility are taken as uncorrelated. Where weights change much from block to block its
// columns are looked at by sixteenths instead, each with its own weight.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"
#include "lib/cube_map.glsl"
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "lib/local_row.glsl"
#include "lib/local_light.glsl"
#include "lib/depth_order.glsl"
#include "stages/rectified.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 5) const int kRowFilter = 1;
layout(constant_id = 6) const bool kFirstLight = true;
layout(constant_id = 7) const bool kShowSteps = false;
layout(constant_id = 31) const bool kByColumn = false;  // every mixed block by its columns: the map's own sum
const bool kFiltered = false;
layout(binding = 0, scalar) uniform Frame { RectifiedBlock frame; };
layout(binding = 1, scalar) uniform Light { RectifiedLightBlock light; };
layout(binding = 2) uniform sampler2D sceneDepth;
layout(binding = 3, scalar) readonly buffer Slices { Slice slices[]; };
layout(binding = 4) uniform sampler2DArray shadowMap;
layout(binding = 5, rgba32f) uniform image2D scatter;
layout(binding = 6) uniform usampler2D order;
layout(binding = 7) uniform usampler2D places;
layout(binding = 8) uniform sampler2DArray strengths;
layout(binding = 10) uniform sampler2D ranks;
layout(binding = 21) uniform sampler2DArray unshadowed;

int visited = 0;

#define TY_SHOWN (kShowSteps ? vec4(float(visited)) : vec4(-1.0))
#define TY_ROW_COOKIES
#include "stages/rays_on_rows.glsl"
#include "techniques/exact/order_rows.glsl"

const int kWeightsTransmittance = 1;
// Change of weight from a block to the next, in parts of the ray's whole weight, from which a block that is neither lit nor dark is looked at
// by sixteenths: what is missed else is an eighth of it at most.
const float kMostChange = 1.0 / 32.0;

// Weights of a light with a table of unshadowed integrals.
bool byTable() { return kLocal && opaque(frame.rectified.weights) == kWeightsTransmittance; }

float rowSigma() { return opaque(frame.rectified.weights) == kWeightsTransmittance ? frame.rays.sigma_t : 0.0; }

// Weight of the columns between two coordinates along the ray itself: for a sun m times the transmittance from the row's start on, for other
// lights as in unshadowedTo().
float ownWeight(RowRay ray, Slice s, float from, float to) {
  float a = columnDistance(s, from);
  float b = columnDistance(s, to);
  if (byTable()) return max(unshadowedTo(ray.theta, b) - unshadowedTo(ray.theta, a), 0.0);
  if (kLocal) return b - a;
  float start = columnDistance(s, 0.0);
  float perSine = 1.0 / max(ray.sine, 1e-7);
  return transmittanceIntegral(rowSigma(), (a - start) * perSine, (b - start) * perSine);
}

// The columns of the row at hand that hide the ray are the first `found` of its order. At hand of the record that holds the last of them: which of
// its own 32 they are, where it stands, and the texels with planes; counts are fetched where they are needed, as code that knows the place of
// every word is long, and takes a driver half a minute to compile.
uvec4 record[kRecordTexels];
uint recordOwn;
ivec2 recordAt;
const int kFirstPlaneTexel = kCountWords / 4;

uint blockPlane(int j) { return record[(kCountWords + j) / 4][(kCountWords + j) % 4]; }

void readRecord(int row, int columns, int found) {
  int at = min(found >> 5, (columns - 1) >> 5);
  recordAt = ivec2(row, at * kRecordTexels);
  for (int t = kFirstPlaneTexel; t < kRecordTexels; ++t) record[t] = texelFetch(order, recordAt + ivec2(0, t), 0);
  recordOwn = lowBits(found - 32 * at);
}

// Which of 32 columns of a block, from `first` on, hide the ray, where `count` of the block do: rank < count, from the highest plane down. A count
// of all the block's columns has a bit that no rank has.
#define TY_PLANE(J) \
  if ((J) < kPlaceBits) state = planeLess(state, plane[(J) / 4][(J) % 4], uint(count) >> uint(J));
uint hiddenColumns(int row, int shift, int first, int count) {
  uvec4 plane[3];
  for (int t = 0; t < 3; ++t)
    if (t < kPlaceTexels) plane[t] = texelFetch(places, ivec2(row, (first >> 5) * kPlaceTexels + t), 0);
  uvec2 state = uvec2(0u, 0xffffffffu);
  TY_PLANE(11)
  TY_PLANE(10)
  TY_PLANE(9)
  TY_PLANE(8)
  TY_PLANE(7)
  TY_PLANE(6)
  TY_PLANE(5)
  TY_PLANE(4)
  TY_PLANE(3)
  TY_PLANE(2)
  TY_PLANE(1)
  TY_PLANE(0)
  return count >> shift > 0 ? 0xffffffffu : state.x;
}

vec3 meanStrength(int row, int column) { return kShaped ? texelFetch(strengths, ivec3(row, column, 0), 0).xyz : vec3(1.0); }

vec3 asColour(vec3 value) { return kColoured ? value : value.xxx; }

// Hidden weight of block [from, to), part by part. `count` of its columns hide the ray.
vec3 hiddenByParts(RowRay ray, Row row, int shift, int from, int to, int count) {
  int size = kByColumn ? 1 : clamp((1 << shift) >> 4, 1, 32);
  vec3 sum = vec3(0.0);
  uint which = 0u;  // of the 32 columns at hand, those that hide the ray
  float upTo = 0.0;
  vec3 strengthUpTo = vec3(0.0);
  for (int a = from; a < to; a += size) {
    if (kShowSteps) ++visited;
    if (a == from || (a & 31) == 0) which = hiddenColumns(row.index, shift, a & ~31, count);
    int b = min(a + size, to);
    float next = ownWeight(ray, row.s, float(from), float(b));
    float weight = next - upTo;
    upTo = next;
    vec3 strength = vec3(1.0);
    if (kShaped) {  // means from the block's start on, taken apart
      vec3 strengthNext = meanStrength(row.index, b - 1) * float(b - from);
      strength = max(strengthNext - strengthUpTo, vec3(0.0)) / float(b - a);
      strengthUpTo = strengthNext;
    }
    uint own = (which >> uint(a & 31)) & lowBits(b - a);
    sum += strength * (weight * float(bitCount(own)) / float(b - a));
  }
  return sum;
}

// How many of the hiding columns lie in one block.
int countOne(int block) {
  uint m = recordOwn;
  for (int j = 0; j < kBlockBits; ++j) m &= planeWhere(blockPlane(j), uint(block) >> uint(j));
  int bit = block * kCountBits;
  uvec4 words = texelFetch(order, recordAt + ivec2(0, bit >> 7), 0);
  uint word = words[(bit >> 5) & 3];
  return bitCount(m) + int(bitfieldExtract(word, bit & 31, kCountBits));
}

// Goes along a row block by block, with what each weighs along the ray, relative to the transmittance at the row's start.
struct Walk {
  float reach;       // distance from the axis or angle at the light, where the next block begins
  float upTo;        // of a light with a table: its integral up to there
  float left;        // transmittance from the row's start up to there
  float next, step_; // of a sun on an epipolar map: the next block's own transmittance, and how that changes from block to block
  float length_, growth;  // m along the ray, likewise
  float sigma, perSigma;
};

Walk startWalk(RowRay ray, Slice s, float size) {
  Walk walk;
  walk.reach = columnDistance(s, 0.0);
  walk.upTo = byTable() ? unshadowedTo(ray.theta, walk.reach) : 0.0;
  walk.left = 1.0;
  walk.sigma = rowSigma();
  walk.perSigma = 1.0 / max(walk.sigma, 1e-12);
  float perSine = 1.0 / (kLocal ? 1.0 : max(ray.sine, 1e-7));
  float first = columnDistance(s, size), second = columnDistance(s, 2.0 * size);
  walk.length_ = (first - walk.reach) * perSine;
  walk.growth = (second - 2.0 * first + walk.reach) * perSine;
  walk.next = kLocal ? 1.0 : exp(-rowSigma() * walk.length_);
  walk.step_ = kLocal ? 1.0 : exp(-rowSigma() * walk.growth);
  return walk;
}

// What a block before the first would weigh.
float firstBefore(Walk walk) { return kLocal ? 0.0 : walk.length_ / max(walk.next, 1e-30); }

// Weight of the next block, which ends at column `to`.
float nextWeight(inout Walk walk, RowRay ray, Slice s, float to) {
  if (byTable()) {
    float upTo = unshadowedTo(ray.theta, columnDistance(s, to));
    float weight = max(upTo - walk.upTo, 0.0);
    walk.upTo = upTo;
    return weight;
  }
  if (byTangent()) {
    float reach = columnDistance(s, to);
    walk.length_ = (reach - walk.reach) / max(ray.sine, 1e-7);
    walk.reach = reach;
    walk.next = exp(-rowSigma() * walk.length_);
  }
  float weight = walk.left * blockIntegral(walk.length_, walk.sigma * walk.length_, walk.next, walk.perSigma);
  walk.left *= walk.next;
  walk.next *= walk.step_;
  walk.length_ += walk.growth;
  return weight;
}

// Adds what block 8 * group + I weighs and hides, where the ray passes it wholly; `WHICH` are the record's own columns in it.
#define TY_BLOCK(I, WHICH)                                                                                                      \
  {                                                                                                                             \
    int block = 8 * group + (I);                                                                                                \
    int count = bitCount(WHICH) + int(bitfieldExtract(words[(I) * kCountBits / 32], (I) * kCountBits % 32, kCountBits));        \
    int to = (block + 1) << shift;                                                                                              \
    float weight = block < last ? nextWeight(walk, ray, row.s, float(to)) : 0.0;                                                \
    if (kShaped) {                                                                                                              \
      vec3 strength = meanStrength(row.index, min(to, columns) - 1);                                                            \
      lit_ += strength * weight;                                                                                                \
      hidden += strength * (weight * float(count));                                                                             \
    } else {                                                                                                                    \
      hidden.x += weight * float(count);                                                                                        \
    }                                                                                                                           \
    if (block < last) {                                                                                                         \
      most = max(most, abs(weight - before));                                                                                   \
      before = weight;                                                                                                          \
    }                                                                                                                           \
    passed += weight;                                                                                                           \
  }

// Visible share of the columns of one row before the ray's end, by the ray's own weights, times the strength of their light rays.
// Steps: 1 how many columns hide the ray, and the record of the last of them; 2 blocks that the ray passes wholly; 3 those whose weight
// changes much, again, part by part; 4 the block in which it ends; 5 the column in which it ends, by its part.
vec3 rowVisibility(Row row, RowRay ray) {
  // 1
  int columns = int(totalColumns());
  float end = min(row.column, float(columns));
  int found = int(texelFetch(ranks, ivec2(row.index, depthBorder(ray.depth, kBinBits)), 0).x * kCountScale + 0.5);
  if (found == 0 && !kShaped) return vec3(1.0);
  float total = ownWeight(ray, row.s, 0.0, end);
  if (total <= 0.0) return vec3(1.0);
  int shift = rowShift();
  int last = min(int(end), columns - 1) >> shift;  // the block in which the ray ends
  readRecord(row.index, columns, found);

  // 2
  vec3 lit_ = vec3(0.0), hidden = vec3(0.0);
  Walk walk = startWalk(ray, row.s, float(1 << shift));
  float before = firstBefore(walk);  // weight of the block before
  float most = 0.0;                  // change from a block to the next
  float passed = 0.0;
  for (int group = 0; 8 * group < last; ++group) {
    // 8 counts are half a texel, or a whole one where they are wide.
    uvec4 words = texelFetch(order, recordAt + ivec2(0, kWideCounts ? group : group >> 1), 0);
    if (!kWideCounts && (group & 1) != 0) words.xy = words.zw;
    uint m = recordOwn;
    for (int j = 3; j < kBlockBits; ++j) m &= planeWhere(blockPlane(j), uint(group >> (j - 3)));
    uint p2 = blockPlane(2), p1 = blockPlane(1), p0 = blockPlane(0);
    uint lower = m & ~p2, upper = m & p2;
    uint a = lower & ~p1, b = lower & p1, c = upper & ~p1, d = upper & p1;
    TY_BLOCK(0, a & ~p0)
    TY_BLOCK(1, a & p0)
    TY_BLOCK(2, b & ~p0)
    TY_BLOCK(3, b & p0)
    TY_BLOCK(4, c & ~p0)
    TY_BLOCK(5, c & p0)
    TY_BLOCK(6, d & ~p0)
    TY_BLOCK(7, d & p0)
  }
  hidden /= float(1 << shift);
  // 3
  int lastFrom = last << shift;
  int whole = min(int(end), columns);
  float ofColumn = end > float(whole) ? ownWeight(ray, row.s, float(whole), end) : 0.0;
  float ofLast = max(total - passed - ofColumn, 0.0);
  int countOfLast = countOne(last);
  // As much as its columns would weigh in the block before?
  bool lastByParts = whole > lastFrom && countOfLast > 0 &&
                     (kByColumn || abs(ofLast - before / float(1 << shift) * float(whole - lastFrom)) > kMostChange * total);
  bool byParts = kByColumn || most > kMostChange * total;
  if (byParts || lastByParts) {
    walk = startWalk(ray, row.s, float(1 << shift));
    before = firstBefore(walk);
    for (int block = byParts ? 0 : last; block <= last; ++block) {
      int from = block << shift, to = block < last ? from + (1 << shift) : whole;
      int count = countOne(block);
      bool mixed = count > 0 && count < 1 << shift;
      float weight = block < last ? nextWeight(walk, ray, row.s, float(to)) : 0.0;
      bool changes = block < last ? mixed && (kByColumn || abs(weight - before) > kMostChange * total) : lastByParts;
      if (changes) {
        vec3 plain = block < last ? meanStrength(row.index, to - 1) * (weight * float(count) / float(1 << shift)) : vec3(0.0);
        hidden += hiddenByParts(ray, row, shift, from, to, count) - plain;
      }
      before = weight;
    }
  }
  // 4
  uint which = hiddenColumns(row.index, shift, min(whole, columns - 1) & ~31, countOfLast);  // of the 32 columns round the end
  vec3 strength = vec3(1.0);
  if (whole > lastFrom) {
    if (kShaped) strength = meanStrength(row.index, whole - 1);
    lit_ += strength * ofLast;
    if (!lastByParts) {
      int hiding = bitCount(which & lowBits(whole & 31) & ~lowBits(max(lastFrom - (whole & ~31), 0)));
      if (whole == columns) {
        hiding = countOfLast;
      } else if (kPlaceBits > 5) {
        for (int first = lastFrom; first < (whole & ~31); first += 32) hiding += bitCount(hiddenColumns(row.index, shift, first, countOfLast));
      }
      hidden += strength * (ofLast * float(hiding) / float(whole - lastFrom));
    }
  }
  // 5
  vec3 own = vec3(1.0);
  if (kShaped && ofColumn > 0.0) {
    own = meanStrength(row.index, whole);
    if (whole > lastFrom) own = max(own * float(whole - lastFrom + 1) - strength * float(whole - lastFrom), vec3(0.0));
  }
  lit_ += own * ofColumn;
  hidden += own * ((which >> uint(whole & 31) & 1u) != 0u ? ofColumn : 0.0);
  if (!kShaped) return vec3(clamp(1.0 - hidden.x / total, 0.0, 1.0));
  return asColour(max(lit_ - hidden, vec3(0.0)) / total);
}

vec3 meanVisibility(RowRay ray) {
  // One text for both rows: what it takes to compile is what it takes once.
  vec3 visible = vec3(0.0);
  for (int i = 0; i < (kRowFilter != kRowNearest ? 2 : 1); ++i) {
    Row row = ray.a;
    if (i == 1) row = ray.b;
    visible += rowVisibility(row, ray) * (kRowFilter != kRowNearest ? (i == 1 ? 1.0 - ray.a.weight : ray.a.weight) : 1.0);
  }
  return visible;
}
