// One march through the light of a spot or point light and its shadow map: what ray_march is made of, and what other techniques
// call for the few rays near the light that rows cannot answer. Needs lib/medium.glsl, lib/local_light.glsl and stages/blocks.h before
// it, and nothing else.
// What is summed along a view ray is V p a I exp(-sigma_t (t + d)) / d^2 dt, d the distance from the light, a range and cone, I the
// colour: times sigma_s it is the radiance. Points are relative to the eye. Samples are spent only where the light's range and cone reach the ray.
// A stratum's weight is the exact integral of dt/d^2 over it times the rest in its middle; visibility is sampled at `offset` in [0, 1] of it.

// The integral diverges for a ray through the light itself: a ray that passes closer counts as passing at this distance, m.
const float kClosestPass = 1e-3;

// Candela towards a point at `fromLight` from the light. A cookie's colour belongs here, and nowhere else.
vec3 lightColour(LocalBlock light, vec3 fromLight) { return light.intensity; }

// Face of the map that a direction from the light falls on.
uint localFace(LocalBlock light, vec3 fromLight) {
  if (light.kind == kLocalSpot) return 0u;
  vec3 m = abs(fromLight);
  if (m.x >= m.y && m.x >= m.z) return fromLight.x < 0.0 ? 1u : 0u;
  if (m.y >= m.z) return fromLight.y < 0.0 ? 3u : 2u;
  return fromLight.z < 0.0 ? 5u : 4u;
}

// Whether the map's depth at a point in a face's clip space is nearer. Behind a spot light and beside its map everything is lit; faces of a
// point light leave nothing out, so that a point beside one is rounding.
bool blockedInClip(LocalBlock light, sampler2DArray shadowMap, uint face, vec4 clip) {
  if (clip.w <= 0.0) return false;
  vec3 p = clip.xyz / clip.w;
  if (light.kind == kLocalSpot && max(abs(p.x), abs(p.y)) > 1.0) return false;
  ivec2 texel = clamp(ivec2((p.xy * 0.5 + 0.5) * light.shadowSize), ivec2(0), ivec2(light.shadowSize) - 1);
  float stored = texelFetch(shadowMap, ivec3(texel, face), 0).x;
  return p.z > stored && stored < 1.0;
}

// Shadow test of one point.
bool localBlocked(LocalBlock light, sampler2DArray shadowMap, vec3 pointMinusEye) {
  uint face = localFace(light, pointMinusEye - light.position);
  return blockedInClip(light, shadowMap, face, light.shadow[face] * vec4(pointMinusEye, 1.0));
}

// The unshadowed integrand at one point of a view ray: direction unit, t its distance from the eye.
vec3 localScatter(LocalBlock light, vec3 direction, float t, float sigma_t, float g) {
  vec3 w = t * direction - light.position;
  float d2 = max(dot(w, w), kClosestPass * kClosestPass);
  float d = sqrt(d2);
  float rest = localAttenuation(d2, light.range, dot(w, light.axis) / d, light.coneScale, light.coneOffset) / d2;
  return lightColour(light, w) * (rest * phaseHenyeyGreenstein(-dot(w, direction) / d, g) * exp(-sigma_t * (t + d)));
}

// A view ray as the light sees it (lib/local_light.glsl): s = t - closest.
struct LocalRay {
  vec3 direction;  // unit
  vec3 nearest;    // from the light to the ray's nearest point, m
  float closest;   // distance of that point along the ray, m; negative behind the eye
  float pass;      // its distance from the light, m, at least kClosestPass
  float along, across;  // dot products of the spot's axis with the direction and with `nearest`
  vec2 reached;    // part of the ray that range and cone reach, as s, m; empty where x >= y
};

