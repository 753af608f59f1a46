// Lights the G-buffer. The first pass (BASE) writes sky, emission, the sky's light, all unshadowed lights and up to
// four
// shadowed ones; passes for further shadowed lights add to it.
// In: G-buffer (gbuffer.frag), depth (D32, reversed), shadow maps (D32, or four moments). Out: RGBA32F radiance, linear; A is 1.
// Equation: glTF 2.0, appendix B.2 (brdf.glsl), summed over KHR_lights_punctual lights (lights.glsl).
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require
#include "shared/light.h"
#include "shared/sky.h"
#include "shared/view.h"

layout(constant_id = 0) const bool BASE = true;
layout(constant_id = 1) const int SHADOW_SLOTS = 4;
layout(constant_id = 3) const uint SHADOW_MAPS = 0u;  // 0 depths, 1 quantised moments, 2 moments
layout(constant_id = 4) const bool COOKIES = true;    // false: no light has one

layout(push_constant, scalar) uniform Push { uint firstUnshadowed, unshadowedCount; };
layout(binding = 0, scalar) uniform ViewUniform { ViewBlock view; };
layout(binding = 1, scalar) uniform ShadowedLights { LightBlock shadowedLights[kShadowSlots]; };
layout(binding = 2) uniform sampler2D baseTarget;
layout(binding = 3) uniform sampler2D normalTarget;
layout(binding = 4) uniform sampler2D emissiveTarget;
layout(binding = 5) uniform sampler2D depthTarget;
layout(binding = 6) uniform sampler2DArray shadowMap0;
layout(binding = 7) uniform sampler2DArray shadowMap1;
layout(binding = 8) uniform sampler2DArray shadowMap2;
layout(binding = 9) uniform sampler2DArray shadowMap3;
layout(binding = 10, scalar) readonly buffer Lights { LightBlock lights[]; };
layout(binding = 11) uniform sampler2DArray cookies;
layout(binding = 12, scalar) uniform SkyUniform { SkyBlock sky; };
layout(binding = 13) uniform sampler2DArray skyMaps;

layout(location = 0) out vec4 outColor;

#include "engine/include/encode.glsl"
#include "engine/include/lights.glsl"
#include "engine/include/sky.glsl"

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(depthTarget, pixel, 0).r;
  vec2 ndc = gl_FragCoord.xy / vec2(view.size) * 2.0 - 1.0;
  // Depth 0 is the far plane: finite, so sky pixels have a position too, and their direction comes from it.
  vec4 fromClip = view.viewFromClip * vec4(ndc, depth, 1.0);
  vec3 position = (view.worldFromView * vec4(fromClip.xyz / fromClip.w, 1.0)).xyz;
  vec4 coded = texelFetch(normalTarget, pixel, 0);
  vec3 normal = unitFromOct(coded.xy);
  vec2 visible = vec2(0.0);
  if (BASE) visible = skyVisibilityOfQuad(position, normal, depth != 0.0 && coded.z < 0.75 && opaque(sky.strength) > 0.0);
  if (depth == 0.0) {
    outColor = vec4(BASE ? skyRadiance(view, normalize(position - view.eye)) : vec3(0.0), 1.0);
    return;
  }
  vec4 base = texelFetch(baseTarget, pixel, 0);
  vec3 color = BASE ? texelFetch(emissiveTarget, pixel, 0).rgb : vec3(0.0);
  if (coded.z < 0.75) {  // above: unlit
    Surface s = makeSurface(position, normal, view.eye, base.rgb, coded.z * 2.0, coded.w, base.a);
    if (BASE) color += reflectSky(view, s, visible);
    color += reflectLights(s, firstUnshadowed, unshadowedCount);
  }
  outColor = vec4(color, 1.0);
}
