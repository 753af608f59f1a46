// A light as the engine's shaders see it (KHR_lights_punctual) with the matrices of its shadow map.
#ifndef TYNDALL_SHARED_LIGHT_H
#define TYNDALL_SHARED_LIGHT_H
#include "shared/lamp.h"
#include "shared/types.h"
TY_SHARED_BEGIN

#ifdef __cplusplus
inline constexpr uint kLightDirectional = 0, kLightSpot = 1, kLightPoint = 2;
#else
const uint kLightDirectional = 0, kLightSpot = 1, kLightPoint = 2;
#endif

struct LightCore {
  vec3 position;  // spot, point: world, m
  uint kind;
  vec3 direction;              // directional, spot: unit, the way the light travels
  float range;                 // m; 0: unlimited
  vec3 intensity;              // colour times intensity: lux (directional) or candela
  float coneOuter, coneScale;  // ConeFalloff (shared/lamp.h); 1 and 1 of a light without a cone
};

// The image that a light shines through: a part of the array of all lights' cookies.
struct CookieBlock {
  mat4 cookieFromWorld;  // x, y over w: -1 to 1 over the image, y up; point lights: into the frame of the faces
  uint faces;            // 0: none
  uint layer;            // the first of them
  uint repeats;          // bit 0 along x, bit 1 along y; else the image's border goes on
};

struct LightBlock {
  LightCore core;
  float texelSize;   // directional: m per shadow map texel; others: m per texel at 1 m along the face's axis
  float shadowSize;  // texels a side
  float depthCurve;  // far over near distance of the map, less 1; 0: orthographic (engine/include/linear_depth.glsl)
  mat4 clipFromWorld[6];  // of each face; one, or six for a point light
  CookieBlock cookie;
  uint unused[13];  // kShadowSlots
};

// Lights that one pass shadows; an array of so many is a whole multiple of any offset alignment that a uniform buffer
// asks for.
#ifdef __cplusplus
inline constexpr uint kShadowSlots = 4;
static_assert(kShadowSlots * sizeof(LightBlock) % 256 == 0);
#else
const uint kShadowSlots = 4;
#endif

TY_SHARED_END
#endif
