// The per-pixel half of every technique on rectified rows: view ray to rows, parts of the ray that rows do not cover, the block at the
// epipole, phase function and result. A technique includes this after defining
//   vec3 meanVisibility(RowRay ray)     mean visibility, weighted by transmittance, of the columns before the ray's end, times the relative
//                                       strength of their light rays where those differ (kShaped)
// and after the bindings frame, light, slices, sceneDepth, shadowMap, scatter, unshadowed (stages/unshadowed.comp.glsl), and the constants
// kRowFilter and kFirstLight. A technique for lights with cookies defines TY_ROW_COOKIES and has the image bound
// at 23. A debug view that needs the functions only defines TY_OWN_MAIN; one that defines TY_SHOWN, a vec4 with A >= 0, has that stored instead of the radiance.
const int kRowNearest = 0, kRowLinear = 1, kRowMipmapped = 2;
const int kMostBlockSteps = 2048;
// Strata of the march that a light near the eye is left to. Of the worst view that was found, slats before a spot 1 m from the eye, 16, 32,
// 64, 128 leave errors of 0.07, 0.036, 0.017, 0.009 (nRMSE).
const int kNearbySteps = 64;

#include "stages/rows.glsl"
#include "stages/rays.glsl"
#ifdef TY_ROW_COOKIES
#define marchCookie light.cookie
#define TY_COOKIES kColoured
layout(binding = 23) uniform sampler2DArray cookieImage;
#endif
#include "stages/march_cookie.glsl"
#include "stages/march.glsl"
#include "stages/march_local.glsl"

struct Row {
  int index;
  float weight;
  float column;  // coordinate in [0, totalColumns()]: columns before it lie before the ray's end
  Slice s;
};

struct RowRay {
  Row a, b;         // the two slices next to the ray; with nearest rows b has weight 0
  float slice;      // slice coordinate
  float sine;       // of the inclination
  float theta;      // rad
  float depth;      // normalised
  float first, last;  // distances from the axis, m, or angles at the light at which the rows begin and end
  float reach;        // the same of the ray's end
  float whole;        // spot and point lights: unshadowed integral over the rows, which then share `weight` as they share it
};

int wrapSlice(int index) {
  int count = int(light.map.slices);
  return opaque(light.map.fullCircle) != 0u ? (index + count) % count : clamp(index, 0, count - 1);
}

// Distance from the axis in the slice of `s` that a ray's end has: rows share columns along e1 in a projective map.
float reachIn(Slice s, float reach, float x) { return byTangent() ? x * s.perX : reach; }

float unshadowedTo(float theta, float psi);

// Unshadowed integral of a view ray over the columns of a row.
float unshadowedOver(Slice s, RowRay ray) {
  return max(unshadowedTo(ray.theta, clamp(ray.reach, s.first, s.last)) - unshadowedTo(ray.theta, s.first), 0.0);
}

