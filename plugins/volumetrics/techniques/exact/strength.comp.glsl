// What light each column carries, relative to the light's: cone of a spot light, cookie, filtered over the column's footprint. Stored is its mean
// from the start of a block of columns up to and with each: the last column of a block has the block's own. An invocation a block of a row.
// Inputs: Slice buffer; the light's cookie (linear, all mips). Output: RGBA16 unorm, slices x columns; r alone where there is no cookie.
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

layout(local_size_x = 32) in;
layout(binding = 1, scalar) uniform Light { RectifiedLightBlock light; };
layout(binding = 2, scalar) readonly buffer Slices { Slice slices[]; };
layout(binding = 3) uniform sampler2DArray cookieImage;
layout(binding = 4) uniform writeonly image2DArray strengths;

#include "stages/rows.glsl"
#include "stages/light_rays.glsl"
#include "stages/cookie.glsl"
#include "stages/strength.glsl"
#include "techniques/exact/order_rows.glsl"

void main() {
  int slice = int(gl_GlobalInvocationID.x);
  int shift = rowShift();
  int first = int(gl_WorkGroupID.y) << shift;
  int last = min(first + (1 << shift), int(totalColumns()));
  if (slice >= int(light.map.slices)) return;
  Slice s = slices[slice];
  vec3 sum = vec3(0.0);
  for (int column = first; column < last; ++column) {
    sum += columnStrength(s, float(slice) + 0.5, float(column));
    imageStore(strengths, ivec3(slice, column, 0), vec4(sum / float(column - first + 1), 0.0));
  }
}
