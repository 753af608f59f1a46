// Shadow map look-up: percentage-closer filtering over 3x3 texels with bilinear weights (Reeves et al. 1987, Rendering
// Antialiased Shadows with Depth Maps; the 4x4 footprint as four gathers). The maps themselves carry no bias, because
// effects march through them; the receiver is moved instead.
#ifndef TYNDALL_SHADOW_GLSL
#define TYNDALL_SHADOW_GLSL
#include "shared/light.h"
#include "lib/portable.h"
#include "lib/cube_map.glsl"
#include "engine/include/opaque.glsl"

// The includer declares `LightBlock shadowedLights[kShadowSlots]`.

// A 3x3 filter with bilinear weights reaches depths up to 2 texels away from the receiver's place: on a plane whose
// normal
// makes an angle t with the light, moving it 2 sin(t) texels along its normal puts it before all of them. Half a texel
// more towards the light covers rounding of depth and of interpolated normals.
const float kNormalOffsetTexels = 2.0;
const float kLightOffsetTexels = 0.5;
// A last digit of depths in [0.5, 1], of which the receiver's and the caster's are one off each, and the sums that make them
// as many as their terms, the place in the world, are larger than the distance along the face's axis.
const float kDepthRounding = 1.2e-7;

// The layer of the map of shadowedLights[slot] that a place lies in.
// (A slot, not a struct: copies of a light with its six matrices are dear on software devices.)
uint shadowFace(uint slot, vec3 position) {
  return opaque(shadowedLights[slot].core.kind) == kLightPoint ? cubeFace(position - shadowedLights[slot].core.position) : 0u;
}

// Clip position of the receiver in the map of shadowedLights[slot] (w divided out) and the layer; xy outside [-1, 1]:
// unshadowed. `normalTexels`: how far the receiver is moved along its normal where light grazes it.
vec4 shadowPlace(uint slot, vec3 position, vec3 normal, vec3 towardsLight, float normalTexels) {
  uint kind = opaque(shadowedLights[slot].core.kind);
  vec3 from = position - shadowedLights[slot].core.position;
  vec3 a = abs(from);
  uint face = shadowFace(slot, position);
  float texel = shadowedLights[slot].texelSize;
  if (kind == kLightSpot) texel *= max(dot(from, shadowedLights[slot].core.direction), 0.0);
  if (kind == kLightPoint) texel *= max(a.x, max(a.y, a.z));
  float cosine = dot(normal, towardsLight);
  float sine = sqrt(clamp(1.0 - cosine * cosine, 0.0, 1.0));
  vec3 p = position + texel * (normalTexels * sine * normal + kLightOffsetTexels * towardsLight);
  vec4 clip = shadowedLights[slot].clipFromWorld[face] * vec4(p, 1.0);
  if (clip.w <= 0.0) return vec4(2.0, 2.0, 0.0, 0.0);  // behind a spot light
  vec3 place = clip.xyz / clip.w;
  // The texels of a narrow cone are smaller than what rounding leaves of its curved depth.
  if (kind != kLightDirectional) place.z -= kDepthRounding * (2.0 + length(position) / clip.w);
  return vec4(place, float(face));
}

// Lit if the receiver is not behind the stored depth, or nothing was stored (depth 1).
vec4 litTaps(vec4 stored, float depth) {
  return vec4(greaterThanEqual(stored, vec4(depth))) + vec4(greaterThanEqual(stored, vec4(1.0))) *
         vec4(lessThan(stored, vec4(depth)));
}

// Share of light that arrives, [0, 1].
float shadowFilter(sampler2DArray map, float size, vec4 place) {
  if (any(greaterThan(abs(place.xy), vec2(1.0)))) return 1.0;
  vec2 texel = (place.xy * 0.5 + 0.5) * size - 0.5;
  vec2 base = floor(texel);
  vec2 f = texel - base;
  // A gather at the corner between four texels returns (x0,y1) (x1,y1) (x1,y0) (x0,y0).
  vec4 t00 = litTaps(textureGather(map, vec3((base + vec2(0.0, 0.0)) / size, place.w)), place.z);
  vec4 t10 = litTaps(textureGather(map, vec3((base + vec2(2.0, 0.0)) / size, place.w)), place.z);
  vec4 t01 = litTaps(textureGather(map, vec3((base + vec2(0.0, 2.0)) / size, place.w)), place.z);
  vec4 t11 = litTaps(textureGather(map, vec3((base + vec2(2.0, 2.0)) / size, place.w)), place.z);
  // Rows of four texels, weighted (1-f, 1, 1, f) across.
  vec4 across = vec4(1.0 - f.x, 1.0, 1.0, f.x);
  vec4 rows = vec4(dot(vec4(t00.wz, t10.wz), across), dot(vec4(t00.xy, t10.xy), across),
                   dot(vec4(t01.wz, t11.wz), across), dot(vec4(t01.xy, t11.xy), across));
  return dot(rows, vec4(1.0 - f.y, 1.0, 1.0, f.y)) / 9.0;
}

#endif
