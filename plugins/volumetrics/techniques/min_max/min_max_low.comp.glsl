// Levels 1 to 6 of the min-max trees (Chen et al. 2011): an invocation reduces 64 columns of one slice.
// Inputs: rectified maps. Output `low` (RG16 or RG32F): minimum and maximum depth; (1, 0) where there is no column.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"
#include "lib/medium.glsl"
#include "lib/epipolar.glsl"
#include "lib/local_row.glsl"
#include "lib/local_light.glsl"
#include "stages/rectified.h"
#include "techniques/min_max/tree.glsl"

layout(local_size_x = 32, local_size_y = 1) in;
const bool kFiltered = false;
layout(binding = 1, scalar) uniform Light { RectifiedLightBlock light; };
layout(binding = 3) uniform sampler2DArray rectified;
layout(binding = 4) uniform sampler2DArray projective;
layout(binding = 5) uniform writeonly image2D low;

#include "stages/rows.glsl"
#include "stages/texel_depths.glsl"

void main() {
  int slice = int(gl_GlobalInvocationID.x);
  int columns = int(totalColumns());
  int begin = int(gl_WorkGroupID.y) * kChunk;
  if (slice >= int(light.map.slices) || begin >= columns) return;
  int padded = paddedColumns(columns);
  vec2 node[kChunk / 2];
  for (int i = 0; i < kChunk / 2; ++i) {
    int at = begin + 2 * i;
    vec2 range = vec2(1.0, 0.0);
    if (at < columns) {
      float depth = texelDepths(ivec2(slice, at)).x;
      range = vec2(depth);
      if (at + 1 < columns) {
        float next = texelDepths(ivec2(slice, at + 1)).x;
        range = vec2(min(depth, next), max(depth, next));
      }
    }
    node[i] = range;
    imageStore(low, ivec2(slice, begin / 2 + i), vec4(range, 0.0, 0.0));
  }
  for (int level = 2; level <= kChunkLevels; ++level) {
    int offset = lowOffset(padded, level) + (begin >> level);
    for (int i = 0; i < kChunk >> level; ++i) {
      vec2 range = vec2(min(node[2 * i].x, node[2 * i + 1].x), max(node[2 * i].y, node[2 * i + 1].y));
      node[i] = range;
      imageStore(low, ivec2(slice, offset + i), vec4(range, 0.0, 0.0));
    }
  }
}
