// All lights' contribution to a surface. The includer declares (with these names): the uniform block's member
// `LightBlock shadowedLights[kShadowSlots]`, the storage buffer's `LightBlock lights[]`, the specialization constant
// SHADOW_SLOTS (0 to kShadowSlots), SHADOW_MAPS and COOKIES (some light has one), the samplers shadowMap0..3 and cookies, and
// `ViewBlock view`.
// Light i of shadowedLights has the map shadowMap<i>: depths, or moments (SHADOW_MAPS, engine/include/moment_shadow.glsl). Slots are written out instead of looped over: samplers cannot be
// indexed
// (descriptor indexing is missing on software devices), and constant indices into a uniform block are the fastest
// loads there.
#ifndef TYNDALL_LIGHTS_GLSL
#define TYNDALL_LIGHTS_GLSL
#include "engine/include/brdf.glsl"
#include "engine/include/moment_shadow.glsl"
#include "engine/include/shadow.glsl"
#include "engine/include/cookie.glsl"
#include "engine/include/opaque.glsl"
#include "lib/portable.h"
#include "lib/local_light.glsl"

vec3 directionTo(LightCore light, vec3 position) {
  return opaque(light.kind) == kLightDirectional ? -light.direction : normalize(light.position - position);
}

// Irradiance on a plane that faces the light at `position`, without shadow. KHR_lights_punctual: inverse square, the
// range's window (recommended there, after Karis 2013, Real Shading in Unreal Engine 4, equation 9) and the cone.
vec3 irradianceFrom(LightCore light, vec3 position) {
  if (opaque(light.kind) == kLightDirectional) return light.intensity;
  vec3 from = position - light.position;
  float own = dot(from, from);
  // A point on the light itself would give infinity.
  float d2 = max(own, kLeastLampDistance * kLeastLampDistance);
  float versine = opaque(light.kind) == kLightSpot ? versineToAxis(from, light.direction, d2, d2 - own) : 0.0;
  return light.intensity * (localAttenuation(d2, opaque(light.range), versine, light.coneOuter, light.coneScale) / d2);
}

#define TY_SHADOW_SLOT(i)                                                                      \
  if (SHADOW_SLOTS > i) {                                                                      \
    vec3 l = directionTo(shadowedLights[i].core, s.position);                                  \
    float lit;                                                                                 \
    if (SHADOW_MAPS == kDepths) {                                                              \
      vec4 place = shadowPlace(i, s.position, s.normal, l, kNormalOffsetTexels);               \
      lit = shadowFilter(shadowMap##i, shadowedLights[i].shadowSize, place);                   \
    } else {                                                                                   \
      lit = momentFilter(shadowMap##i, i, s.position, s.normal, l);                            \
    }                                                                                          \
    vec3 arriving = irradianceFrom(shadowedLights[i].core, s.position);                        \
    if (COOKIES && opaque(shadowedLights[i].cookie.faces) != 0u)                                \
      arriving *= cookieColor(shadowedLights[i].cookie, s.position, footprint);                \
    sum += arriving * lit * reflectPunctual(s, l);                                             \
  }

// Lights of the slots, and `count` unshadowed ones from lights[first] on.
vec3 reflectLights(Surface s, uint first, uint count) {
  vec3 sum = vec3(0.0);
  mat2x3 footprint = COOKIES ? pixelFootprint(s.position, s.normal) : mat2x3(0.0);
  TY_SHADOW_SLOT(0)
  TY_SHADOW_SLOT(1)
  TY_SHADOW_SLOT(2)
  TY_SHADOW_SLOT(3)
  for (uint i = first, end = opaque(first + count); i < end; ++i) {
    LightCore light = lights[i].core;
    vec3 arriving = irradianceFrom(light, s.position);
    if (COOKIES && lights[i].cookie.faces != 0u) arriving *= cookieColor(lights[i].cookie, s.position, footprint);
    sum += arriving * reflectPunctual(s, directionTo(light, s.position));
  }
  return sum;
}

#endif
