// Single scattering of one light by walking wavelet matrices of rectified rows: exact on its map, but for the bin of the depth, in a number
// of steps that depends on nothing but the number of columns.
// Inputs: scene depth (D32, reversed); Slice buffer; rectified maps; `levels`, `ranks` and `bounds` of exact_build.comp; shadow map
// (epipole block). Output: RGBA32F as in ray_march.comp, or, with kShowSteps, the number of texels walked.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
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
layout(binding = 1, scalar) uniform Light { RectifiedSunBlock light; };
layout(binding = 2) uniform sampler2D sceneDepth;
layout(binding = 3, scalar) readonly buffer Slices { Slice slices[]; };
layout(binding = 4) uniform sampler2DArray shadowMap;
layout(binding = 5, rgba32f) uniform image2D scatter;
layout(binding = 6) uniform sampler2D bounds;
layout(binding = 7) uniform sampler2DArray rectified;
layout(binding = 8) uniform sampler2DArray projective;
layout(binding = 9) uniform sampler2DArray levels;
layout(binding = 10) uniform sampler2D ranks;

int visited = 0;

#define TY_SHOWN (kShowSteps ? vec4(float(visited)) : vec4(-1.0))
#include "stages/rays_on_rows.glsl"
#include "stages/reference_rays.glsl"
#include "stages/row_weights.glsl"
#include "stages/texel_depths.glsl"

// The rank that a ray's depth has among the depths of a row: how many lie before it, ties within a bin evenly spread.
float rankOf(int slice, float depth) {
  float at = depth * float(kBins);
  int bin = clamp(int(at), 0, kBins - 1);
  float before = texelFetch(ranks, ivec2(slice, bin), 0).x;
  float after = texelFetch(ranks, ivec2(slice, bin + 1), 0).x;
  return mix(before, after, clamp(at - float(bin), 0.0, 1.0)) * kCountScale;
}

// Shares of the weight of a row's first `elements` columns, for each reference ray, whose blocker lies before the ray.
void blockedShares(int slice, int elements, float depth, out float blocked[kReferenceRays]) {
  vec2 found[kReferenceRays];
  for (int k = 0; k < kReferenceRays; ++k) found[k] = vec2(0.0, 1.0);
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
    for (int k = 0; k < kReferenceRays; ++k) found[k] = waveletStep(found[k], texel[(k + 1) / 4][(k + 1) % 4], one);
  }
  for (int k = 0; k < kReferenceRays; ++k) blocked[k] = left > 0 ? waveletEnd(found[k], rank, whole, level, kBits) : found[k].x;
}

// Visible share of the columns of one row before the ray's end, by the ray's own weights.
float rowVisibility(Row row, RowRay ray) {
  int columns = int(totalColumns());
  int whole = min(int(row.column), columns);
  float partial = row.column - float(whole);
  float visible = 1.0;
  if (whole > 0) {
    bool settled = false;
    if (kBounds) {
      vec2 range = texelFetch(bounds, ivec2(row.index, whole - 1), 0).xy;
      if (ray.depth <= range.x || ray.depth > range.y) {
        visible = ray.depth <= range.x ? 1.0 : 0.0;
        settled = true;
      }
    }
    if (!settled) {
      float blocked[kReferenceRays];
      blockedShares(row.index, whole, ray.depth, blocked);
      float sum = blocked[0];
      if (kReferenceRays > 1) {
        float x = referencePlace(row.s.nodeLow, row.s.nodeHigh, cosecant(ray.theta));
        sum = 0.0;
        for (int k = 0; k < kReferenceRays; ++k) sum += chebyshevLagrange(k, kReferenceRays, x) * blocked[k];
      }
      visible = 1.0 - clamp(sum, 0.0, 1.0);
    }
  }
  if (partial <= 0.0 || whole >= columns) return visible;
  // The column in which the ray ends counts by the part before the end.
  float lit = ray.depth <= texelDepths(ivec2(row.index, whole)).x ? 1.0 : 0.0;
  float before = ownWeight(ray, row.s, 0.0, float(whole));
  float within = ownWeight(ray, row.s, float(whole), row.column);
  return before + within > 0.0 ? (visible * before + lit * within) / (before + within) : visible;
}

float meanVisibility(RowRay ray) {
  float visible = rowVisibility(ray.a, ray);
  if (kRowFilter != kRowNearest) visible = mix(rowVisibility(ray.b, ray), visible, ray.a.weight);
  return visible;
}
