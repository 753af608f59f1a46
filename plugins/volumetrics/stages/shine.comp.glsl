// What light each column carries: the weight of a column for every reference ray, times the strength (and colour) of its light rays
// relative to the light's: cone of a spot light, cookie, filtered over the column's footprint.
// Inputs: Slice buffer; the light's cookie (linear, all mips). Output: RGBA32F array, slices x columns, see stages/channels.glsl.
// Equation: exact-visibility frame, w_k I (weights: Klehm et al. 2014, equation 11).
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

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 1) const int kReferenceRays = 1;
layout(binding = 0, scalar) uniform Frame { RectifiedBlock frame; };
layout(binding = 1, scalar) uniform Light { RectifiedLightBlock light; };
layout(binding = 2, scalar) readonly buffer Slices { Slice slices[]; };
layout(binding = 3) uniform sampler2DArray cookieImage;
layout(binding = 4) uniform writeonly image2DArray weights;

#include "stages/rows.glsl"
#include "stages/reference_rays.glsl"
#include "stages/channels.glsl"
#include "stages/light_rays.glsl"
#include "stages/cookie.glsl"
#include "stages/strength.glsl"

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= int(light.map.slices) || at.y >= int(totalColumns())) return;
  Slice s = slices[at.x];
  float column = float(at.y);
  float slice = float(at.x) + 0.5;
  vec3 strength = columnStrength(s, slice, column);
  float value[kChannelSlots];
  for (int i = 0; i < kChannelSlots; ++i) value[i] = 0.0;
  for (int k = 0; k < kReferenceRays; ++k) {
    float weight = s.last > s.first ? referenceWeight(s, referenceKey(s, k, kReferenceRays), column, column + 1.0) : 0.0;
    for (int c = 0; c < kColours; ++c) value[k * kColours + c] = weight * strength[c];
  }
  for (int i = 0; i < kChannelQuads; ++i)
    imageStore(weights, ivec3(at, i), vec4(value[4 * i], value[4 * i + 1], value[4 * i + 2], value[4 * i + 3]));
}
