// View rays from the RayBlock and the scene's reversed depth.

// Direction of the pixel's ray, not normalised: its length is 1/cos of the angle to the optical axis.
vec3 rayDirection(RayBlock rays, uvec2 pixel) {
  vec2 ndc = (vec2(pixel) + 0.5) * rays.pixelScale - 1.0;
  return rays.forward + ndc.x * rays.right - ndc.y * rays.up;
}

// Distance along the optical axis, m, of a reversed depth: 1 at znear, 0 at zfar.
float axialDistance(RayBlock rays, float depth) {
  return rays.znear * rays.zfar / (rays.znear + depth * (rays.zfar - rays.znear));
}
