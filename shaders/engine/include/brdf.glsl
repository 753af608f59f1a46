// The glTF 2.0 metallic-roughness surface (appendix B of its specification), for punctual lights and a uniform sky.
#ifndef TYNDALL_BRDF_GLSL
#define TYNDALL_BRDF_GLSL

const float kPi = 3.14159265358979;

struct Surface {
  vec3 position;     // world, m
  vec3 normal;       // unit, world, towards the viewer's side
  vec3 towardsEye;   // unit, world
  vec3 diffuse;      // Lambert albedo
  vec3 f0;           // reflectance at normal incidence
  float alpha;       // GGX width: roughness squared (Burley 2012, Physically Based Shading at Disney, section 5.4)
  float occlusion;   // of the sky's light, [0, 1]
};

// 0.04 is the reflectance of a dielectric of index 1.5. Roughness below 0.045 would make highlights of a punctual light
// narrower than a pixel and up to 1e6 times the diffuse light (Lagarde and de Rousiers 2014, Moving Frostbite to
// Physically Based Rendering, section 3.2.1.1 limits it so).
Surface makeSurface(vec3 position, vec3 normal, vec3 eye, vec3 baseColor, float metallic, float roughness,
                    float occlusion) {
  float r = max(roughness, 0.045);
  return Surface(position, normal, normalize(eye - position), baseColor * (1.0 - metallic),
                 mix(vec3(0.04), baseColor, metallic), r * r, occlusion);
}

// Schlick 1994, An Inexpensive BRDF Model for Physically-Based Rendering, equation 24.
vec3 fresnel(vec3 f0, float vDotH) {
  float m = 1.0 - vDotH;
  float m2 = m * m;
  return f0 + (1.0 - f0) * (m2 * m2 * m);
}

// Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces, equation 33.
float ggx(float alpha, float nDotH) {
  float a2 = alpha * alpha;
  float d = nDotH * nDotH * (a2 - 1.0) + 1.0;
  return a2 / (kPi * d * d);
}

// G / (4 nDotL nDotV) of Smith's height-correlated masking and shadowing: Heitz 2014, Understanding the
// Masking-Shadowing
// Function in Microfacet-Based BRDFs, equation 99, in the form of Lagarde and de Rousiers 2014, listing 2.
float smithVisibility(float alpha, float nDotL, float nDotV) {
  float a2 = alpha * alpha;
  float v = nDotL * sqrt(nDotV * nDotV * (1.0 - a2) + a2);
  float l = nDotV * sqrt(nDotL * nDotL * (1.0 - a2) + a2);
  return 0.5 / max(v + l, 1e-6);
}

// Reflected radiance per unit of irradiance on a plane facing the light: BRDF times nDotL.
vec3 reflectPunctual(Surface s, vec3 towardsLight) {
  float nDotL = dot(s.normal, towardsLight);
  if (nDotL <= 0.0) return vec3(0.0);
  // A normal map may turn the normal away from the eye; the visibility term needs a positive cosine.
  float nDotV = max(dot(s.normal, s.towardsEye), 1e-4);
  vec3 halfway = normalize(towardsLight + s.towardsEye);
  float nDotH = clamp(dot(s.normal, halfway), 0.0, 1.0);
  vec3 f = fresnel(s.f0, clamp(dot(s.towardsEye, halfway), 0.0, 1.0));
  vec3 specular = f * (ggx(s.alpha, nDotH) * smithVisibility(s.alpha, nDotL, nDotV));
  return ((1.0 - f) * s.diffuse / kPi + specular) * nDotL;
}

// Directional albedo of the specular lobe under a uniform sky: the fit of Karis 2014, Physically Based Shading on
// Mobile
// (after Lazarov 2013, Getting More Physical in Call of Duty: Black Ops II).
vec3 specularAlbedo(vec3 f0, float roughness, float nDotV) {
  const vec4 c0 = vec4(-1.0, -0.0275, -0.572, 0.022);
  const vec4 c1 = vec4(1.0, 0.0425, 1.04, -0.04);
  vec4 r = roughness * c0 + c1;
  float a = min(r.x * r.x, exp2(-9.28 * nDotV)) * r.x + r.y;
  vec2 ab = vec2(-1.04, 1.04) * a + r.zw;
  return f0 * ab.x + ab.y;
}

#endif
