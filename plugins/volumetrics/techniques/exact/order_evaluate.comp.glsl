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

// The columns of the row at hand that hide the ray, the first `found` of its order: the record that holds the last of them, and which of the
// record's own they are.
uvec4 record[kRecordTexels];
uint recordOwn;

uint recordWord(int i) { return record[i >> 2][i & 3]; }

void readRecord(int row, int columns, int found) {
  int at = min(found >> 5, (columns - 1) >> 5);
  for (int t = 0; t < kRecordTexels; ++t) record[t] = texelFetch(order, ivec2(row, at * kRecordTexels + t), 0);
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
  for (int j = 0; j < kBlockBits; ++j) m &= planeWhere(recordWord(kCountWords + j), uint(block) >> uint(j));
  uint word = recordWord(block * kCountBits >> 5);
  return bitCount(m) + int(bitfieldExtract(word, block * kCountBits & 31, kCountBits));
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

// Adds what block `BLOCK` weighs and hides, where the ray passes it wholly.
#define TY_BLOCK(BLOCK, WHICH)                                                                                                        \
  {                                                                                                                                   \
    int count = bitCount(WHICH) + int(bitfieldExtract(recordWord((BLOCK) * kCountBits / 32), (BLOCK) * kCountBits % 32, kCountBits)); \
    int to = ((BLOCK) + 1) << shift;                                                                                                  \
    float weight = (BLOCK) < last ? nextWeight(walk, ray, row.s, float(to)) : 0.0;                                                    \
    if (kShaped) {                                                                                                                    \
      vec3 strength = meanStrength(row.index, min(to, columns) - 1);                                                                  \
      lit_ += strength * weight;                                                                                                      \
      hidden += strength * (weight * float(count));                                                                                   \
    } else {                                                                                                                          \
      hidden.x += weight * float(count);                                                                                              \
    }                                                                                                                                 \
    if ((BLOCK) < last) {                                                                                                             \
      most = max(most, abs(weight - before));                                                                                         \
      before = weight;                                                                                                                \
    }                                                                                                                                 \
    passed += weight;                                                                                                                 \
  }
#define TY_EIGHT_BLOCKS(GROUP)                                                                     \
  if (8 * (GROUP) < kBlocks && 8 * (GROUP) < last) {                                               \
    uint m = recordOwn;                                                                            \
    for (int j = 3; j < kBlockBits; ++j) m &= planeWhere(recordWord(kCountWords + j), uint((GROUP) >> (j - 3))); \
    uint p2 = recordWord(kCountWords + 2), p1 = recordWord(kCountWords + 1), p0 = recordWord(kCountWords); \
    uint lower = m & ~p2, upper = m & p2;                                                          \
    uint a = lower & ~p1, b = lower & p1, c = upper & ~p1, d = upper & p1;                         \
    TY_BLOCK(8 * (GROUP), a & ~p0)                                                                 \
    TY_BLOCK(8 * (GROUP) + 1, a & p0)                                                              \
    TY_BLOCK(8 * (GROUP) + 2, b & ~p0)                                                             \
    TY_BLOCK(8 * (GROUP) + 3, b & p0)                                                              \
    TY_BLOCK(8 * (GROUP) + 4, c & ~p0)                                                             \
    TY_BLOCK(8 * (GROUP) + 5, c & p0)                                                              \
    TY_BLOCK(8 * (GROUP) + 6, d & ~p0)                                                             \
    TY_BLOCK(8 * (GROUP) + 7, d & p0)                                                              \
  }

// Visible share of the columns of one row before the ray's end, by the ray's own weights, times the strength of their light rays.
// Steps: 1 how many columns hide the ray, and the record of the last of them; 2 blocks that the ray passes wholly; 3 those of them whose weight
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
  // Written out: every word of the record is then at a place known to the compiler.
  TY_EIGHT_BLOCKS(0)
  TY_EIGHT_BLOCKS(1)
  TY_EIGHT_BLOCKS(2)
  TY_EIGHT_BLOCKS(3)
  TY_EIGHT_BLOCKS(4)
  TY_EIGHT_BLOCKS(5)
  TY_EIGHT_BLOCKS(6)
  TY_EIGHT_BLOCKS(7)
  hidden /= float(1 << shift);
  // 3
  if (kByColumn || most > kMostChange * total) {
    walk = startWalk(ray, row.s, float(1 << shift));
    before = firstBefore(walk);
    for (int block = 0; block < last; ++block) {
      int from = block << shift, to = from + (1 << shift);
      int count = countOne(block);
      float weight = nextWeight(walk, ray, row.s, float(to));
      if (count > 0 && count < 1 << shift && (kByColumn || abs(weight - before) > kMostChange * total))
        hidden += hiddenByParts(ray, row, shift, from, to, count) - meanStrength(row.index, to - 1) * (weight * float(count) / float(1 << shift));
      before = weight;
    }
  }
  // 4
  int from = last << shift;
  int whole = min(int(end), columns);
  int count = countOne(last);
  float ofColumn = end > float(whole) ? ownWeight(ray, row.s, float(whole), end) : 0.0;
  float ofBlock = max(total - passed - ofColumn, 0.0);
  uint which = hiddenColumns(row.index, shift, min(whole, columns - 1) & ~31, count);  // of the 32 columns round the end
  vec3 strength = vec3(1.0);
  if (whole > from) {
    if (kShaped) strength = meanStrength(row.index, whole - 1);
    // As much as its columns would weigh in the block before?
    float even = before / float(1 << shift) * float(whole - from);
    if (kByColumn || (count > 0 && abs(ofBlock - even) > kMostChange * total)) {
      hidden += hiddenByParts(ray, row, shift, from, whole, count);
    } else {
      int before_ = bitCount(which & lowBits(whole & 31) & ~lowBits(max(from - (whole & ~31), 0)));
      if (whole == columns) {
        before_ = count;
      } else if (kPlaceBits > 5) {
        for (int first = from; first < (whole & ~31); first += 32) before_ += bitCount(hiddenColumns(row.index, shift, first, count));
      }
      hidden += strength * (ofBlock * float(before_) / float(whole - from));
    }
    lit_ += strength * ofBlock;
  }
  // 5
  vec3 own = vec3(1.0);
  if (kShaped && ofColumn > 0.0) {
    own = meanStrength(row.index, whole);
    if (whole > from) own = max(own * float(whole - from + 1) - strength * float(whole - from), vec3(0.0));
  }
  lit_ += own * ofColumn;
  hidden += own * ((which >> uint(whole & 31) & 1u) != 0u ? ofColumn : 0.0);
  if (!kShaped) return vec3(clamp(1.0 - hidden.x / total, 0.0, 1.0));
  return asColour(max(lit_ - hidden, vec3(0.0)) / total);
}

vec3 meanVisibility(RowRay ray) {
  vec3 visible = rowVisibility(ray.a, ray);
  if (kRowFilter != kRowNearest) visible = mix(rowVisibility(ray.b, ray), visible, ray.a.weight);
  return visible;
}