RowRay rowRay(vec3 local, float end, bool interpolate) {
  RowRay ray;
  ray.sine = length(local.xy);
  ray.theta = atan(ray.sine, local.z);
  ray.depth = rectifiedDepth(ray.sine, local.z);
  ray.slice = sliceCoordinate(local.xy);
  float below = interpolate ? floor(ray.slice - 0.5) : floor(ray.slice);
  float share = interpolate ? ray.slice - 0.5 - below : 0.0;
  ray.a.index = wrapSlice(int(below));
  ray.b.index = interpolate ? wrapSlice(int(below) + 1) : ray.a.index;
  ray.a.weight = 1.0 - share;
  ray.b.weight = share;
  ray.a.s = slices[ray.a.index];
  ray.b.s = slices[ray.b.index];
  ray.reach = kLocal ? angleAtLight(ray.sine, local.z, end, light.distance) : ray.sine * end;
  ray.a.column = columnAt(ray.a.s, reachIn(ray.a.s, ray.reach, local.x * end));
  ray.b.column = columnAt(ray.b.s, reachIn(ray.b.s, ray.reach, local.x * end));
  if (byTangent()) {
    float perX = ray.sine / max(local.x, 1e-12);
    ray.first = ray.a.s.last > ray.a.s.first ? perX / light.map.inverse[0] : 0.0;
    ray.last = ray.a.s.last > ray.a.s.first ? perX / light.map.inverse[light.map.splits] : 0.0;
  } else {
    ray.first = ray.a.s.first * ray.a.weight + ray.b.s.first * ray.b.weight;
    ray.last = ray.a.s.last * ray.a.weight + ray.b.s.last * ray.b.weight;
  }
  ray.whole = 0.0;
  if (kLocal) {
    // At the border of a cone the two rows span quite different angles.
    float a = ray.a.weight * unshadowedOver(ray.a.s, ray);
    float b = ray.b.weight > 0.0 ? ray.b.weight * unshadowedOver(ray.b.s, ray) : 0.0;
    ray.whole = a + b;
    // Slices that do not wrap round may be those of a cone, beyond which no light goes.
    if (opaque(light.map.fullCircle) == 0u && abs(ray.slice - 0.5 * float(light.map.slices)) > 0.5 * float(light.map.slices) + 0.5) ray.whole = 0.0;
    if (ray.whole > 0.0) {
      ray.a.weight = a / ray.whole;
      ray.b.weight = b / ray.whole;
    }
  }
  return ray;
}

vec3 meanVisibility(RowRay ray);

// Integral of localWeight() over [0, psi] for a view ray, psi <= pi - theta, from the table: its texel (i, j) holds the mean over the first
// (i + 1)/kUnshadowedSize of that range, for inclination j/(kUnshadowedSize - 1) of the way from thetaLow to thetaHigh.
float unshadowedTo(float theta, float psi) {
  int last = textureSize(unshadowed, 0).x - 1;
  float whole = max(kPi - theta, 1e-7);
  float share = clamp(psi / whole, 0.0, 1.0);
  float x = share * float(last + 1);
  float y = clamp((theta - light.thetaLow) / max(light.thetaHigh - light.thetaLow, 1e-6), 0.0, 1.0) * float(last);
  int i = min(int(x), last);
  int j = min(int(y), last - 1);
  vec2 upTo = vec2(texelFetch(unshadowed, ivec3(i, j, 0), 0).x, texelFetch(unshadowed, ivec3(i, j + 1, 0), 0).x);
  vec2 before = i > 0 ? vec2(texelFetch(unshadowed, ivec3(i - 1, j, 0), 0).x, texelFetch(unshadowed, ivec3(i - 1, j + 1, 0), 0).x) : vec2(0.0);
  vec2 both = mix(before, upTo, x - float(i));
  return mix(both.x, both.y, y - float(j)) * whole;
}

bool inEpipoleBlock(vec2 pixel) {
  vec2 a = abs(pixel - light.epipoles.xy);
  vec2 b = abs(pixel - light.epipoles.zw);
  return min(max(a.x, a.y), max(b.x, b.y)) <= float(frame.rectified.epipole_block);
}

// ds/d^2 over dpsi, 1/(D sin(theta)): one over the distance at which the light is passed. Where that is less than kLeastLampDistance, the whole
// integral of ds/d^2 with that instead, over the whole angle.
float perAngle(RowRay ray, float end) {
  float pass = light.distance * max(ray.sine, 1e-6);
  if (pass >= kLeastLampDistance) return 1.0 / pass;
  float nearest = light.distance * cos(ray.theta);
  return angleBetween(kLeastLampDistance, -nearest, end - nearest) /
         (kLeastLampDistance * max(angleBetween(pass, -nearest, end - nearest), 1e-12));
}

