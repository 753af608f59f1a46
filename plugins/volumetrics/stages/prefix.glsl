// Weighted prefix averages along the columns of a rectified map, for every reference ray (Klehm et al. 2014, section 3.3; Peters et
// al. 2017, appendix C), in three schemes: one invocation a row (Klehm), 8x8 blocks in which eight invocations share a row and store
// in turn (Peters), or a workgroup scan: each invocation averages a run of columns, joins what the runs before it averaged, and goes
// through its run again. A segment (region of a row, or a split's map) starts anew.
// A technique includes this after defining kVectors, the vectors of four that it averages (of one group of basis functions), and defines
//   void basisAt(ivec2 at, float depth, int group, out vec4 v[kVectors])
//   void storePrefix(ivec2 at, int k, int group, vec4 v[kVectors])       k: reference ray
// Bindings 0 to 5 are taken. Groups of basis functions are workgroups along z, segments along y.
layout(local_size_x_id = 10, local_size_y_id = 11) in;
layout(constant_id = 1) const int kReferenceRays = 1;
layout(constant_id = 3) const bool kBounds = true;
layout(constant_id = 7) const bool kScan = false;
layout(constant_id = 8) const bool kFiltered = false;
layout(constant_id = 9) const int kLanes = 1;  // invocations that share memory: scan only
layout(constant_id = 12) const bool kCompensated = false;  // averages keep what rounding drops (lib/average.glsl)
layout(binding = 0, scalar) uniform Frame { RectifiedBlock frame; };
layout(binding = 1, scalar) uniform Light { RectifiedLightBlock light; };
layout(binding = 2, scalar) readonly buffer Slices { Slice slices[]; };
layout(binding = 3) uniform sampler2DArray rectified;   // resampled
layout(binding = 4) uniform sampler2DArray projective;  // rasterised: one layer a split
layout(binding = 5) uniform writeonly image2D bounds;
layout(binding = 20) uniform sampler2DArray columnWeights;  // stages/shine.comp.glsl; kShaped

#include "lib/average.glsl"
#include "stages/rows.glsl"
#include "stages/reference_rays.glsl"
#include "stages/texel_depths.glsl"
#include "stages/channels.glsl"

void basisAt(ivec2 at, float depth, int group, out vec4 v[kVectors]);
void storePrefix(ivec2 at, int k, int group, vec4 v[kVectors]);

const int kValues = kReferenceRays * kVectors;
const int kRests = kCompensated ? kValues : 1;

shared vec4 averages[kLanes * kValues];  // [lane][k][vector]
shared float totals[kLanes * kReferenceRays];
shared vec2 ranges[kLanes];

// The mean of the basis over a texel's blockers.
void texelBasis(ivec2 at, vec3 depths, int group, out vec4 v[kVectors]) {
  basisAt(at, depths.x, group, v);
  if (!kFiltered || depths.z <= 0.0) return;
  vec4 second[kVectors];
  basisAt(at, depths.y, group, second);
  for (int i = 0; i < kVectors; ++i) v[i] = mix(v[i], second[i], depths.z);
}

vec2 texelRange(vec3 depths) {
  if (!kFiltered) return depths.xx;
  if (depths.z <= 0.0) return depths.xx;
  if (depths.z >= 1.0) return depths.yy;
  return vec2(min(depths.x, depths.y), max(depths.x, depths.y));
}

// Integral of exp(-tau t) over [0, width], as a share of width: 1 for tau = 0, the papers' equal weights.
float meanFalloff(float x) { return x < 1e-4 ? 1.0 - 0.5 * x : oneMinusExp(x) / x; }

// A column for a reference ray. In a projective map `power` is the transmittance from the segment's start to the column, its weight power *
// base, and power * decay that of the next column. Else `power` is the transmittance from there to the column's middle, power * decay to
// the next one's, and decay * growth the factor after it: columns grow evenly.
struct Walk {
  float power, base, decay, growth;
};

// A column of the given width at optical depth `tau` per metre of distance from the axis.
void setWidth(inout Walk walk, float tau, float width) {
  float x = tau * width;
  walk.base = width * meanFalloff(x);
  walk.decay = exp(-x);
}

