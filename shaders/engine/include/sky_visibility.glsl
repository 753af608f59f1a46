// How much of the sky a surface sees: one comparison with a widened depth map (sky_spread.comp) for each direction.
// Casters only ever grow by this, never shrink: a closed room is dark, and the foot of a wall somewhat darker than it is.
#ifndef TYNDALL_SKY_VISIBILITY_GLSL
#define TYNDALL_SKY_VISIBILITY_GLSL
#include "shared/sky.h"

// The includer declares `SkyBlock sky` and `sampler2DArray skyMaps`.

// Bilinear weights on widened texels reach depths 2 texels away along each axis, sqrt(8) across. Moving a receiver on a
// plane at an angle t to the light by that times sin(t) along its normal puts it before all of them.
const float kSkyNormalTexels = 2.83;
// Rounding of depths and of interpolated normals.
const float kSkyLightTexels = 0.25;
// What the filter reads around a place.
const float kSkyBorder = 3.0 / float(kSkyTexels);

// Where a receiver lies in sky.maps[m]: place and depth.
vec3 skyPlace(uint m, vec3 position, vec3 normal, vec3 towardsSky, float sine) {
  vec4 p = vec4(position + sky.maps[m].texel * (kSkyNormalTexels * sine * normal + kSkyLightTexels * towardsSky), 1.0);
  return vec3(dot(sky.maps[m].u, p), dot(sky.maps[m].v, p), dot(sky.maps[m].depth, p));
}

bool insideSkyMap(vec2 place) { return all(lessThan(abs(place - 0.5), vec2(0.5 - kSkyBorder))); }

// Share of the light from one direction that arrives, [0, 1].
float skyLit(uint direction, vec3 position, vec3 normal) {
  vec3 towardsSky = sky.directions[direction];
  float cosine = dot(normal, towardsSky);
  float sine = sqrt(clamp(1.0 - cosine * cosine, 0.0, 1.0));
  uint m = direction;
  vec3 place = skyPlace(m, position, normal, towardsSky, sine);
  for (uint finer = 1; finer < kSkyCascades; ++finer) {
    if (insideSkyMap(place.xy)) break;
    m += kSkyDirections;
    place = skyPlace(m, position, normal, towardsSky, sine);
  }
  if (!insideSkyMap(place.xy)) return 1.0;
  vec2 f = fract(place.xy * float(kSkyTexels) - 0.5);
  vec4 stored = textureGather(skyMaps, vec3(place.xy, float(sky.maps[m].layer)));
  // Depth 1: nothing was drawn there.
  vec4 lit = vec4(greaterThanEqual(stored, vec4(min(place.z, 1.0))));
  vec2 rows = mix(lit.wx, lit.zy, f.x);
  return mix(rows.x, rows.y, f.y);
}

// Sums over every `stride`-th direction from `first` on: weighted visibilities, then weights; of the sky, of the ground.
vec4 skySums(vec3 position, vec3 normal, uint first, uint stride) {
  vec4 sums = vec4(0.0);
  for (uint i = first; i < kSkyDirections; i += stride) {
    vec3 d = sky.directions[i];
    vec2 weight = max(vec2(dot(normal, d), (1.0 - d.y) * (dot(normal.xz, d.xz) + abs(normal.y))), 0.0);
    sums += vec4(weight * skyLit(i, position, normal), weight);
  }
  return sums;
}

// x: of the sky's light on a surface, its cosine-weighted mean. y: of the ground's, which comes in from the sides that
// the surface is turned to, the more the lower. [0, 1].
vec2 skyVisibility(vec3 position, vec3 normal) {
  vec4 sums = skySums(position, normal, 0u, 1u);
  return sums.xy / max(sums.zw, 1e-9);
}

// The sum over a quad's four pixels.
vec4 quadSum(vec4 v) {
  bvec2 second = bvec2(uvec2(gl_FragCoord.xy) & 1u);
  vec4 row = 2.0 * v + (second.x ? -1.0 : 1.0) * dFdxFine(v);
  return 2.0 * row + (second.y ? -1.0 : 1.0) * dFdyFine(row);
}

// The same for a full-screen triangle, outside of any branch: four pixels on one flat surface share the directions.
// `surface`: false where there is none, and the result is 0.
vec2 skyVisibilityOfQuad(vec3 position, vec3 normal, bool surface) {
  vec3 px = dFdxFine(position), py = dFdyFine(position);
  bool flat4 = surface && abs(dot(px, normal)) < 0.2 * length(px) && abs(dot(py, normal)) < 0.2 * length(py) &&
               length(dFdxFine(normal)) + length(dFdyFine(normal)) < 0.3;
  bool shared4 = quadSum(vec4(flat4 ? 1.0 : 0.0)).x > 3.5;
  uvec2 odd = uvec2(gl_FragCoord.xy) & 1u;
  vec4 sums = vec4(0.0);
  if (surface) sums = skySums(position, normal, shared4 ? odd.x + 2u * odd.y : 0u, shared4 ? 4u : 1u);
  vec4 all = quadSum(sums);
  sums = shared4 ? all : sums;
  return sums.xy / max(sums.zw, 1e-9);
}

#endif
