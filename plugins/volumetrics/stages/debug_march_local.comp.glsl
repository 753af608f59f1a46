// Single scattering of one spot or point light by a dense march through its shadow map: what debug view "difference" compares with.
// Inputs: scene depth (D32, reversed), shadow map (D32 array, one layer a face). Output: RGBA32F, RGB radiance, added up over lights.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"
#include "lib/cube_map.glsl"
#include "lib/medium.glsl"
#include "lib/local_light.glsl"
#include "stages/blocks.h"
#include "stages/rays.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, scalar) uniform Frame { RayBlock rays; };
layout(binding = 1, scalar) uniform Light { LocalBlock light; };
layout(binding = 2) uniform sampler2D sceneDepth;
layout(binding = 3) uniform sampler2DArray shadowMap;
layout(binding = 4, rgba32f) uniform image2D dense;
layout(constant_id = 1) const bool kCookies = false;
layout(binding = 5, scalar) uniform Cookie { CookieBlock marchCookie; };
layout(binding = 6) uniform sampler2DArray cookieImage;

#define TY_COOKIES kCookies
#include "stages/march_cookie.glsl"
#include "stages/march_local.glsl"

const int kMostSteps = 8192;

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(pixel, uvec2(imageSize(dense))))) return;
  vec3 direction = rayDirection(rays, pixel);
  float perAxial = length(direction);
  direction /= perAxial;
  float end = perAxial * axialDistance(rays, texelFetch(sceneDepth, ivec2(pixel), 0).x);
  vec3 sum = denselyMarchedLocal(light, shadowMap, direction, end, rays.sigma_t, opaque(rays.g), kMostSteps);
  imageStore(dense, ivec2(pixel), imageLoad(dense, ivec2(pixel)) + vec4(rays.albedo * rays.sigma_t * sum, 0.0));
}