// What reaches the eye along [0, end], m, over sigma_s, phase function (of a sun) and the light's strength. For a sun the integral of
// visible transmittance; for other lights that of visible localWeight() over D sin(theta).
vec3 visibleIntegral(RowRay ray, float end) {
  float sigma_t = frame.rays.sigma_t;
  if (kLocal) {
    if (ray.whole <= 0.0) return vec3(0.0);
    return meanVisibility(ray) * (ray.whole * perAngle(ray, end));
  }
  float safeSine = max(ray.sine, 1e-7);
  float enter = min(ray.first / safeSine, end);
  float leave = min(ray.last / safeSine, end);
  // Rows of a sun with a cookie hold all that is seen.
  if (kShaped) return leave > 0.0 ? meanVisibility(ray) * transmittanceIntegral(sigma_t, 0.0, leave) : vec3(0.0);
  float unshadowed_ = transmittanceIntegral(sigma_t, 0.0, end);
  if (leave <= enter) return vec3(unshadowed_);
  float blocked = transmittanceIntegral(sigma_t, enter, leave) * (1.0 - meanVisibility(ray).x);
  // What a projective map does not reach, the decimetre up to the near plane, is seen as the eye is. (Klehm et al. 2014 let it share
  // the row's average, which made the forest 0.6 % too dark.)
  vec2 eye = light.sun.shadowEye.xy;
  bool covered = opaque(all(greaterThanEqual(eye, vec2(0.0)))) && opaque(all(lessThan(eye, vec2(light.sun.shadowSize))));
  if (byTangent() && opaque(light.map.nearLit) == 0u && covered)
    blocked += transmittanceIntegral(sigma_t, 0.0, enter) * blockedAt(light.sun, shadowMap, light.sun.shadowEye);
  return vec3(unshadowed_ - blocked);
}

#ifndef TY_OWN_MAIN
vec3 nearbyMarched(vec3 direction, float end) {
  LocalRay ray = localRay(light.local, direction, end);
  return marchedByAngle(light.local, shadowMap, ray, frame.rays.sigma_t, opaque(frame.rays.g), kNearbySteps, 0.5);
}

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(pixel, uvec2(imageSize(scatter))))) return;
  vec3 direction = rayDirection(frame.rays, pixel);
  float perAxial = length(direction);
  direction /= perAxial;
  float end = perAxial * axialDistance(frame.rays, texelFetch(sceneDepth, ivec2(pixel), 0).x);
  vec3 local = vec3(dot(direction, light.map.e1), dot(direction, light.map.e2), dot(direction, light.sun.towards));

  vec3 integral;
  float sigma_t = frame.rays.sigma_t;
  bool interpolate = kRowFilter != kRowNearest;
  if (opaque(frame.rectified.epipole_block) > 0 && inEpipoleBlock(vec2(pixel) + 0.5)) {
    integral = kLocal ? denselyMarchedLocal(light.local, shadowMap, direction, end, sigma_t, opaque(frame.rays.g), kMostBlockSteps)
                      : denselyMarched(light.sun, shadowMap, direction, end, sigma_t, kMostBlockSteps);
  } else if (kLocal && opaque(light.nearby) >= 1.0) {
    integral = nearbyMarched(direction, end);
  } else {
    integral = visibleIntegral(rowRay(local, end, interpolate), end);
    // Klehm et al. 2014, section 3.1: what the row says of the stretch up to the camera's near plane is taken off again.
    if (opaque(frame.rectified.near_correction) != 0 && byTangent() && opaque(light.map.nearLit) == 0u) {
      float near = min(perAxial * frame.rays.znear, end);
      integral -= visibleIntegral(rowRay(local, near, interpolate), near);
    }
    if (kLocal) integral *= light.local.intensity;
    if (kLocal && opaque(light.nearby) > 0.0) integral = mix(integral, nearbyMarched(direction, end), light.nearby);
  }
  vec3 radiance = frame.rays.albedo * sigma_t * max(integral, vec3(0.0));
  if (!kLocal) radiance *= phaseHenyeyGreenstein(local.z, opaque(frame.rays.g)) * light.sun.irradiance * light.map.share;
#ifdef TY_SHOWN
  vec4 shown = TY_SHOWN;
  if (shown.a >= 0.0) {
    imageStore(scatter, ivec2(pixel), shown);
    return;
  }
#endif
  if (kFirstLight)
    imageStore(scatter, ivec2(pixel), vec4(radiance, exp(-frame.rays.sigma_t * end)));
  else
    imageStore(scatter, ivec2(pixel), imageLoad(scatter, ivec2(pixel)) + vec4(radiance, 0.0));
}
#endif
