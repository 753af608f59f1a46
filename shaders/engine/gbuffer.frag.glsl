// G-buffer of opaque and alpha-tested surfaces.
// Out 0: RGBA8 sRGB   base colour, A occlusion
// Out 1: RGBA16 unorm XY normal (octahedral, world), Z metallic / 2 or 1 for unlit surfaces, W roughness
// Out 2: B10G11R11    emitted radiance; of an unlit surface its colour (KHR_materials_unlit)
// glTF 2.0, section 3.9 (materials).
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require
#include "engine/include/encode.glsl"
#include "engine/include/material.glsl"

layout(constant_id = 0) const bool MASK = false;

layout(location = 0) out vec4 outBase;
layout(location = 1) out vec4 outNormal;
layout(location = 2) out vec3 outEmissive;

void main() {
  // Sampled before the discard: derivatives are undefined after it.
  MaterialSample s = sampleMaterial();
  if (MASK) {
    if (cutOut()) discard;
  }
  outBase = vec4(clamp(s.baseColor.rgb, 0.0, 1.0), s.occlusion);
  outNormal = vec4(octFromUnit(s.normal), s.unlit ? 1.0 : s.metallic * 0.5, s.roughness);
  // 65024 is the largest finite value of the format; more would store infinity.
  outEmissive = min(s.unlit ? s.baseColor.rgb : s.emissive, vec3(65024.0));
}
