// Light rays of a spot or point light in the epipolar frame. Needs stages/rows.glsl.

// Unit direction, away from the light, of the light ray at angle psi in the slice of `direction` (along e1, e2).
vec3 lightRay(vec2 direction, float psi) {
  vec3 e = direction.x * light.map.e1 + direction.y * light.map.e2;
  return sin(psi) * e - cos(psi) * light.sun.towards;
}
