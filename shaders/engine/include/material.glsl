// Inputs of the two shaders that shade geometry (gbuffer.frag, transparent.frag), and the glTF material evaluated
// there.
#ifndef TYNDALL_MATERIAL_GLSL
#define TYNDALL_MATERIAL_GLSL
#include "shared/surface.h"
#include "shared/view.h"
#include "engine/include/opaque.glsl"

layout(binding = 0, scalar) uniform ViewUniform { ViewBlock view; };
// A uniform block and not an array in a storage buffer: llvmpipe loads zeros from storage buffers in the helper
// invocations
// beyond a triangle's edge, and texture coordinates made from them break the choice of mip level there.
layout(binding = 2, scalar) uniform Material { MaterialBlock material; };
layout(binding = 3) uniform sampler2D baseColorMap;          // sRGB
layout(binding = 4) uniform sampler2D alphaMap;              // the same image, mip 0 only, bilinear
layout(binding = 5) uniform sampler2D metallicRoughnessMap;  // G roughness, B metallic
layout(binding = 6) uniform sampler2D normalMap;
layout(binding = 7) uniform sampler2D occlusionMap;          // R
layout(binding = 8) uniform sampler2D emissiveMap;           // sRGB

// Which maps the material has (k...Map); the others are not looked up and stand for 1.
layout(constant_id = 2) const uint TEXTURES = 31u;

layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec3 inNormal;
layout(location = 2) in vec4 inTangent;
layout(location = 3) in vec2 inUv;
layout(location = 4) in vec4 inColor;
layout(location = 5) flat in uint inMirrored;

struct MaterialSample {
  vec4 baseColor;
  vec3 normal;      // unit, world, on the visible side of double-sided surfaces
  vec3 emissive;
  float metallic, roughness, occlusion;
  bool unlit;
};

vec2 transformUv(UvTransform t, vec2 uv) { return vec2(dot(t.u, vec3(uv, 1.0)), dot(t.v, vec3(uv, 1.0))); }

bool has(uint map) { return (TEXTURES & map) != 0u; }

// The alpha test sees the full-resolution image, bilinear: the shadow pass (caster_mask.frag) does the same, and so
// does a ray tracer, so that all agree on where a leaf ends. Only colours use mipmaps.
bool cutOut() {
  float alpha = has(kBaseColorMap) ? textureLod(alphaMap, transformUv(material.baseColorUv, inUv), 0.0).a : 1.0;
  return alpha * material.baseColor.a * inColor.a < material.alphaCutoff;
}

vec3 shadingNormal(bool flip) {
  vec3 n = normalize(inNormal);
  if (has(kNormalMap)) {
    vec3 m = texture(normalMap, transformUv(material.normalUv, inUv)).xyz * 2.0 - 1.0;
    m.xy *= material.normalScale;
    vec3 t = inTangent.xyz - n * dot(n, inTangent.xyz);
    float length2 = dot(t, t);
    if (length2 > 1e-12) {
      t *= inversesqrt(length2);
      n = normalize(t * m.x + cross(n, t) * inTangent.w * m.y + n * m.z);
    }
  }
  return flip ? -n : n;
}

MaterialSample sampleMaterial() {
  bool front = gl_FrontFacing != (inMirrored != 0u);
  MaterialSample s;
  s.baseColor = material.baseColor * inColor;
  if (has(kBaseColorMap)) s.baseColor *= texture(baseColorMap, transformUv(material.baseColorUv, inUv));
  s.normal = shadingNormal((opaque(material.flags) & kMaterialDoubleSided) != 0u && !front);
  s.metallic = material.metallic;
  s.roughness = material.roughness;
  if (has(kMetallicRoughnessMap)) {
    vec4 mr = texture(metallicRoughnessMap, transformUv(material.metallicRoughnessUv, inUv));
    s.metallic *= mr.b;
    s.roughness *= mr.g;
  }
  s.occlusion = 1.0;
  if (has(kOcclusionMap)) {
    float occlusion = texture(occlusionMap, transformUv(material.occlusionUv, inUv)).r;
    s.occlusion = 1.0 + material.occlusionStrength * (occlusion - 1.0);
  }
  s.emissive = material.emissive;
  if (has(kEmissiveMap)) s.emissive *= texture(emissiveMap, transformUv(material.emissiveUv, inUv)).rgb;
  s.unlit = (opaque(material.flags) & kMaterialUnlit) != 0u;
  return s;
}

#endif
