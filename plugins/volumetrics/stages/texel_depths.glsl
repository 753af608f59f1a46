// Reads a texel of the rectified maps, whichever rectification the frame has. Needs stages/rows.glsl, the bindings `rectified` and
// `projective`, and the constant kFiltered.

// Depths of the two blockers of a texel and the share of the second.
vec3 texelDepths(ivec2 at) {
  if (byTangent()) {
    int columns = int(light.map.columns);
    float stored = texelFetch(projective, ivec3(at.x, at.y % columns, at.y / columns), 0).x;
    vec2 direction = sliceDirection(float(at.x) + 0.5);
    // What was clamped to 0 lies nearer to the light than every view ray, so it may be put at the end of the range: as far from the rays'
    // depths as can be, where a basis resolves it best.
    float depth = stored <= 0.0 ? 0.0
                : stored < 1.0  ? rectifiedDepth(1.0, -direction.x * (stored / light.map.rasterScale + light.map.rasterLow))
                                : 1.0;
    return vec3(depth, depth, 0.0);
  }
  vec4 texel = texelFetch(rectified, ivec3(at, 0), 0);
  return kFiltered ? texel.xyz : vec3(texel.x, texel.x, 0.0);
}
