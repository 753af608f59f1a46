// The image that a light shines through (docs/conventions.md, "Cookies"), filtered over the pixel's footprint on the
// surface. The includer declares `ViewBlock view` and `sampler2DArray cookies`: linear light, repeating, trilinear.
// There are no neighbouring pixels to take differences from (full-screen passes cross silhouettes), so the footprint is
// computed: one pixel's steps along the surface's tangent plane, brought into the image by the projection's derivative.
#ifndef TYNDALL_COOKIE_GLSL
#define TYNDALL_COOKIE_GLSL
#include "shared/light.h"
#include "engine/include/opaque.glsl"

// cubeFace() and cubePlace() come with engine/include/shadow.glsl.

// A plane seen edge-on would have an infinite footprint; below this sine of the angle to it, it counts as tilted so.
const float kLeastTilt = 0.05;

// How the surface's point moves when the pixel moves by one, m: columns right and up.
mat2x3 pixelFootprint(vec3 position, vec3 normal) {
  vec3 ray = position - view.eye;
  float depth = -(view.viewFromWorld * vec4(position, 1.0)).z;
  vec2 pixel = 2.0 * depth * abs(vec2(view.viewFromClip[0][0], view.viewFromClip[1][1])) / vec2(view.size);
  float least = kLeastTilt * length(ray);
  float along = dot(normal, ray);
  along = along < 0.0 ? min(along, -least) : max(along, least);
  vec3 right = view.worldFromView[0].xyz * pixel.x, up = view.worldFromView[1].xyz * pixel.y;
  return mat2x3(right - ray * (dot(normal, right) / along), up - ray * (dot(normal, up) / along));
}

vec3 cookieColor(CookieBlock c, vec3 position, mat2x3 footprint) {
  vec4 p = c.cookieFromWorld * vec4(position, 1.0);
  vec4 dx = c.cookieFromWorld * vec4(footprint[0], 0.0), dy = c.cookieFromWorld * vec4(footprint[1], 0.0);
  uint layer = c.layer;
  if (opaque(c.faces) == 6u) {
    uint face = cubeFace(p.xyz);
    layer += face;
    p = cubePlace(face, p.xyz), dx = cubePlace(face, dx.xyz), dy = cubePlace(face, dy.xyz);
  }
  if (!(p.w > 0.0)) return vec3(0.0);  // behind a spot light
  vec2 place = clamp(p.xy / p.w, -1e6, 1e6);
  // d(x / w) = (dx - (x / w) dw) / w; the image is two units wide.
  vec2 gx = (dx.xy - place * dx.w) / p.w, gy = (dy.xy - place * dy.w) / p.w;
  float side = float(textureSize(cookies, 0).x), levels = float(textureQueryLevels(cookies));
  float texels = 0.5 * side * sqrt(max(dot(gx, gx), dot(gy, gy)));
  float lod = clamp(log2(max(texels, 1.0)), 0.0, levels - 1.0);
  vec2 uv = vec2(0.5 + 0.5 * place.x, 0.5 - 0.5 * place.y);
  // The sampler repeats: where the image does not, no filter may reach across its border.
  float border = 0.5 / max(1.0, floor(side * exp2(-ceil(lod))));
  vec2 inside = clamp(uv, border, 1.0 - border);
  uint repeats = opaque(c.repeats);
  uv = vec2((repeats & 1u) != 0u ? uv.x : inside.x, (repeats & 2u) != 0u ? uv.y : inside.y);
  return textureLod(cookies, vec3(uv, float(layer)), lod).rgb;
}

#endif
