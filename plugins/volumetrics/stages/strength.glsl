// The strength (and colour) of the light rays of a column, relative to the light's: cone of a spot light, cookie, filtered over the column's
// footprint. Needs stages/rows.glsl, stages/light_rays.glsl, stages/cookie.glsl and lib/local_light.glsl.

// A point of the light ray at a slice and column coordinate: for a sun relative to the eye, for other lights relative to the light.
vec3 onLightRay(Slice s, float slice, float column) {
  vec2 direction = sliceDirection(slice);
  float c = columnDistance(s, column);
  if (kLocal) return lightRay(direction, c);
  return c * (direction.x * light.map.e1 + direction.y * light.map.e2);
}

// Of the column whose first coordinate is `column`, at slice coordinate `slice`.
vec3 columnStrength(Slice s, float slice, float column) {
  vec3 strength = vec3(1.0);
  vec3 middle = onLightRay(s, slice, column + 0.5);
  if (kLocal && opaque(light.local.kind) == kLocalSpot) {
    strength *= coneAttenuation(versineToAxis(middle, light.local.axis, 1.0, 0.0), light.local.coneOuter, light.local.coneScale);
  }
  if (kColoured && opaque(light.cookie.faces) != 0u) {
    vec3 along = onLightRay(s, slice, column + 1.0) - onLightRay(s, slice, column);
    vec3 across = onLightRay(s, slice + 0.5, column + 0.5) - onLightRay(s, slice - 0.5, column + 0.5);
    strength *= cookieColour(light.cookie, (kLocal ? light.local.position : vec3(0.0)) + middle, along, across);
  }
  return strength;
}
