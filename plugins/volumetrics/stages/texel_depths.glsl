// Reads a texel of the rectified maps, whichever rectification the frame has. Needs stages/rows.glsl, the bindings `rectified` and
// `projective`, and the constant kFiltered.

// Depths of the two blockers of a texel and the share of the second.
vec3 texelDepths(ivec2 at) {
  if (light.map.slicing == kSlicesByTangent) {
    int columns = int(light.map.columns);
    float depth = warpedDepth(texelFetch(projective, ivec3(at.x, at.y % columns, at.y / columns), 0).x);
    return vec3(depth, depth, 0.0);
  }
  vec4 texel = texelFetch(rectified, ivec3(at, 0), 0);
  return kFiltered ? texel.xyz : vec3(texel.x, texel.x, 0.0);
}