LocalRay localRay(LocalBlock light, vec3 direction, float end) {
  LocalRay ray;
  ray.direction = direction;
  ray.closest = dot(light.position, direction);
  ray.nearest = ray.closest * direction - light.position;
  float pass = length(ray.nearest);
  ray.pass = max(pass, kClosestPass);
  ray.along = dot(direction, light.axis);
  ray.across = dot(ray.nearest, light.axis);
  ray.reached = clipToRange(vec2(-ray.closest, end - ray.closest), pass, light.range);
  if (light.kind == kLocalSpot) ray.reached = clipToCone(ray.reached, pass, ray.along, ray.across, light.cosOuter);
  return ray;
}

// The integrand without inverse square and visibility at s.
vec3 localRest(LocalBlock light, LocalRay ray, float s, float sigma_t, float g) {
  float d2 = s * s + ray.pass * ray.pass;
  float d = sqrt(d2);
  float cosine = (ray.across + s * ray.along) / d;
  return lightColour(light, ray.nearest + s * ray.direction) *
         (localAttenuation(d2, light.range, cosine, light.coneScale, light.coneOffset) * phaseHenyeyGreenstein(-s / d, g) *
          exp(-sigma_t * (ray.closest + s + d)));
}

// The ray in clip space of the face that it is in: a matrix is read only where the face changes.
struct LocalTrack {
  uint face;
  vec4 clipNearest, clipStep;
};
LocalTrack localTrack() { return LocalTrack(6u, vec4(0.0), vec4(0.0)); }

bool blockedOnTrack(LocalBlock light, sampler2DArray shadowMap, LocalRay ray, float s, inout LocalTrack track) {
  uint face = localFace(light, ray.nearest + s * ray.direction);
  if (face != track.face) {
    track.face = face;
    track.clipNearest = light.shadow[face] * vec4(ray.nearest + light.position, 1.0);
    track.clipStep = light.shadow[face] * vec4(ray.direction, 0.0);
  }
  return blockedInClip(light, shadowMap, face, track.clipNearest + s * track.clipStep);
}

// The sum by `steps` strata of equal angle at the light.
vec3 marchedByAngle(LocalBlock light, sampler2DArray shadowMap, LocalRay ray, float sigma_t, float g, int steps, float offset) {
  if (ray.reached.x >= ray.reached.y) return vec3(0.0);
  // The angle starts at the end that is farther from the light, where it is small and must be exact: side = 1 is the ray's far end.
  float side = ray.reached.x + ray.reached.y >= 0.0 ? 1.0 : -1.0;
  vec2 at = normalize(vec2(side > 0.0 ? ray.reached.y : -ray.reached.x, ray.pass));
  float width = angleBetween(ray.pass, ray.reached.x, ray.reached.y) / float(steps);
  vec2 turn = turnBy(width);
  vec2 sample_ = turnBy((offset - 0.5) * width);
  at = turned(at, turnBy(0.5 * width));
  LocalTrack track = localTrack();
  vec3 sum = vec3(0.0);
  for (int i = 0; i < steps; ++i) {
    vec2 visible = turned(at, sample_);
    float s = side * ray.pass * visible.x / max(visible.y, 1e-9);
    if (!blockedOnTrack(light, shadowMap, ray, clamp(s, ray.reached.x, ray.reached.y), track)) {
      s = side * ray.pass * at.x / max(at.y, 1e-9);
      sum += localRest(light, ray, clamp(s, ray.reached.x, ray.reached.y), sigma_t, g);
    }
    at = turned(at, turn);
  }
  return sum * (width / ray.pass);
}

// The same by strata of equal length.
vec3 marchedByDistance(LocalBlock light, sampler2DArray shadowMap, LocalRay ray, float sigma_t, float g, int steps, float offset) {
  if (ray.reached.x >= ray.reached.y) return vec3(0.0);
  float width = (ray.reached.y - ray.reached.x) / float(steps);
  LocalTrack track = localTrack();
  vec3 sum = vec3(0.0);
  for (int i = 0; i < steps; ++i) {
    float s = ray.reached.x + float(i) * width;
    if (!blockedOnTrack(light, shadowMap, ray, s + offset * width, track))
      sum += localRest(light, ray, s + 0.5 * width, sigma_t, g) * angleBetween(ray.pass, s, s + width);
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
