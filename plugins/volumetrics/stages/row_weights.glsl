// The weights that columns have along a view ray itself. Needs stages/rays_on_rows.glsl and stages/reference_rays.glsl.

// What the columns from coordinate `from` to `to` of a row weigh along the ray itself.
float ownWeight(RowRay ray, Slice s, float from, float to) {
  float a = columnDistance(s, from);
  float b = columnDistance(s, to);
  if (opaque(frame.rectified.weights) != kWeightsTransmittance) return b - a;
  if (kLocal) return max(unshadowedTo(ray.theta, b) - unshadowedTo(ray.theta, a), 0.0);
  float safeSine = max(ray.sine, 1e-7);
  return transmittanceIntegral(frame.rays.sigma_t, a / safeSine, b / safeSine);
}
