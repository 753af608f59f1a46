// Single scattering of one light by walking wavelet matrices of rectified rows: exact on its map, but for the bin of the depth, in a number
// of steps that depends on nothing but the number of columns.
// Inputs: scene depth (D32, reversed); Slice buffer; rectified maps; `levels`, `ranks` and `bounds` of exact_build.comp; shadow map
// (epipole block). Output: RGBA32F as in ray_march.comp, or, with kShowSteps, the number of texels walked.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"
#include "lib/cube_map.glsl"
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "lib/local_row.glsl"
#include "lib/local_light.glsl"
#include "lib/wavelet.glsl"
#include "stages/rectified.h"
#include "techniques/exact/tree.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 1) const int kReferenceRays = 1;
layout(constant_id = 3) const bool kBounds = true;
layout(constant_id = 5) const int kRowFilter = 1;
layout(constant_id = 6) const bool kFirstLight = true;
layout(constant_id = 7) const bool kShowSteps = false;
const bool kFiltered = false;
layout(binding = 0, scalar) uniform Frame { RectifiedBlock frame; };
layout(binding = 1, scalar) uniform Light { RectifiedLightBlock light; };
layout(binding = 2) uniform sampler2D sceneDepth;
layout(binding = 3, scalar) readonly buffer Slices { Slice slices[]; };
layout(binding = 4) uniform sampler2DArray shadowMap;
layout(binding = 5, rgba32f) uniform image2D scatter;
layout(binding = 6) uniform sampler2D bounds;
layout(binding = 7) uniform sampler2DArray rectified;
layout(binding = 8) uniform sampler2DArray projective;
layout(binding = 9) uniform sampler2DArray levels;
layout(binding = 10) uniform sampler2D ranks;
layout(binding = 21) uniform sampler2DArray unshadowed;
layout(binding = 22) uniform sampler2DArray lit;

const float kHalfStep = 0.5 / 65535.0;  // of the bounds' 16-bit unorm

int visited = 0;

#define TY_SHOWN (kShowSteps ? vec4(float(visited)) : vec4(-1.0))
#define TY_ROW_COOKIES
#include "stages/rays_on_rows.glsl"
#include "stages/reference_rays.glsl"
#include "stages/row_weights.glsl"
#include "stages/texel_depths.glsl"
#include "stages/channels.glsl"
#include "stages/lit.glsl"

// The rank that a ray's depth has among the depths of a row: how many lie before it, ties within a bin evenly spread.
float rankOf(int slice, float depth) {
  float at = depth * float(kBins);
  int bin = clamp(int(at), 0, kBins - 1);
  float before = texelFetch(ranks, ivec2(slice, bin), 0).x;
  float after = texelFetch(ranks, ivec2(slice, bin + 1), 0).x;
  return mix(before, after, clamp(at - float(bin), 0.0, 1.0)) * kCountScale;
}

// Shares of the weight of a row's first `elements` columns, for each reference ray and colour, whose blocker lies before the ray.
void blockedShares(int slice, int elements, float depth, out float blocked[kChannels]) {
  vec2 found[kChannels];
  for (int k = 0; k < kChannels; ++k) found[k] = vec2(0.0, 1.0);
  float rank = rankOf(slice, depth);
  int whole = min(int(rank), kElements - 1);
  int left = elements;
  int level = 0;
  for (; level < kLevels && left > 0; ++level) {
    ++visited;
    int at = waveletNode(whole, level, kBits) + left - 1;
    vec4 texel[kVectors];
    for (int v = 0; v < kVectors; ++v) texel[v] = texelFetch(levels, levelTexel(slice, at, level * kVectors + v), 0);
    int zeros = int(texel[0].x * kCountScale + 0.5);
    bool one = waveletOne(whole, level, kBits);
    left = one ? left - zeros : zeros;
    for (int k = 0; k < kChannels; ++k) found[k] = waveletStep(found[k], texel[(k + 1) / 4][(k + 1) % 4], one);
  }
  for (int k = 0; k < kChannels; ++k) blocked[k] = left > 0 ? waveletEnd(found[k], rank, whole, level, kBits) : found[k].x;
}

// Visible share of the columns of one row before the ray's end, by the ray's own weights, times the strength of their light rays.
vec3 rowVisibility(Row row, RowRay ray) {
  int columns = int(totalColumns());
  int whole = min(int(row.column), columns);
  float partial = row.column - float(whole);
  float share[kReferenceRays];
  referenceShares(row.s.nodeLow, row.s.nodeHigh, ray.theta, columnDistance(row.s, float(whole)) - row.s.first, share);
  vec3 visible = vec3(1.0);
  vec3 strength = vec3(1.0);  // of whole columns, were they all lit
  if (whole > 0) {
    float value[kChannelSlots];
    if (kShaped) {
      litChannels(row.index, float(whole) - 0.5, value);
      strength = betweenReferenceRays(value, share);
      visible = strength;
    }
    bool settled = false;
    if (kBounds) {
      vec2 range = texelFetch(bounds, ivec2(row.index, whole - 1), 0).xy;
      bool dark = ray.depth > range.y + kHalfStep;
      settled = dark || ray.depth <= range.x - kHalfStep;
      if (dark) visible = vec3(0.0);
    }
    if (!settled) {
      float blocked[kChannels];
      blockedShares(row.index, whole, ray.depth, blocked);
      for (int i = 0; i < kChannels; ++i) value[i] = kShaped ? value[i] * (1.0 - blocked[i]) : 1.0 - blocked[i];
      visible = max(betweenReferenceRays(value, share), vec3(0.0));
      if (!kShaped) visible = min(visible, vec3(1.0));
    }
  }
  if (partial <= 0.0 || whole >= columns) return visible;
  // The column in which the ray ends counts by the part before the end.
  float lit_ = ray.depth <= texelDepths(ivec2(row.index, whole)).x ? 1.0 : 0.0;
  float before = ownWeight(ray, row.s, 0.0, float(whole));
  float within = ownWeight(ray, row.s, float(whole), row.column);
  vec3 last = vec3(1.0);
  if (kShaped) {
    // Its strength is what it adds to the lit channels.
    float column = ownWeight(ray, row.s, float(whole), float(whole + 1));
    float value[kChannelSlots];
    litChannels(row.index, float(whole) + 0.5, value);
    vec3 with = betweenReferenceRays(value, share);
    last = column > 0.0 ? clamp((with * (before + column) - strength * before) / column, vec3(0.0), vec3(1.0)) : vec3(0.0);
  }
  return before + within > 0.0 ? (visible * before + last * (lit_ * within)) / (before + within) : visible;
}

vec3 meanVisibility(RowRay ray) {
  vec3 visible = rowVisibility(ray.a, ray);
  if (kRowFilter != kRowNearest) visible = mix(rowVisibility(ray.b, ray), visible, ray.a.weight);
  return visible;
}
