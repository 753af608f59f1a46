// The reference rays of a slice: inclinations for which the prefix is kept. Needs lib/epipolar.glsl, and in scope `frame` (RectifiedBlock) and
// `light` (RectifiedSunBlock).
const int kWeightsTransmittance = 1;

// Optical depth of the widest row seen across the light, floored: the coordinate of the reference rays needs it above 0.
float referenceKappa() { return max(frame.rays.sigma_t * light.map.reach, 1e-2); }

// Where a cosecant of the inclination lies between the extreme reference rays of a slice: [-1, 1], as Chebyshev nodes are.
float referencePlace(float nodeLow, float nodeHigh, float cosecant_) {
  return clamp((2.0 * referenceCoordinate(cosecant_, referenceKappa()) - nodeLow - nodeHigh) / max(nodeHigh - nodeLow, 1e-6), -1.0, 1.0);
}

// Optical depth that reference ray k of a slice has per metre of distance from the axis; 0 for equal weights.
float referenceTau(Slice s, int k, int count) {
  float node = mix(s.nodeLow, s.nodeHigh, 0.5 + 0.5 * chebyshevNode(k, count));
  return frame.rectified.weights == kWeightsTransmittance ? frame.rays.sigma_t * referenceCosecant(node, referenceKappa()) : 0.0;
}
