// Single scattering of one sun by walking 1D min-max trees over rectified rows (Chen, Baran, Durand, Jarosz 2011, "Real-time Volumetric
// Shadows using 1D Min-Max Mipmaps"). A node whose every blocker is behind the ray is lit as a whole, one whose every blocker is
// before it is dark; mixed nodes are opened. No stack: the column and the level say it all.
// Inputs: scene depth (D32, reversed); Slice buffer; rectified maps; trees; shadow map (epipole block). Output: RGBA32F as in
// ray_march.comp, or, with kShowSteps, the number of nodes visited.
// Deviation: a run of lit nodes is weighed by the transmittance along the ray itself, instead of taking visibility out of the
// integral; exact on its map.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"
#include "lib/cube_map.glsl"
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "lib/local_row.glsl"
#include "lib/local_light.glsl"
#include "stages/rectified.h"
#include "techniques/min_max/tree.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
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
layout(binding = 6) uniform sampler2DArray rectified;
layout(binding = 7) uniform sampler2DArray projective;
layout(binding = 8) uniform sampler2D low;
layout(binding = 9) uniform sampler2D high;
layout(binding = 21) uniform sampler2DArray unshadowed;

int visited = 0;

#define TY_SHOWN (kShowSteps ? vec4(float(visited)) : vec4(-1.0))
#include "stages/rays_on_rows.glsl"
#include "stages/texel_depths.glsl"

vec2 nodeAt(int slice, int column, int level, int padded, int chunks) {
  if (level == 0) return texelDepths(ivec2(slice, column)).xx;
  if (level <= kChunkLevels) return texelFetch(low, ivec2(slice, lowOffset(padded, level) + (column >> level)), 0).xy;
  return texelFetch(high, ivec2(slice, highOffset(chunks, level) + (column >> level)), 0).xy;
}

// Visible share of the columns of one row before the ray's end, by the ray's own transmittance.
float walk(Row row, RowRay ray) {
  int padded = paddedColumns(int(totalColumns()));
  int chunks = paddedChunks(padded);
  int top = kChunkLevels + findMSB(chunks);
  float safeSine = max(ray.sine, 1e-7);
  float sigma_t = frame.rays.sigma_t;
  float begin = columnDistance(row.s, 0.0) / safeSine;
  float all = transmittanceIntegral(sigma_t, begin, columnDistance(row.s, row.column) / safeSine);
  if (!(all > 0.0)) return 1.0;
  int end = int(ceil(row.column));
  float lit = 0.0;
  float runStart = -1.0;  // column at which the present lit run began; below 0: dark
  int column = 0;
  int level = min(top, kChunkLevels);
  while (column < end) {
    ++visited;
    vec2 range = nodeAt(row.index, column, level, padded, chunks);
    bool bright = ray.depth <= range.x;
    if (!bright && ray.depth <= range.y) {
      --level;  // mixed: never at level 0, where both ends agree
      continue;
    }
    if (bright && runStart < 0.0) runStart = float(column);
    if (!bright && runStart >= 0.0) {
      lit += transmittanceIntegral(sigma_t, columnDistance(row.s, runStart) / safeSine, columnDistance(row.s, float(column)) / safeSine);
      runStart = -1.0;
    }
    column += 1 << level;
    // A node that starts where a coarser one starts: try that next.
    if (level < top && (column >> level & 1) == 0) ++level;
  }
  if (runStart >= 0.0)
    lit += transmittanceIntegral(sigma_t, columnDistance(row.s, runStart) / safeSine, columnDistance(row.s, row.column) / safeSine);
  return clamp(lit / all, 0.0, 1.0);
}

vec3 meanVisibility(RowRay ray) {
  float visible = walk(ray.a, ray);
  if (kRowFilter != kRowNearest) visible = mix(walk(ray.b, ray), visible, ray.a.weight);
  return vec3(visible);
}
