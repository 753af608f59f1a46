// Packing of normals and colours.
#ifndef TYNDALL_ENCODE_GLSL
#define TYNDALL_ENCODE_GLSL

// Octahedral map of the unit sphere to [0, 1]^2.
// Cigolle et al. 2014, A Survey of Efficient Representations for Independent Unit Vectors, section 3 (oct).
vec2 octFromUnit(vec3 n) {
  vec2 p = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
  if (n.z < 0.0) p = (1.0 - abs(p.yx)) * vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
  return p * 0.5 + 0.5;
}

vec3 unitFromOct(vec2 coded) {
  vec2 p = coded * 2.0 - 1.0;
  vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
  if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * vec2(n.x >= 0.0 ? 1.0 : -1.0, n.y >= 0.0 ? 1.0 : -1.0);
  return normalize(n);
}

// IEC 61966-2-1 (sRGB) transfer function, for linear values in [0, 1].
vec3 srgbFromLinear(vec3 c) {
  vec3 curved = 1.055 * pow(max(c, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055;
  return mix(curved, c * 12.92, lessThanEqual(c, vec3(0.0031308)));
}

#endif
