// One march through a sun's shadow map: what ray_march is made of, and what other techniques call for the few rays that rows
// cannot answer. Needs lib/medium.glsl, stages/blocks.h and stages/march_cookie.glsl before it.
// Samples are spent only where a ray is inside the prism that the shadow map covers; outside it everything is lit. A stratum's
// weight is the exact integral of the transmittance over it; visibility is sampled at `offset` in [0, 1] of each stratum.

#include "stages/opaque.glsl"

// The part of [interval.x, interval.y] in which p + t v is inside [0, size].
vec2 clipSlab(vec2 interval, float p, float v, float size) {
  if (abs(v) < 1e-12) return opaque(p) >= 0.0 && opaque(p) <= size ? interval : vec2(1.0, 0.0);
  float a = -p / v;
  float b = (size - p) / v;
  return vec2(max(interval.x, min(a, b)), min(interval.y, max(a, b)));
}

// Change of shadow texel and depth per metre along a direction.
vec3 shadowStep(SunBlock sun, vec3 direction) {
  return sun.shadowX * direction.x + sun.shadowY * direction.y + sun.shadowZ * direction.z;
}

// The part of a ray, [0, end] metres, inside the map's prism. Nearer to the light than the nearest caster (stored depth 0) nothing
// is shadowed.
vec2 shadowedPart(SunBlock sun, vec3 step_, float end) {
  vec2 interval = clipSlab(vec2(0.0, end), sun.shadowEye.x, step_.x, sun.shadowSize);
  interval = clipSlab(interval, sun.shadowEye.y, step_.y, sun.shadowSize);
  return clipSlab(interval, sun.shadowEye.z, step_.z, 1e30);
}

float blockedAt(SunBlock sun, sampler2DArray shadowMap, vec3 p) {
  float stored = texelFetch(shadowMap, ivec3(clamp(ivec2(p.xy), ivec2(0), ivec2(sun.shadowSize) - 1), 0), 0).x;
  return p.z > stored && stored < 1.0 ? 1.0 : 0.0;
}

// Share of the transmittance integral over `interval` that is blocked, `steps` strata of equal length.
float blockedByDistance(SunBlock sun, sampler2DArray shadowMap, vec3 step_, vec2 interval, float sigma_t, int steps, float offset) {
  float span = interval.y - interval.x;
  float width = span / float(steps);
  float falloff = exp(-sigma_t * width);
  float weight = transmittanceIntegral(sigma_t, 0.0, width) / transmittanceIntegral(sigma_t, 0.0, span);
  float blocked = 0.0;
  for (int i = 0; i < steps; ++i) {
    blocked += weight * blockedAt(sun, shadowMap, sun.shadowEye + (interval.x + (float(i) + offset) * width) * step_);
    weight *= falloff;
  }
  return blocked;
}

// The same, strata of equal share of the integral: lib/medium.glsl's distanceAtTransmittanceShare, with what does not change taken out of the loop.
float blockedByTransmittance(SunBlock sun, sampler2DArray shadowMap, vec3 step_, vec2 interval, float sigma_t, int steps, float offset) {
  float x = sigma_t * (interval.y - interval.x);
  // So thin a medium is passed in equal steps to within a ten thousandth of the way.
  if (x < 1e-3) return blockedByDistance(sun, shadowMap, step_, interval, sigma_t, steps, offset);
  float inverse = 1.0 / float(steps);
  float passed = -oneMinusExp(x) * inverse;
  vec3 start = sun.shadowEye + interval.x * step_;
  vec3 perOctave = step_ * (-0.6931471805599453 / sigma_t);  // ln(2)
  float blocked = 0.0;
  for (int i = 0; i < steps; ++i)
    blocked += blockedAt(sun, shadowMap, start + log2(max(1.0 + (float(i) + offset) * passed, 1e-30)) * perOctave);
  return blocked * inverse;
}

// Integral of visible transmittance times the cookie's colour over [0, end]: strata over the whole ray, since beyond the shadow map's prism, where
// nothing is shadowed, the colour still changes.
vec3 colouredMarch(SunBlock sun, sampler2DArray shadowMap, vec3 direction, float end, float sigma_t, int steps, float offset,
                   bool byTransmittance) {
  vec3 step_ = shadowStep(sun, direction);
  vec2 interval = shadowedPart(sun, step_, end);
  float width = end / float(steps);
  float falloff = exp(-sigma_t * width);
  float all_ = transmittanceIntegral(sigma_t, 0.0, end);
  float weight = byTransmittance ? all_ / float(steps) : transmittanceIntegral(sigma_t, 0.0, width);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < steps; ++i) {
    float at = float(i) + offset;
    float t = byTransmittance ? distanceAtTransmittanceShare(sigma_t, end, at / float(steps)) : at * width;
    bool inside = t >= interval.x && t <= interval.y;
    if (!inside || blockedAt(sun, shadowMap, sun.shadowEye + t * step_) == 0.0)
      sum += weight * cookieAlong(direction, t, byTransmittance ? min(weight * exp(sigma_t * t), end) : width);
    if (!byTransmittance) weight *= falloff;
  }
  return sum;
}

// Integral of visible transmittance over [0, end] by a march fine enough to meet every shadow texel on the way, as long as `most` samples,
// which a device's limit of 65,535 iterations asks for, suffice for that.
vec3 denselyMarched(SunBlock sun, sampler2DArray shadowMap, vec3 direction, float end, float sigma_t, int most) {
  vec3 step_ = shadowStep(sun, direction);
  vec2 interval = shadowedPart(sun, step_, end);
  if (hasCookie()) return colouredMarch(sun, shadowMap, direction, end, sigma_t, most, 0.5, true);
  float integral = transmittanceIntegral(sigma_t, 0.0, end);
  if (interval.y <= interval.x) return vec3(integral);
  float texels = (interval.y - interval.x) * (abs(step_.x) + abs(step_.y));
  int steps = clamp(int(texels * 2.0), 256, most);
  return vec3(integral - transmittanceIntegral(sigma_t, interval.x, interval.y) *
                             blockedByDistance(sun, shadowMap, step_, interval, sigma_t, steps, 0.5));
}
