// A plain analytic sky: zenith-to-horizon gradient and a glow around the sun. Artistic, but in proportion to the sun:
// its
// radiances come from engine/render/sky.cpp. The sun's own disc is not drawn (a punctual light has no size).
#ifndef TYNDALL_SKY_GLSL
#define TYNDALL_SKY_GLSL
#include "shared/view.h"
#include "engine/include/sky_visibility.glsl"

// Radiance from world direction `d` (unit) without the glow.
vec3 skyGradient(ViewBlock view, vec3 d) {
  // Optical path through air grows about as 1/sin(elevation): the horizon's whiteness fades in the first few degrees.
  float h = clamp(d.y, 0.0, 1.0);
  vec3 above = mix(view.skyHorizon, view.skyZenith, 1.0 - exp2(-6.0 * h));
  // Haze over the ground: the same air that whitens the horizon from above hides the ground towards it.
  vec3 below = mix(view.ground, view.skyHorizon, exp2(12.0 * min(d.y, 0.0)));
  return d.y >= 0.0 ? above : below;
}

// Two Henyey-Greenstein lobes stand for the aureole: Henyey and Greenstein 1941, Diffuse Radiation in the Galaxy.
float aureole(float cosine) {
  const float wide = 0.76, narrow = 0.97;
  vec2 g = vec2(wide, narrow);
  vec2 d = 1.0 + g * g - 2.0 * g * cosine;
  vec2 lobes = (1.0 - g * g) / (4.0 * 3.14159265 * d * sqrt(d));
  return 0.02 * lobes.x + 0.0004 * lobes.y;
}

vec3 skyRadiance(ViewBlock view, vec3 d) {
  float glow = aureole(dot(d, view.towardsSun)) * smoothstep(-0.1, 0.0, d.y);
  return skyGradient(view, d) + view.sunIrradiance * glow;
}

// What the gradient above gives to surfaces at sky.strength 1.
const float kSkyShare = 0.5;

// Radiance reflected from the sky's light: Lambert under the hemisphere's mean plus the specular lobe's mean direction.
// `s` as in brdf.glsl, `visible` as in sky_visibility.glsl. Both are shadowed by the cosine-weighted visibility: a mirror's own direction is not looked up.
vec3 reflectSky(ViewBlock view, Surface s, vec2 visible) {
  vec3 mean = mix(view.skyHorizon, view.skyZenith, 0.5);
  vec3 around = mix(visible.y * view.ground, visible.x * mean, 0.5 + 0.5 * s.normal.y);
  float nDotV = clamp(dot(s.normal, s.towardsEye), 0.0, 1.0);
  float roughness = sqrt(s.alpha);
  vec3 towards = reflect(-s.towardsEye, s.normal);
  vec3 mirrored = skyGradient(view, towards) * mix(visible.y, visible.x, smoothstep(-0.2, 0.2, towards.y));
  vec3 specular = specularAlbedo(s.f0, roughness, nDotV) * mix(mirrored, around, roughness);
  return sky.strength * kSkyShare * s.occlusion * (s.diffuse * around + specular);
}

#endif
