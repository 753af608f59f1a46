// Levels 7 and up of the min-max trees (Chen et al. 2011) from level 6: an invocation a slice.
// Input: `low`. Output `high`, same format.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"
#include "stages/rectified.h"
#include "stages/opaque.glsl"
#include "techniques/min_max/tree.glsl"

layout(local_size_x = 32) in;
layout(binding = 1, scalar) uniform Light { RectifiedLightBlock light; };
layout(binding = 3) uniform sampler2D low;
layout(binding = 5) uniform writeonly image2D high;

const int kMostChunks = 256;  // 4 splits of 4096 columns

void main() {
  int slice = int(gl_GlobalInvocationID.x);
  if (slice >= int(light.map.slices)) return;
  int padded = paddedColumns(int(opaque(light.map.columns * light.map.splits)));
  int chunks = padded / kChunk;
  int rounded = paddedChunks(padded);
  vec2 node[kMostChunks];
  int offset = lowOffset(padded, kChunkLevels);
  for (int i = 0; i < rounded; ++i)
    node[i] = i < chunks ? texelFetch(low, ivec2(slice, offset + i), 0).xy : vec2(1.0, 0.0);
  int level = kChunkLevels + 1;
  for (int count = rounded / 2; count >= 1; count /= 2) {
    int at = highOffset(rounded, level);
    for (int i = 0; i < count; ++i) {
      vec2 range = vec2(min(node[2 * i].x, node[2 * i + 1].x), max(node[2 * i].y, node[2 * i + 1].y));
      node[i] = range;
      imageStore(high, ivec2(slice, at + i), vec4(range, 0.0, 0.0));
    }
    ++level;
  }
}