// So many columns are walked by products before rounding is taken out again.
const uint kProducts = 16u;

// Puts a walk on a column of a map that is not projective, `more` wider than the one before it; `start`: where the segment starts.
void placeWalk(inout Walk walk, float tau, Slice s, float column, float start, float more) {
  walk.power = exp(-tau * (columnDistance(s, column + 0.5) - start));
  walk.decay = exp(-tau * (columnWidth(s, column) + 0.5 * more));
  walk.growth = exp(-tau * more);
}

float nextWeight(inout Walk walk) {
  float weight = walk.power * walk.base;
  walk.power *= walk.decay;
  return weight;
}

// The same where columns grow evenly.
float nextEvenWeight(inout Walk walk, float tau, float width) {
  float weight = walk.power * (width * columnFullness(tau * width));
  walk.power *= walk.decay;
  walk.decay *= walk.growth;
  return weight;
}

// Weights of a column for all reference rays where light rays differ: the mean over the colours.
void shapedWeights(ivec2 at, out float weight[kReferenceRays]) {
  for (int k = 0; k < kReferenceRays; ++k) weight[k] = 0.0;
  for (int i = 0; i < kChannelQuads; ++i) {
    vec4 four = texelFetch(columnWeights, ivec3(at, i), 0);
    for (int c = 0; c < 4; ++c)
      if (4 * i + c < kChannels) weight[(4 * i + c) / kColours] += four[c];
  }
}

// Adds a weight to the total; its share of the new total.
float shareOf(inout float total, float weight) {
  total += weight;
  return total > 0.0 ? weight / total : 1.0;
}

// Moves average j (of value[]) towards `next` by a share. A macro: a function would copy the arrays.
#define TAKE(j, next, share)                              \
  {                                                       \
    vec4 move = ((next) - value[j]) * (share);            \
    if (kCompensated) {                                   \
      move += rest[kCompensated ? (j) : 0];               \
      rest[kCompensated ? (j) : 0] = lostInSum(value[j], move); \
    }                                                     \
    value[j] += move;                                     \
  }

// Sets walks and width to the present column.
#define NEXT_COLUMN                                                                                          \
  if (byTangent()) {                                                                                         \
    float next = columnDistance(s, float(column + 1u));                                                      \
    for (int k = 0; k < kReferenceRays; ++k) setWidth(walk[k], tau[k], next - last);                         \
    last = next;                                                                                             \
  } else {                                                                                                   \
    width = columnWidth(s, float(column));                                                                   \
    if (column == from || column % kProducts == 0u)                                                          \
      for (int k = 0; k < kReferenceRays; ++k) placeWalk(walk[k], tau[k], s, float(column), start, more);     \
  }

