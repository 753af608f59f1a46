// One march per pixel through the light of a spot or point light and its shadow map.
// Inputs: scene depth (D32, reversed), shadow map (D32 array; 1 layer, or 6 faces of a point light). Output: RGBA32F, RGB in-scattered
// radiance (added to what the lights before have scattered), A transmittance to the surface.
// Equation: sigma_s int_0^s exp(-sigma_t (t + d)) p V I/d^2 dt by equal angles at the light (Kulla and Fajardo 2012, "Importance Sampling
// Techniques for Path Tracing in Participating Media", section 4.1; see stages/march_local.glsl).
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"
#include "lib/cube_map.glsl"
#include "lib/medium.glsl"
#include "lib/local_light.glsl"
#include "techniques/ray_march/ray_march_blocks.h"
#include "stages/rays.glsl"
#include "stages/noise.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const bool kFirstLight = true;  // the only light: writes instead of adding
layout(binding = 0, scalar) uniform Frame { RayMarchBlock frame; };
layout(binding = 1, scalar) uniform Light { LocalBlock light; };
layout(binding = 2) uniform sampler2D sceneDepth;
layout(binding = 3) uniform sampler2DArray shadowMap;
layout(binding = 4, rgba32f) uniform image2D scatter;
layout(constant_id = 1) const bool kCookies = false;  // some light of this kind has one
layout(binding = 5, scalar) uniform Cookie { CookieBlock marchCookie; };
layout(binding = 6) uniform sampler2DArray cookieImage;

#define TY_COOKIES kCookies
#include "stages/march_cookie.glsl"
#include "stages/march_local.glsl"

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(pixel, uvec2(imageSize(scatter))))) return;
  vec3 direction = rayDirection(frame.rays, pixel);
  float perAxial = length(direction);
  direction /= perAxial;
  float end = perAxial * axialDistance(frame.rays, texelFetch(sceneDepth, ivec2(pixel), 0).x);
  float sigma_t = frame.rays.sigma_t;

  LocalRay ray = localRay(light, direction, end);
  float offset = opaque(frame.march.jitter) == kJitterWhite ? whiteNoise(uvec3(pixel, frame.rays.frameIndex)) : 0.5;
  vec3 sum = opaque(frame.march.march_spacing) == kSpacingTransmittance
                 ? marchedByAngle(light, shadowMap, ray, sigma_t, opaque(frame.rays.g), opaque(frame.march.steps), offset)
                 : marchedByDistance(light, shadowMap, ray, sigma_t, opaque(frame.rays.g), opaque(frame.march.steps), offset);
  vec3 radiance = frame.rays.albedo * sigma_t * sum;
  if (kFirstLight)
    imageStore(scatter, ivec2(pixel), vec4(radiance, exp(-sigma_t * end)));
  else
    imageStore(scatter, ivec2(pixel), imageLoad(scatter, ivec2(pixel)) + vec4(radiance, 0.0));
}
