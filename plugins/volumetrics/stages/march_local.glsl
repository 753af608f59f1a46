// One march through the light of a spot or point light and its shadow map: what ray_march is made of, and what other techniques
// call for the few rays near the light that rows cannot answer. Needs lib/medium.glsl, lib/local_light.glsl, lib/cube_map.glsl and stages/blocks.h before it, and
// stages/march_cookie.glsl.
// What is summed along a view ray is V p a I exp(-sigma_t (t + d)) / d^2 dt, d the distance from the light, a range and cone, I the
// colour: times sigma_s it is the radiance. Points are relative to the eye. Samples are spent only where the light's range and cone reach the ray.
// A stratum's weight is the exact integral of dt/d^2 over it times the rest in its middle, and a quadrature where one angle spans far too
// different distances for that; visibility is sampled at `offset` in [0, 1] of it.

#include "stages/opaque.glsl"

// Candela towards a point of a view ray, for a stratum of `length_` m. The cookie belongs here, and nowhere else (stages/march_cookie.glsl).
vec3 lightColour(LocalBlock light, vec3 direction, float t, float length_) {
  return hasCookie() ? light.intensity * cookieAlong(direction, t, length_) : light.intensity;
}

// Face of the map that a direction from the light falls on.
uint localFace(LocalBlock light, vec3 fromLight) { return opaque(light.kind) == kLocalSpot ? 0u : cubeFace(fromLight); }

// Whether the map holds something nearer. Behind a spot light and beside its map everything is lit; faces of a point light leave nothing
// out, so that a point beside one is rounding.
bool localBlockedFrom(LocalBlock light, sampler2DArray shadowMap, vec3 fromLight) {
  bool spot = opaque(light.kind) == kLocalSpot;
  uint face = localFace(light, fromLight);
  vec3 m = abs(fromLight);
  float along = spot ? dot(fromLight, light.axis) : max(m.x, max(m.y, m.z));
  vec2 p = vec2(dot(light.faceX[face], fromLight), dot(light.faceY[face], fromLight)) / along;
  if (spot && (along <= 0.0 || max(abs(p.x), abs(p.y)) > 1.0)) return false;
  ivec2 texel = clamp(ivec2((p * 0.5 + 0.5) * light.shadowSize), ivec2(0), ivec2(light.shadowSize) - 1);
  float stored = texelFetch(shadowMap, ivec3(texel, face), 0).x;
  return light.depthScale - light.depthOffset / along > stored && stored < 1.0;
}

// A view ray as the light sees it (lib/local_light.glsl): s = t - closest.
struct LocalRay {
  vec3 direction;  // unit
  vec3 nearest;    // from the light to the ray's nearest point, m
  float closest;   // distance of that point along the ray, m; negative behind the eye
  float pass;      // its distance from the light, m, at least kLeastLampDistance
  float more;      // what that raised the square of the distance by, m^2
  vec2 reached;    // part of the ray that range and cone reach, as s, m; empty where x >= y
};

LocalRay localRay(LocalBlock light, vec3 direction, float end) {
  LocalRay ray;
  ray.direction = direction;
  ray.closest = dot(light.position, direction);
  ray.nearest = ray.closest * direction - light.position;
  float pass = length(ray.nearest);
  ray.pass = max(pass, kLeastLampDistance);
  ray.more = (ray.pass - pass) * (ray.pass + pass);
  ray.reached = clipToRange(vec2(-ray.closest, end - ray.closest), pass, opaque(light.range));
  if (opaque(light.kind) == kLocalSpot) ray.reached = clipToCone(ray.reached, direction, ray.nearest, light.axis, light.cosOuter, light.sinOuter);
  return ray;
}

// The integrand without inverse square and visibility at s, for a stratum of `angle` rad at the light.
vec3 localRest(LocalBlock light, LocalRay ray, float s, float angle, float sigma_t, float g) {
  float d2 = s * s + ray.pass * ray.pass;
  float d = sqrt(d2);
  bool spot = opaque(light.kind) == kLocalSpot;
  float versine = spot ? versineToAxis(ray.nearest + s * ray.direction, light.axis, d2, ray.more) : 0.0;
  return lightColour(light, ray.direction, ray.closest + s, angle * d2 / ray.pass) *
         (localAttenuation(d2, opaque(light.range), versine, light.coneOuter, light.coneScale) * phaseHenyeyGreenstein(-s / d, g) *
          exp(-sigma_t * (ray.closest + s + d)));
}

// Strata in which log(distance) changes by more than this are integrated by quadrature: below, the middle is off by 0.3^2/24 of a curvature.
const float kPlainStratum = 0.3;

