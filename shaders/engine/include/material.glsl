// Inputs of the two shaders that shade geometry (gbuffer.frag, transparent.frag), and the glTF material evaluated there.
#ifndef TYNDALL_MATERIAL_GLSL
#define TYNDALL_MATERIAL_GLSL
#include "shared/surface.h"
#include "shared/view.h"

layout(binding = 0, scalar) uniform ViewUniform { ViewBlock view; };
layout(binding = 1, scalar) readonly buffer Instances { InstanceBlock instances[]; };
layout(binding = 2, scalar) readonly buffer Materials { MaterialBlock materials[]; };
layout(binding = 3) uniform sampler2D baseColorMap;          // sRGB
layout(binding = 4) uniform sampler2D alphaMap;              // the same image, mip 0 only, bilinear
layout(binding = 5) uniform sampler2D metallicRoughnessMap;  // G roughness, B metallic
layout(binding = 6) uniform sampler2D normalMap;
layout(binding = 7) uniform sampler2D occlusionMap;          // R
layout(binding = 8) uniform sampler2D emissiveMap;           // sRGB

layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec3 inNormal;
layout(location = 2) in vec4 inTangent;
layout(location = 3) in vec2 inUv;
layout(location = 4) in vec4 inColor;
layout(location = 5) flat in uint inInstance;

struct MaterialSample {
  vec4 baseColor;
  vec3 normal;      // unit, world, on the visible side of double-sided surfaces
  vec3 emissive;
  float metallic, roughness, occlusion;
  bool unlit;
};

vec2 transformUv(UvTransform t, vec2 uv) { return vec2(dot(t.u, vec3(uv, 1.0)), dot(t.v, vec3(uv, 1.0))); }

// The alpha test sees the full-resolution image, bilinear: the shadow pass (caster_mask.frag) does the same, and so
// does a ray tracer, so that all agree on where a leaf ends. Only colours use mipmaps.
bool cutOut(uint material) {
  vec2 uv = transformUv(materials[material].baseColorUv, inUv);
  return textureLod(alphaMap, uv, 0.0).a * materials[material].baseColor.a * inColor.a < materials[material].alphaCutoff;
}

vec3 shadingNormal(uint material, bool flip) {
  vec3 n = normalize(inNormal);
  if ((materials[material].flags & kMaterialNormalMap) != 0u) {
    vec3 t = inTangent.xyz - n * dot(n, inTangent.xyz);
    float length2 = dot(t, t);
    if (length2 > 1e-12) {
      t *= inversesqrt(length2);
      vec3 b = cross(n, t) * inTangent.w;
      vec3 m = texture(normalMap, transformUv(materials[material].normalUv, inUv)).xyz * 2.0 - 1.0;
      m.xy *= materials[material].normalScale;
      n = normalize(t * m.x + b * m.y + n * m.z);
    }
  }
  return flip ? -n : n;
}

MaterialSample sampleMaterial() {
  uint material = instances[inInstance].material;
  uint flags = materials[material].flags;
  bool front = gl_FrontFacing != (instances[inInstance].mirrored != 0u);
  MaterialSample s;
  s.baseColor = texture(baseColorMap, transformUv(materials[material].baseColorUv, inUv)) * materials[material].baseColor * inColor;
  s.normal = shadingNormal(material, (flags & kMaterialDoubleSided) != 0u && !front);
  vec4 mr = texture(metallicRoughnessMap, transformUv(materials[material].metallicRoughnessUv, inUv));
  s.metallic = clamp(mr.b * materials[material].metallic, 0.0, 1.0);
  s.roughness = clamp(mr.g * materials[material].roughness, 0.0, 1.0);
  float occlusion = texture(occlusionMap, transformUv(materials[material].occlusionUv, inUv)).r;
  s.occlusion = 1.0 + materials[material].occlusionStrength * (occlusion - 1.0);
  s.emissive = texture(emissiveMap, transformUv(materials[material].emissiveUv, inUv)).rgb * materials[material].emissive;
  s.unlit = (flags & kMaterialUnlit) != 0u;
  return s;
}

#endif
