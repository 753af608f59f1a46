// What surfaces see of the sky: depth maps from some directions above, each as three nested squares.
#ifndef TYNDALL_SHARED_SKY_H
#define TYNDALL_SHARED_SKY_H
#include "shared/types.h"
TY_SHARED_BEGIN

#ifdef __cplusplus
inline constexpr uint kSkyDirections = 12, kSkyCascades = 3, kSkyTexels = 512;
#else
const uint kSkyDirections = 12, kSkyCascades = 3, kSkyTexels = 512;
#endif

// place = (dot(u, vec4(world, 1)), dot(v, ...)) in [0, 1] inside; depth = dot(depth, ...), 0 nearest the sky.
struct SkyMap {
  vec4 u;
  vec4 v;
  vec4 depth;
  float texel;  // m
  uint layer;
};

struct SkyBlock {
  vec3 directions[kSkyDirections];             // unit, towards the sky, of equal solid angle
  SkyMap maps[kSkyDirections * kSkyCascades];  // finest first, kSkyDirections each; the last covers the level
  float strength;                              // factor on all of the sky's light on surfaces
};

TY_SHARED_END
#endif
