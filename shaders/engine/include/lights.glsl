// All lights' contribution to a surface. The includer declares (with these names): `LightBlock lights[]`, the specialization
// constant SHADOW_SLOTS (0..4), the samplers shadowMap0..3, and fills a LightRange.
// Lights with a map come in slots: the light of slot i is lights[firstShadowed + i] and its map is shadowMap<i>. (Samplers
// cannot be indexed: descriptor indexing is missing on software devices, and so each slot is written out.)
#ifndef TYNDALL_LIGHTS_GLSL
#define TYNDALL_LIGHTS_GLSL
#include "engine/include/brdf.glsl"
#include "engine/include/shadow.glsl"

struct LightRange {
  uint firstShadowed, shadowedCount;      // shadowedCount <= SHADOW_SLOTS
  uint firstUnshadowed, unshadowedCount;
};

vec3 directionTo(uint index, vec3 position) {
  return lights[index].kind == kLightDirectional ? -lights[index].direction : normalize(lights[index].position - position);
}

// Irradiance on a plane that faces the light at `position`, without shadow. KHR_lights_punctual: inverse square, the
// range's window (recommended there, after Karis 2013, Real Shading in Unreal Engine 4, equation 9) and the cone.
vec3 irradianceFrom(uint index, vec3 position) {
  if (lights[index].kind == kLightDirectional) return lights[index].intensity;
  vec3 to = lights[index].position - position;
  // A point on the light itself would give infinity: the inverse square ends at 1 mm.
  float d2 = max(dot(to, to), 1e-6);
  float attenuation = 1.0 / d2;
  float range = lights[index].range;
  if (range > 0.0) {
    float q = d2 / (range * range);
    attenuation *= clamp(1.0 - q * q, 0.0, 1.0);
  }
  if (lights[index].kind == kLightSpot) {
    float cosine = dot(lights[index].direction, -to) * inversesqrt(d2);
    float cone = clamp(cosine * lights[index].spotScale + lights[index].spotOffset, 0.0, 1.0);
    attenuation *= cone * cone;
  }
  return lights[index].intensity * attenuation;
}

#define TY_SHADOW_SLOT(i)                                                                               \
  if (SHADOW_SLOTS > i && range.shadowedCount > i) {                                                    \
    uint index = range.firstShadowed + i;                                                               \
    vec4 place = shadowPlace(index, s.position, s.normal, directionTo(index, s.position));              \
    lit[i] = shadowFilter(shadowMap##i, lights[index].shadowSize, place);                               \
  }

vec3 reflectLights(Surface s, LightRange range) {
  vec4 lit = vec4(1.0);
  TY_SHADOW_SLOT(0)
  TY_SHADOW_SLOT(1)
  TY_SHADOW_SLOT(2)
  TY_SHADOW_SLOT(3)
  vec3 sum = vec3(0.0);
  uint count = range.shadowedCount + range.unshadowedCount;
  for (uint i = 0u; i < count; ++i) {
    bool shadowed = i < range.shadowedCount;
    uint index = shadowed ? range.firstShadowed + i : range.firstUnshadowed + i - range.shadowedCount;
    float visible = shadowed ? lit[min(i, 3u)] : 1.0;
    vec3 irradiance = irradianceFrom(index, s.position) * visible;
    sum += irradiance * reflectPunctual(s, directionTo(index, s.position));
  }
  return sum;
}

#endif
