// Homogeneous medium: transmittance, its integrals, and the phase function.
// Lengths in metres, sigma_t in 1/m (>= 0), g in (-1, 1). Include lib/portable.h first. No include guard on purpose: C++
// includes this text once for each precision.

// 1 - exp(-x) for x >= 0 without cancellation: a Taylor series below 0.05 (next term 0.05^6/720 = 2e-11 absolute, so below
// the rounding of float), the plain form above.
LIB Real oneMinusExp(Real x) {
  return x < R(0.05)
             ? x * (R(1.0) - x * (R(1.0) / R(2.0)) * (R(1.0) - x * (R(1.0) / R(3.0)) *
                   (R(1.0) - x * R(0.25) * (R(1.0) - x * R(0.2)))))
             : R(1.0) - exp(-x);
}

// Integral of exp(-sigma_t t) over [a, b], metres. 0 <= a <= b.
LIB Real transmittanceIntegral(Real sigma_t, Real a, Real b) {
  Real x = sigma_t * (b - a);
  // For sigma_t -> 0 the quotient is 0/0; the series' first terms are exact to rounding below 1e-4.
  return exp(-sigma_t * a) * (x < R(1e-4) ? (b - a) * (R(1.0) - R(0.5) * x) : oneMinusExp(x) / sigma_t);
}

// The distance in [0, length] at which the share `u` in [0, 1] of the integral of exp(-sigma_t t) over [0, length] is reached
// (inverse of the cumulative transmittance: equal steps in u are equal steps in transmittance).
LIB Real distanceAtTransmittanceShare(Real sigma_t, Real length_, Real u) {
  Real x = sigma_t * length_;
  // t = -log(1 - u (1 - e^-x)) / sigma_t; first-order expansion u length (1 - (1 - u) x / 2) where x is tiny.
  return x < R(1e-3) ? u * length_ * (R(1.0) - R(0.5) * x * (R(1.0) - u))
                     : min(-log(max(R(1.0) - u * oneMinusExp(x), R(1e-30))) / sigma_t, length_);
}

// Henyey and Greenstein 1941, "Diffuse radiation in the galaxy": phase function, normalised over the sphere (1/sr).
// `cosine` is that of the angle between the direction the light travels and the direction it is scattered to; g > 0 is
// forward: brightest when looking towards the light.
LIB Real phaseHenyeyGreenstein(Real cosine, Real g) {
  // 1 + g^2 - 2 g cos = (1 - |g|)^2 + 2 |g| (1 -+ cos): a sum of what is positive, where the lobe is narrow too.
  Real a = abs(g), narrow = R(1.0) - a;
  Real d = narrow * narrow + R(2.0) * a * (R(1.0) - (g < R(0.0) ? -cosine : cosine));
  d = max(d, R(1e-12)); // 0 only for |g| = 1
  return narrow * (R(1.0) + a) * R(0.07957747154594767) / (d * sqrt(d)); // 1/(4 pi)
}