// Integral of the rest over the angle between two points of the ray, a <= b: Gauss-Legendre of four points in v, s = pass sinh(v), in which
// range, phase and both exponentials change slowly however far the light is; da = dv/cosh(v) = pass/d dv.
vec3 restOverAngle(LocalBlock light, LocalRay ray, float a, float b, float sigma_t, float g) {
  // asinh keeps its digits in this form.
  vec2 x = abs(vec2(a, b)) / ray.pass;
  vec2 v = sign(vec2(a, b)) * log(x + sqrt(x * x + 1.0));
  // Beyond 6 from the near end less than e^-6 of the stratum is left, and a few points would not see what counts.
  float limit = 6.0 + (v.x * v.y <= 0.0 ? 0.0 : min(abs(v.x), abs(v.y)));
  v = clamp(v, -limit, limit);
  float middle = 0.5 * (v.x + v.y);
  float half_ = 0.5 * (v.y - v.x);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 4; ++i) {
    bool outer = i == 0 || i == 3;
    float place = (outer ? 0.8611363115940526 : 0.3399810435848563) * (i < 2 ? -1.0 : 1.0);
    float weight = outer ? 0.3478548451374538 : 0.6521451548625461;
    float up = exp(middle + half_ * place);
    float down = 1.0 / up;
    float angle = weight * 2.0 / (up + down);
    sum += localRest(light, ray, clamp(0.5 * ray.pass * (up - down), a, b), angle * half_, sigma_t, g) * angle;
  }
  return sum * half_;
}

// Rays of which the light sees less than this, rad (lib/local_light.glsl has a series for such turns).
const float kNarrowAngle = 0.2;

// The sum by `steps` strata of equal angle at the light.
vec3 marchedByAngle(LocalBlock light, sampler2DArray shadowMap, LocalRay ray, float sigma_t, float g, int steps, float offset) {
  if (ray.reached.x >= ray.reached.y) return vec3(0.0);
  // The angle starts at the end that is farther from the light, where it is small and must be exact: side = 1 is the ray's far end.
  float side = ray.reached.x + ray.reached.y >= 0.0 ? 1.0 : -1.0;
  vec2 start = normalize(vec2(side > 0.0 ? ray.reached.y : -ray.reached.x, ray.pass));
  float whole = angleBetween(ray.pass, ray.reached.x, ray.reached.y);
  float width = whole / float(steps);
  vec2 turn = turnBy(width);
  vec2 sample_ = turnBy((offset - 0.5) * width);
  vec2 half_ = turnBy(0.5 * width);
  vec2 at = turned(start, half_);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < steps; ++i) {
    // Rounding of turns that are added up would be much of a narrow beam: there each stratum is turned to at once.
    if (whole < kNarrowAngle) at = turned(start, turnBy((float(i) + 0.5) * width));
    vec2 visible = turned(at, sample_);
    float s = side * ray.pass * visible.x / max(visible.y, 1e-9);
    if (!localBlockedFrom(light, shadowMap, ray.nearest + clamp(s, ray.reached.x, ray.reached.y) * ray.direction)) {
      // d/pass = 1/sine, and so log(d) changes by about width/sine.
      if (width > kPlainStratum * at.y) {
        vec2 from = turned(at, half_ * vec2(1.0, -1.0));
        vec2 to = turned(at, half_);
        vec2 borders = side * ray.pass * vec2(from.x / max(from.y, 1e-9), to.x / max(to.y, 1e-9));
        borders = clamp(borders, ray.reached.x, ray.reached.y);
        if (i == 0) borders.x = side > 0.0 ? ray.reached.y : ray.reached.x;
        if (i == steps - 1) borders.y = side > 0.0 ? ray.reached.x : ray.reached.y;
        sum += restOverAngle(light, ray, min(borders.x, borders.y), max(borders.x, borders.y), sigma_t, g) / width;
      } else {
        s = side * ray.pass * at.x / at.y;
        sum += localRest(light, ray, clamp(s, ray.reached.x, ray.reached.y), width, sigma_t, g);
      }
    }
    at = turned(at, turn);
  }
  return sum * (width / ray.pass);
}

// The same by strata of equal length.
vec3 marchedByDistance(LocalBlock light, sampler2DArray shadowMap, LocalRay ray, float sigma_t, float g, int steps, float offset) {
  if (ray.reached.x >= ray.reached.y) return vec3(0.0);
  float width = (ray.reached.y - ray.reached.x) / float(steps);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < steps; ++i) {
    float s = ray.reached.x + float(i) * width;
    if (!localBlockedFrom(light, shadowMap, ray.nearest + (s + offset * width) * ray.direction)) {
      float angle = angleBetween(ray.pass, s, s + width);
      sum += localRest(light, ray, s + 0.5 * width, angle, sigma_t, g) * angle;
    }
  }
  return sum / ray.pass;
}

// The sum by a march fine enough to meet every shadow texel on the way, as long as `most` samples, which a device's limit of 65,535
// iterations asks for, suffice for that. direction unit, end in metres.
vec3 denselyMarchedLocal(LocalBlock light, sampler2DArray shadowMap, vec3 direction, float end, float sigma_t, float g, int most) {
  LocalRay ray = localRay(light, direction, end);
  if (ray.reached.x >= ray.reached.y) return vec3(0.0);
  float texels = angleBetween(ray.pass, ray.reached.x, ray.reached.y) / light.texelAngle;
  return marchedByAngle(light, shadowMap, ray, sigma_t, g, clamp(int(min(texels * 2.0, 1e6)), 256, most), 0.5);
}
