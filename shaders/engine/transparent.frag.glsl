// Alpha-blended surfaces, lit forward with the same functions as lighting.frag. Drawn back to front over the lit opaque
// picture and before the effect's composition: they get the fog of the opaque surface behind them.
// Out: RGBA32F radiance and coverage, blended by the pipeline (source alpha, one minus source alpha).
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require
#include "shared/light.h"
#include "shared/sky.h"
#include "engine/include/material.glsl"

layout(constant_id = 1) const int SHADOW_SLOTS = 4;
layout(constant_id = 3) const uint SHADOW_MAPS = 0u;  // 0 depths, 1 quantised moments, 2 moments
layout(constant_id = 4) const bool COOKIES = true;    // false: no light has one

layout(push_constant, scalar) uniform Push { uint firstUnshadowed, unshadowedCount; };
layout(binding = 9, scalar) uniform ShadowedLights { LightBlock shadowedLights[kShadowSlots]; };
layout(binding = 10) uniform sampler2DArray shadowMap0;
layout(binding = 11) uniform sampler2DArray shadowMap1;
layout(binding = 12) uniform sampler2DArray shadowMap2;
layout(binding = 13) uniform sampler2DArray shadowMap3;
layout(binding = 14, scalar) readonly buffer Lights { LightBlock lights[]; };
layout(binding = 15) uniform sampler2DArray cookies;
layout(binding = 16, scalar) uniform SkyUniform { SkyBlock sky; };
layout(binding = 17) uniform sampler2DArray skyMaps;

layout(location = 0) out vec4 outColor;

#include "engine/include/lights.glsl"
#include "engine/include/sky.glsl"

void main() {
  MaterialSample m = sampleMaterial();
  vec3 color = m.baseColor.rgb;
  if (!m.unlit) {
    Surface s = makeSurface(inPosition, m.normal, view.eye, m.baseColor.rgb, m.metallic, m.roughness, m.occlusion);
    color = m.emissive + reflectSky(view, s, skyVisibility(inPosition, m.normal)) +
            reflectLights(s, firstUnshadowed, unshadowedCount);
  }
  outColor = vec4(color, clamp(m.baseColor.a, 0.0, 1.0));
}
