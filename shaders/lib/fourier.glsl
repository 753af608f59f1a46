// The Fourier basis of the shadow test (Klehm et al. 2014, "Filter-based Real-time Single Scattering using Rectified Shadow Maps",
// JCGT 3.3, equations 8 to 10, after Annen et al. 2007): for depths in [0, 1] the share of light rays that reach depth z,
// i.e. the mean of [z <= blocker], is 1/2 + sum over k of a_k(z) mean(B_k(blocker)), with frequencies c_k = (2k + 1) pi, k = 0, 1, ...
// A texel (`layer`) holds two frequencies: (sin c0 d, cos c0 d, sin c1 d, cos c1 d), c0 = c of k = 2 layer.
// Deviation: sines and cosines of successive frequencies come from one rotation by 2 pi z each instead of two transcendental
// functions; over the 64 frequencies allowed, rounding in float stays below 4e-5 (tests/stability).

// (cos, sin) of c_k z for k = 2 layer: where a run of layers starts.
LIB Real2 fourierStart(Real z, int layer) {
  Real c = R(3.14159265358979324) * (R(4.0) * Real(layer) + R(1.0));
  return Real2(cos(c * z), sin(c * z));
}

// (cos, sin) of 2 pi z: what takes one frequency to the next.
LIB Real2 fourierTurn(Real z) {
  Real c = R(6.28318530717958648) * z;
  return Real2(cos(c), sin(c));
}

// The next frequency's (cos, sin): a product of complex numbers.
LIB Real2 fourierNext(Real2 phase, Real2 turn) {
  return Real2(phase.x * turn.x - phase.y * turn.y, phase.x * turn.y + phase.y * turn.x);
}

// Texel of the basis at a blocker's depth from its two phases, components in [-1, 1].
LIB Real4 fourierBasis(Real2 first, Real2 second) { return Real4(first.y, first.x, second.y, second.x); }

// Coefficients of the same texel for a ray's depth: 2/c (cos, -sin) of each frequency (equation 8).
LIB Real4 fourierCoefficients(Real2 first, Real2 second, int layer) {
  Real a = R(0.63661977236758134) / (R(4.0) * Real(layer) + R(1.0)); // 2 / c_{2 layer}
  Real b = R(0.63661977236758134) / (R(4.0) * Real(layer) + R(3.0));
  return Real4(a * first.x, -a * first.y, b * second.x, -b * second.y);
}

// Ones for the components of `layer` that a basis of `count` functions (sines and cosines counted) has, zeros for the rest.
LIB Real4 fourierMask(int layer, int count) {
  int left = count - 4 * layer;
  return Real4(left > 0 ? R(1.0) : R(0.0), left > 1 ? R(1.0) : R(0.0), left > 2 ? R(1.0) : R(0.0), left > 3 ? R(1.0) : R(0.0));
}
