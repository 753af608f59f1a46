// Surface light through the medium, exposure, tone map, coding.
// In: radiance (RGBA32F), scatter (RGBA32F: RGB in-scattered radiance, A transmittance), both of the picture's size.
// Metered: MeteredBlock, bound where METERED is set.
// Out: RGBA8 unorm, sRGB-coded here.  picture = srgb(toneMap(exposure (color T + scatter)))
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "engine/include/encode.glsl"
#include "engine/include/tonemap.glsl"
#include "shared/exposure.h"

layout(constant_id = 0) const bool HAS_SCATTER = false;
layout(constant_id = 1) const bool METERED = false;  // the exposure is a factor on what exposure_adapt.comp has found

layout(push_constant) uniform Push { float exposure; };
layout(binding = 0) uniform sampler2D colorTarget;
layout(binding = 1) uniform sampler2D scatterTarget;
layout(binding = 2, scalar) readonly buffer Metered { MeteredBlock metered; };

layout(location = 0) out vec4 outPicture;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 color = texelFetch(colorTarget, pixel, 0).rgb;
  if (HAS_SCATTER) {
    vec4 scatter = texelFetch(scatterTarget, pixel, 0);
    color = color * scatter.a + scatter.rgb;
  }
  float factor = METERED ? exposure * exp2(metered.logFactor) : exposure;
  outPicture = vec4(srgbFromLinear(toneMap(factor * color)), 1.0);
}
