// The reference rays of a slice: inclinations for which the prefix is kept. Needs lib/epipolar.glsl, lib/local_row.glsl and
// stages/rows.glsl, and in scope `frame` (RectifiedBlock) and `light` (RectifiedLightBlock).
const int kWeightsTransmittance = 1;

// Optical depth of the widest row seen across the light, floored: the coordinate of the reference rays needs it above 0.
float referenceKappa() { return max(frame.rays.sigma_t * light.map.reach, 1e-2); }

// The coordinate in which the reference inclinations of a slice are spread: for a sun that of lib/epipolar.glsl, for other lights
// log(theta/(pi - theta)): near the light weights change with log(theta), and near its antipode, where psi ends at pi - theta, with the
// logarithm of that. Both are floored as the sine is there.
float referencePosition(float theta) {
  return kLocal ? log(max(theta, 0.02) / max(kPi - theta, 0.02)) : referenceCoordinate(cosecant(theta), referenceKappa());
}

// Where an inclination lies between the extreme reference rays of a slice: [-1, 1], as Chebyshev nodes are.
float referencePlace(float nodeLow, float nodeHigh, float theta) {
  return clamp((2.0 * referencePosition(theta) - nodeLow - nodeHigh) / max(nodeHigh - nodeLow, 1e-6), -1.0, 1.0);
}

// Part of a prefix's optical depth (across the light) that its coordinate between reference rays is made with, and how many rays that is good
// for. Found by the worst error of the weights over steps of visibility, with suns on and off the screen: against the row's own coordinate half of
// it for three rays, two thirds for two and four. More rays would multiply rounding of their sums by hundreds near the light, and gain nothing.
const float kPrefixKappa = 0.15;
const int kMostByPrefix = 4;
// Slices whose reference coordinates span less have practically one inclination; a prefix's coordinate needs a depth above 0.
const float kLeastSpan = 1e-3, kLeastKappa = 0.01;

// The part that each reference ray has in a prefix of `length_` m for inclination theta; together 1. The weights of a short prefix hardly differ
// with the cosecant and change with it evenly, those of a long one with its logarithm: for a sun the Lagrange polynomial is taken in log(1 + kappa
// cosecant) with a kappa of the prefix, not of the row. (nodeLow, nodeHigh): of the slice.
void referenceShares(float nodeLow, float nodeHigh, float theta, float length_, out float share[kReferenceRays]) {
  if (kReferenceRays == 1) {
    share[0] = 1.0;
    return;
  }
  if (kLocal || kReferenceRays > kMostByPrefix || nodeHigh - nodeLow < kLeastSpan) {
    float place = referencePlace(nodeLow, nodeHigh, theta);
    for (int k = 0; k < kReferenceRays; ++k) share[k] = chebyshevLagrange(k, kReferenceRays, place);
    return;
  }
  float row = referenceKappa();
  float kappa = max(kPrefixKappa * frame.rays.sigma_t * length_, kLeastKappa);
  float at[kReferenceRays];
  for (int k = 0; k < kReferenceRays; ++k)
    at[k] = log(1.0 + kappa * referenceCosecant(mix(nodeLow, nodeHigh, 0.5 + 0.5 * chebyshevNode(k, kReferenceRays)), row));
  float x = log(1.0 + kappa * clamp(cosecant(theta), referenceCosecant(nodeLow, row), referenceCosecant(nodeHigh, row)));
  for (int k = 0; k < kReferenceRays; ++k) {
    share[k] = 1.0;
    for (int j = 0; j < kReferenceRays; ++j)
      if (j != k) share[k] *= (x - at[j]) / (at[k] - at[j]);
  }
}

// What the weights of reference ray k of a slice depend on: for a sun its optical depth per metre of distance from the axis, 0 for equal
// weights; for other lights its inclination.
float referenceKey(Slice s, int k, int count) {
  float node = mix(s.nodeLow, s.nodeHigh, 0.5 + 0.5 * chebyshevNode(k, count));
  if (kLocal) return kPi / (1.0 + exp(-node));
  return opaque(frame.rectified.weights) == kWeightsTransmittance ? frame.rays.sigma_t * referenceCosecant(node, referenceKappa()) : 0.0;
}

float rangeOverDistance() { return opaque(light.local.range / light.distance); }

// Weight of the columns between two coordinates for a reference ray, but for a factor that all columns of a slice share.
float referenceWeight(Slice s, float key, float from, float to) {
  float a = columnDistance(s, from);
  float b = columnDistance(s, to);
  if (!kLocal) return transmittanceIntegral(key, a - s.first, b - s.first);
  if (opaque(frame.rectified.weights) != kWeightsTransmittance) return b - a;
  return (b - a) * localWeight(key, 0.5 * (a + b), frame.rays.sigma_t * light.distance, opaque(frame.rays.g), rangeOverDistance(), light.mostWay,
                               light.leastWindow);
}