void main() {
  uint slice = gl_GlobalInvocationID.x;
  bool inside = slice < light.map.slices;
  if (!kScan && !inside) return;  // the scan needs every invocation at its barriers
  Slice s = slices[min(slice, light.map.slices - 1u)];
  int group = int(gl_WorkGroupID.z);
  if (gl_WorkGroupID.y >= light.map.segmentCount) return;
  uint begin = segmentBorder(s, gl_WorkGroupID.y);
  uint end = segmentBorder(s, gl_WorkGroupID.y + 1u);
  // Unless the map is projective: width of a column, and how much wider than the one before it it is.
  float more = 2.0 * (s.last - s.first) * (1.0 - s.nearest) / (float(light.map.columns) * float(light.map.columns));

  uint lane = gl_LocalInvocationID.y;
  uint lanes = gl_WorkGroupSize.y;
  uint from = begin;
  uint to = end;
  if (kScan) {
    uint run = (end - begin + lanes - 1u) / lanes;
    from = min(begin + lane * run, end);
    to = min(from + run, end);
  }

  float tau[kReferenceRays];
  Walk walk[kReferenceRays];
  float start = columnDistance(s, float(begin));
  float own = columnDistance(s, float(from));
  float width = 0.0;
  for (int k = 0; k < kReferenceRays; ++k) {
    tau[k] = referenceKey(s, k, kReferenceRays);
    walk[k].power = exp(-tau[k] * (own - start));
    walk[k].base = walk[k].decay = walk[k].growth = 0.0;
  }
  float total[kReferenceRays];
  vec4 value[kValues];
  vec4 rest[kRests];
  for (int k = 0; k < kReferenceRays; ++k) total[k] = 0.0;
  for (int i = 0; i < kValues; ++i) value[i] = vec4(0.0);
  for (int i = 0; i < kRests; ++i) rest[i] = vec4(0.0);
  vec2 range = vec2(1.0, 0.0);

  if (kScan) {
    float power[kReferenceRays];
    for (int k = 0; k < kReferenceRays; ++k) power[k] = walk[k].power;
    float last = own;
    for (uint column = from; column < to; ++column) {
      ivec2 at = ivec2(min(slice, light.map.slices - 1u), column);
      vec3 depths = texelDepths(at);
      vec2 reach = texelRange(depths);
      range = vec2(min(range.x, reach.x), max(range.y, reach.y));
      vec4 basis[kVectors];
      texelBasis(at, depths, group, basis);
      NEXT_COLUMN
      float shaped[kReferenceRays];
      if (kShaped) shapedWeights(at, shaped);
      for (int k = 0; k < kReferenceRays; ++k) {
        float share = shareOf(total[k], kShaped ? shaped[k] : byTangent() ? nextWeight(walk[k]) : nextEvenWeight(walk[k], tau[k], width));
        for (int i = 0; i < kVectors; ++i) TAKE(k * kVectors + i, basis[i], share)
      }
    }
    for (int k = 0; k < kReferenceRays; ++k) walk[k].power = power[k];
    uint at = lane * gl_WorkGroupSize.x + gl_LocalInvocationID.x;
    uint place = at * uint(kValues);
    for (int i = 0; i < kValues; ++i) averages[place + uint(i)] = value[i];
    for (int k = 0; k < kReferenceRays; ++k) totals[at * uint(kReferenceRays) + uint(k)] = total[k];
    ranges[at] = range;
    barrier();
    for (int k = 0; k < kReferenceRays; ++k) total[k] = 0.0;
    for (int i = 0; i < kValues; ++i) value[i] = vec4(0.0);
    for (int i = 0; i < kRests; ++i) rest[i] = vec4(0.0);
    range = vec2(1.0, 0.0);
    for (uint other = 0u; other < lane; ++other) {
      uint there = other * gl_WorkGroupSize.x + gl_LocalInvocationID.x;
      for (int k = 0; k < kReferenceRays; ++k) {
        float share = shareOf(total[k], totals[there * uint(kReferenceRays) + uint(k)]);
        for (int i = 0; i < kVectors; ++i) TAKE(k * kVectors + i, averages[there * uint(kValues) + uint(k * kVectors + i)], share)
      }
      range = vec2(min(range.x, ranges[there].x), max(range.y, ranges[there].y));
    }
    if (!inside) return;
  }

  // Averages instead of sums: rounding stays relative to the values, and low precision stores them (Klehm, listings 1 and 2).
  float last = own;
  for (uint column = from; column < to; ++column) {
    ivec2 at = ivec2(slice, column);
    vec3 depths = texelDepths(at);
    vec2 reach = texelRange(depths);
    range = vec2(min(range.x, reach.x), max(range.y, reach.y));
    vec4 basis[kVectors];
    texelBasis(at, depths, group, basis);
    NEXT_COLUMN
    bool mine = kScan || column % lanes == lane;
    float shaped[kReferenceRays];
    if (kShaped) shapedWeights(at, shaped);
    for (int k = 0; k < kReferenceRays; ++k) {
      float share = shareOf(total[k], kShaped ? shaped[k] : byTangent() ? nextWeight(walk[k]) : nextEvenWeight(walk[k], tau[k], width));
      vec4 average[kVectors];
      for (int i = 0; i < kVectors; ++i) {
        TAKE(k * kVectors + i, basis[i], share)
        average[i] = value[k * kVectors + i];
      }
      if (mine) storePrefix(at, k, group, average);
    }
    // Rounding to 16 bit is allowed for where they are read.
    if (kBounds && mine && group == 0) imageStore(bounds, at, vec4(range, 0.0, 0.0));
  }
}
