// The image that a light shines through (CookieBlock), filtered over a footprint. Needs lib/cube_map.glsl, stages/blocks.h and the binding `cookieImage`: linear light,
// all mips, repeating.

#include "stages/opaque.glsl"

// Colour at a point relative to the eye, averaged over a footprint of the sides `along` and `across`, m.
vec3 cookieColour(CookieBlock block, vec3 point, vec3 along, vec3 across) {
  vec4 p = block.fromEye * vec4(point, 1.0);
  vec4 dx = block.fromEye * vec4(along, 0.0);
  vec4 dy = block.fromEye * vec4(across, 0.0);
  uint face = 0u;
  if (opaque(block.faces) == 6u) {
    face = cubeFace(p.xyz);
    p = cubePlace(face, p.xyz);
    dx = cubePlace(face, dx.xyz);
    dy = cubePlace(face, dy.xyz);
  }
  if (!(p.w > 0.0)) return vec3(0.0);  // behind a spot light
  vec2 place = clamp(p.xy / p.w, -1e6, 1e6);
  vec2 gx = (dx.xy - place * dx.w) / p.w;
  vec2 gy = (dy.xy - place * dy.w) / p.w;
  float side = float(textureSize(cookieImage, 0).x);
  float texels = 0.5 * side * sqrt(max(dot(gx, gx), dot(gy, gy)));
  float lod = clamp(log2(max(texels, 1.0)), 0.0, float(textureQueryLevels(cookieImage)) - 1.0);
  vec2 uv = vec2(0.5 + 0.5 * place.x, 0.5 - 0.5 * place.y);
  // The sampler repeats: where the image does not, no filter may reach across its border.
  float border = 0.5 / max(1.0, floor(side * exp2(-ceil(lod))));
  vec2 inside = clamp(uv, border, 1.0 - border);
  uint repeats = opaque(block.repeats);
  uv = vec2((repeats & 1u) != 0u ? uv.x : inside.x, (repeats & 2u) != 0u ? uv.y : inside.y);
  return textureLod(cookieImage, vec3(uv, float(face)), lod).rgb;
}
