// What a draw needs to know: where the object stands and what it is made of (glTF 2.0 metallic-roughness).
#ifndef TYNDALL_SHARED_SURFACE_H
#define TYNDALL_SHARED_SURFACE_H
#include "shared/types.h"
TY_SHARED_BEGIN

#ifdef __cplusplus
inline constexpr uint kMaterialMask = 1, kMaterialDoubleSided = 2, kMaterialUnlit = 4, kMaterialNormalMap = 8;
#else
const uint kMaterialMask = 1, kMaterialDoubleSided = 2, kMaterialUnlit = 4, kMaterialNormalMap = 8;
#endif

struct InstanceBlock {
  mat4 worldFromObject;
  vec3 normalX, normalY, normalZ;  // columns of the normal matrix (cofactors of worldFromObject), not normalised
  uint material;
  uint mirrored;                   // 1: the transform turns triangles over, so front faces are the clockwise ones
};

// One texture's transform: uv' = (dot(u, vec3(uv, 1)), dot(v, vec3(uv, 1))).
struct UvTransform {
  vec3 u;
  vec3 v;
};

struct MaterialBlock {
  vec4 baseColor;                  // linear
  vec3 emissive;
  float metallic;
  float roughness;
  float normalScale;
  float occlusionStrength;
  float alphaCutoff;
  uint flags;                      // kMaterial...
  UvTransform baseColorUv, metallicRoughnessUv, normalUv, occlusionUv, emissiveUv;
};

TY_SHARED_END
#endif
