// The camera and the sky of one frame. View space looks down -Z, +Y up; clip space is Vulkan's; depth is reversed.
#ifndef TYNDALL_SHARED_VIEW_H
#define TYNDALL_SHARED_VIEW_H
#include "shared/types.h"
TY_SHARED_BEGIN

struct ViewBlock {
  mat4 viewFromWorld;
  mat4 worldFromView;
  mat4 clipFromView;
  mat4 viewFromClip;
  mat4 clipFromWorld;
  vec3 eye;     // world, m
  float znear;  // m along the optical axis, depth 1
  uvec2 size;   // of the picture, pixels
  float zfar;   // m along the optical axis, depth 0
  float seconds;
  // The analytic sky (engine/render/sky.cpp derives it from the suns). Radiances in the unit of lux per steradian.
  vec3 skyZenith;
  vec3 skyHorizon;
  vec3 ground;         // below the horizon
  vec3 towardsSun;     // unit, world
  vec3 sunIrradiance;  // lux; 0: no sun, no glow
};

TY_SHARED_END
#endif
