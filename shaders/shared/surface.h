// What a draw needs to know: where the object stands and what it is made of (glTF 2.0 metallic-roughness).
#ifndef TYNDALL_SHARED_SURFACE_H
#define TYNDALL_SHARED_SURFACE_H
#include "shared/types.h"
TY_SHARED_BEGIN

#ifdef __cplusplus
inline constexpr uint kMaterialDoubleSided = 1, kMaterialUnlit = 2;
#else
const uint kMaterialDoubleSided = 1, kMaterialUnlit = 2;
#endif

struct InstanceBlock {
  mat4 worldFromObject;
  vec3 normalX, normalY, normalZ;  // columns of the normal matrix (cofactors of worldFromObject), not normalised
  uint mirrored;                   // 1: the transform turns triangles over, so front faces are the clockwise ones
};

// Bits of the textures a material has; shaders are specialized on them.
#ifdef __cplusplus
inline constexpr uint kBaseColorMap = 1, kMetallicRoughnessMap = 2, kNormalMap = 4;
inline constexpr uint kOcclusionMap = 8, kEmissiveMap = 16;
#else
const uint kBaseColorMap = 1, kMetallicRoughnessMap = 2, kNormalMap = 4, kOcclusionMap = 8, kEmissiveMap = 16;
#endif

// One texture's transform: uv' = (dot(u, vec3(uv, 1)), dot(v, vec3(uv, 1))).
struct UvTransform {
  vec3 u;
  vec3 v;
};

struct MaterialBlock {
  vec4 baseColor;  // linear
  vec3 emissive;
  float metallic;
  float roughness;
  float normalScale;
  float occlusionStrength;
  float alphaCutoff;
  uint flags;  // kMaterial...
  UvTransform baseColorUv, metallicRoughnessUv, normalUv, occlusionUv, emissiveUv;
};

TY_SHARED_END
#endif
