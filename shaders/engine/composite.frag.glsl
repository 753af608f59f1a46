// Surface light through the medium, exposure, tone map, coding.
// In: radiance (RGBA32F), scatter (RGBA32F: RGB in-scattered radiance, A transmittance), both of the picture's size.
// Out: RGBA8 unorm, sRGB-coded here.  picture = srgb(toneMap(exposure (color T + scatter)))
#version 460
#extension GL_GOOGLE_include_directive : require
#include "engine/include/encode.glsl"
#include "engine/include/tonemap.glsl"

layout(constant_id = 0) const bool HAS_SCATTER = false;

layout(push_constant) uniform Push { float exposure; };
layout(binding = 0) uniform sampler2D colorTarget;
layout(binding = 1) uniform sampler2D scatterTarget;

layout(location = 0) out vec4 outPicture;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 color = texelFetch(colorTarget, pixel, 0).rgb;
  if (HAS_SCATTER) {
    vec4 scatter = texelFetch(scatterTarget, pixel, 0);
    color = color * scatter.a + scatter.rgb;
  }
  outPicture = vec4(srgbFromLinear(toneMap(exposure * color)), 1.0);
}
