// One march per pixel through a sun's shadow map: the plain reference.
// Inputs: scene depth (D32, reversed), shadow map (D32 array, layer 0). Output: RGBA32F, RGB in-scattered radiance (added to what
// the lights before have scattered), A transmittance to the surface.
// Equation: sigma_s int_0^s exp(-sigma_t t) p V E dt (Toth and Umenhoffer 2009 for the march; Klehm et al. 2014, equation 1).
// Deviation that makes the march its best self: stages/march.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/portable.h"
#include "lib/cube_map.glsl"
#include "lib/medium.glsl"
#include "techniques/ray_march/ray_march_blocks.h"
#include "stages/rays.glsl"
#include "stages/noise.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const bool kFirstLight = true;  // the only light: writes instead of adding
layout(binding = 0, scalar) uniform Frame { RayMarchBlock frame; };
layout(binding = 1, scalar) uniform Light { SunBlock sun; };
layout(binding = 2) uniform sampler2D sceneDepth;
layout(binding = 3) uniform sampler2DArray shadowMap;
layout(binding = 4, rgba32f) uniform image2D scatter;
layout(constant_id = 1) const bool kCookies = false;  // some light of this kind has one
layout(binding = 5, scalar) uniform Cookie { CookieBlock marchCookie; };
layout(binding = 6) uniform sampler2DArray cookieImage;

#define TY_COOKIES kCookies
#include "stages/march_cookie.glsl"
#include "stages/march.glsl"

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(pixel, uvec2(imageSize(scatter))))) return;
  vec3 direction = rayDirection(frame.rays, pixel);
  float perAxial = length(direction);
  direction /= perAxial;
  float end = perAxial * axialDistance(frame.rays, texelFetch(sceneDepth, ivec2(pixel), 0).x);
  float sigma_t = frame.rays.sigma_t;

  vec3 step_ = shadowStep(sun, direction);
  vec2 interval = shadowedPart(sun, step_, end);
  vec3 integral = vec3(transmittanceIntegral(sigma_t, 0.0, end));
  float offset = opaque(frame.march.jitter) == kJitterWhite ? whiteNoise(uvec3(pixel, frame.rays.frameIndex)) : 0.5;
  if (hasCookie()) {
    integral = colouredMarch(sun, shadowMap, direction, end, sigma_t, opaque(frame.march.steps), offset,
                             opaque(frame.march.march_spacing) == kSpacingTransmittance);
  } else if (interval.y > interval.x) {
    float blocked = opaque(frame.march.march_spacing) == kSpacingTransmittance
                        ? blockedByTransmittance(sun, shadowMap, step_, interval, sigma_t, opaque(frame.march.steps), offset)
                        : blockedByDistance(sun, shadowMap, step_, interval, sigma_t, opaque(frame.march.steps), offset);
    integral -= transmittanceIntegral(sigma_t, interval.x, interval.y) * blocked;
  }
  float sigma_s = frame.rays.albedo * sigma_t;
  float phase = phaseHenyeyGreenstein(dot(direction, sun.towards), opaque(frame.rays.g));
  vec3 radiance = sigma_s * phase * max(integral, vec3(0.0)) * sun.irradiance;
  if (kFirstLight)
    imageStore(scatter, ivec2(pixel), vec4(radiance, exp(-sigma_t * end)));
  else
    imageStore(scatter, ivec2(pixel), imageLoad(scatter, ivec2(pixel)) + vec4(radiance, 0.0));
}
