// Bounds on a distribution from its moments (Peters et al. 2017, "Improved Moment Shadow Maps for Translucent Occluders, Soft
// Shadows and Single Scattering", JCGT 6.1: algorithm 1, sections 2.4, 2.5, 5.3, 5.4).
// Depths z are in [-1, 1]; moment j is the mean of z^j. Four moments: Real4(b1..b4). Six: odd = (b1, b3, b5), even = (b2, b4, b6).
// "Visibility at zf": the share of the distribution with z >= zf, i.e. of light rays whose first blocker is not before zf.
// beta in [0, 1]: 0 gives the sharp lower bound of visibility, 1 the sharp upper bound (overestimation of scattering).
// Deviation: roots that coincide get zero divided differences instead of 0/0, and near-zero pivots are floored, so that every
// finite input gives a result in [0, 1].

// ---------------------------------------------------------------- quantisation transforms (sections 2.4 and 5.4.3)
// Affine maps that spread the moments of distributions on [-1, 1] over [0, 1], for storage in unsigned normalised integers.

// Equation 3.
LIB Real4 quantise4(Real4 b) {
  return Real4(R(1.5) * b.x - R(2.0) * b.z + R(0.5), R(4.0) * (b.y - b.w),
               R(0.8660254037844386) * b.x - R(0.3849001794597505) * b.z + R(0.5), R(0.5) * (b.y + b.w));
}

// Inverse of equation 3: odd and even part each by Cramer's rule, solved by hand.
// Odd: p = 3/2 b1 - 2 b3, q = sqrt(3)/2 b1 - 2 sqrt(3)/9 b3; det = -sqrt(3)/3 + sqrt(3) = 2 sqrt(3)/3.
LIB Real4 dequantise4(Real4 s) {
  Real p = s.x - R(0.5);
  Real q = s.z - R(0.5);
  const Real inverseDet = R(0.8660254037844386); // 3 / (2 sqrt(3)) = sqrt(3)/2
  Real b1 = inverseDet * (R(2.0) * q - R(0.3849001794597505) * p);
  Real b3 = inverseDet * (R(1.5) * q - R(0.8660254037844386) * p);
  return Real4(b1, s.w + R(0.125) * s.y, b3, s.w - R(0.125) * s.y);
}

// Section 5.4.3: the transform for six moments (optimised by the authors for entropy; odd and even moments apart).
LIB Real3 quantise6Odd(Real3 b) {
  return Real3(R(2.5) * b.x - R(10.0) * b.y + R(8.0) * b.z + R(0.5),
               R(-1.87499864) * b.x + R(4.20757543) * b.y - R(1.83257679) * b.z + R(0.5),
               R(1.26583039) * b.x - R(1.47644883) * b.y + R(0.71061660) * b.z + R(0.5));
}
LIB Real3 quantise6Even(Real3 b) {
  return Real3(R(4.0) * (b.x - b.y), R(9.0) * b.x - R(24.0) * b.y + R(16.0) * b.z,
               R(-0.57759806) * b.x + R(4.61936648) * b.y - R(3.07953907) * b.z + R(0.018888946));
}
// Inverses of the two matrices above, computed in double precision (the unit test multiplies them out).
LIB Real3 dequantise6Odd(Real3 s) {
  Real3 t = s - Real3(R(0.5));
  return Real3(R(-0.028777890285483478) * t.x + R(0.47635550986261954) * t.y + R(1.5524280933582475) * t.z, R(0.099952358753959802) * t.x + R(0.84532581412243912) * t.y + R(1.0547257085142083) * t.z,
               R(0.25893353915666334) * t.x + R(0.9077961708209803) * t.y + R(0.83327335646830814) * t.z);
}
LIB Real3 dequantise6Even(Real3 s) {
  Real z = s.z - R(0.018888946);
  return Real3(R(1.2530305023071764e-05) * s.x + R(0.16668494115579588) * s.y + R(0.86602540116262727) * z, R(-0.24998746969497693) * s.x + R(0.16668494115579588) * s.y + R(0.86602540116262727) * z,
               R(-0.37498825283904086) * s.x + R(0.21876713233355866) * s.y + R(0.81189881358996308) * z);
}

// ------------------------------------------------------------------------------------------- biasing (sections 2.5 and 5.4.3)
// Interpolates towards the moments of a distribution far from the border of the valid domain, so that rounding errors cannot
// make the input invalid. `alpha` is the moment bias.
LIB Real4 bias4(Real4 b, Real alpha, Real evenTarget) {
  return mix(b, Real4(R(0.0), evenTarget, R(0.0), evenTarget), alpha);
}
LIB Real3 bias6Odd(Real3 b, Real alpha) { return b * (R(1.0) - alpha); }
LIB Real3 bias6Even(Real3 b, Real alpha) { return mix(b, Real3(R(0.5566), R(0.489), R(0.47869382)), alpha); }

// --------------------------------------------------------------------------------------------------------------- helpers

// (value of b - value of a) / (b - a) for values that are 0, 1 or beta; 0 where the values agree, even if the places do too.
LIB Real dividedDifference(Real valueA, Real valueB, Real a, Real b) {
  Real rise = valueB - valueA;
  Real run = b - a;
  run = abs(run) < R(1e-12) ? (run < R(0.0) ? R(-1e-12) : R(1e-12)) : run;
  return rise == R(0.0) ? R(0.0) : rise / run;
}

// x in [0, 1], and 0 for anything that is not a number.
LIB Real saturateFinite(Real x) { return x > R(0.0) ? min(x, R(1.0)) : R(0.0); }

// A pivot of a positive definite matrix, kept off zero.
LIB Real pivot(Real x) { return max(x, R(1e-14)); }

// Roots of c0 + c1 z + c2 z^2, real ones expected, without cancellation: one as h / c2, the other as c0 / h, where h adds numbers of
// the same sign. A root at infinity comes back as a large number.
LIB Real2 quadraticRoots(Real c0, Real c1, Real c2) {
  Real root = sqrt(max(c1 * c1 - R(4.0) * c0 * c2, R(0.0)));
  Real h = R(-0.5) * (c1 < R(0.0) ? c1 - root : c1 + root);
  return Real2(h / (abs(c2) < R(1e-20) ? R(1e-20) : c2), c0 / (abs(h) < R(1e-20) ? R(1e-20) : h));
}

// ------------------------------------------------------------------------------------------------------------ four moments

// Visibility at zf from biased moments (algorithm 1 for m = 4). The three depths of the extremal distribution are zf and the roots
// of a quadratic; the result is the expectation of the quadratic polynomial through (zf, beta), (z1, v1), (z2, v2).
LIB Real visibility4(Real4 b, Real zf, Real beta) {
  // B = L D L^T of the Hankel matrix (1 b1 b2; b1 b2 b3; b2 b3 b4), then B q = (1, zf, zf^2).
  Real d1 = pivot(b.y - b.x * b.x);
  Real l21 = (b.z - b.x * b.y) / d1;
  Real d2 = pivot(b.w - b.y * b.y - l21 * l21 * d1);
  Real y1 = zf - b.x;
  Real y2 = zf * zf - b.y - l21 * y1;
  Real q2 = y2 / d2;
  Real q1 = y1 / d1 - l21 * q2;
  Real q0 = R(1.0) - b.x * q1 - b.y * q2;
  // Roots of q2 z^2 + q1 z + q0: real, since B is positive definite. q2 -> 0 sends one root to infinity, where its weight vanishes.
  Real2 z = quadraticRoots(q0, q1, q2);
  Real z1 = z.x;
  Real z2 = z.y;
  Real v1 = z1 < zf ? R(0.0) : R(1.0);
  Real v2 = z2 < zf ? R(0.0) : R(1.0);
  // Newton form on (zf, z1, z2), expectation through b1 and b2.
  Real f01 = dividedDifference(beta, v1, zf, z1);
  Real f12 = dividedDifference(v1, v2, z1, z2);
  Real f012 = dividedDifference(f01, f12, zf, z2);
  Real e1 = b.x - zf;
  Real e2 = b.y - b.x * (zf + z1) + zf * z1;
  return saturateFinite(beta + f01 * e1 + f012 * e2);
}

// ------------------------------------------------------------------------------------------------------- two depths of a sample

// Algorithm 2 of Peters et al. 2017 (section 5.2): the distribution on two depths with moments b1, b2, b3 (b.w is not read), as
// (z1, z2, w1, w2), z1 <= z2, w1 + w2 = 1: what filtered resampling makes of a sample of a moment shadow map. With variance v
// and third central moment m about the mean b1, the depths are b1 + m / 2v -+ sqrt((m / 2v)^2 + v).
// Robust for every finite input: b1 and the depths are clamped to [-1, 1], where valid moments put them anyway; b1 stays exact,
// since the shares are computed from the clamped depths. A variance of 1e-6 or less gives the single depth b1 (the paper: 0
// or less): rounding b1 and b2 to float moves their difference by up to 2.4e-7, and m / 2v would be noise. Two depths of equal share
// are told apart from a distance of 0.002 on, a thousandth of the range.
LIB Real4 twoDepths(Real4 b) {
  Real mean = clamp(b.x, R(-1.0), R(1.0));
  Real variance = b.y - mean * mean;
  if (!(variance > R(1e-6))) {
    return Real4(mean, mean, R(1.0), R(0.0));
  }
  Real skew = R(0.5) * ((b.z - mean * b.y) / variance - R(2.0) * mean);
  // Offsets from the mean, on the skew's side (`far`) and on the other. Their product is the variance, also after a clamp of either,
  // so that b2 is kept where rounding made b3 impossible.
  Real farRoom = skew < R(0.0) ? mean + R(1.0) : R(1.0) - mean;
  Real nearRoom = skew < R(0.0) ? R(1.0) - mean : mean + R(1.0);
  Real far = min(abs(skew) + sqrt(skew * skew + variance), farRoom);
  Real near = min(variance / far, nearRoom);
  far = min(variance / near, farRoom);
  Real below = skew < R(0.0) ? far : near;
  Real above = skew < R(0.0) ? near : far;
  Real w2 = below > R(0.0) ? below / (below + above) : R(0.0);
  return Real4(mean - below, mean + above, R(1.0) - w2, w2);
}

// ------------------------------------------------------------------------------------------------------------- six moments

// Roots of c.x + c.y z + c.z z^2 + c.w z^3, all real (three distinct roots for a positive definite Hankel matrix). The root of
// largest magnitude comes from the trigonometric form in Blinn's homogeneous coefficients (Blinn 2007, "How to Solve a Cubic
// Equation, Part 5"), where it is a sum of numbers of one sign; dividing it out leaves a quadratic for the other two.
// Deviation: Peters et al. 2017, section 5.4.1 take all three from the trigonometric form. Then a far root (c.w small: the ray's
// depth lies on a blocker's) leaves the near ones an absolute error of 1e-7 of the far one's size, which in float broke the
// bounds by up to 0.4 (docs/results/stress.md).
LIB Real3 cubicRoots(Real4 c) {
  Real lead = max(max(abs(c.x), abs(c.y)), abs(c.z)) * R(1e-7);
  lead = max(lead, R(1e-30));
  Real w = abs(c.w) < lead ? (c.w < R(0.0) ? -lead : lead) : c.w;
  Real B = c.z / (R(3.0) * w);
  Real C = c.y / (R(3.0) * w);
  Real D = c.x / w;
  // z^3 + 3 B z^2 + 3 C z + D;  t = z + B  ->  t^3 + 3 p t + q.
  Real p = C - B * B;
  Real d2 = D - B * C;
  Real q = d2 - R(2.0) * B * p;
  Real discriminant = max(R(4.0) * p * (B * D - C * C) - d2 * d2, R(0.0));
  Real angle = atan(sqrt(discriminant), -q) / R(3.0);
  Real amplitude = R(2.0) * sqrt(max(-p, R(0.0)));
  // The sum of -B and the term of its sign; the factor of the amplitude has a magnitude of at least 1/2 either way.
  Real largest = amplitude * (B < R(0.0) ? cos(angle) : R(-0.5) * cos(angle) - R(0.8660254037844386) * sin(angle)) - B;
  Real u = R(1.0) / (abs(largest) < R(1e-12) ? R(1e-12) : largest);
  // One Newton step on 1/z: Vulkan lets sine and cosine err by 2^-11 and atan by 4096 ulp, which alone breaks the bounds by 0.2.
  Real value = ((c.x * u + c.y) * u + c.z) * u + c.w;
  Real slope = (R(3.0) * c.x * u + R(2.0) * c.y) * u + c.z;
  u -= abs(value) < abs(slope * u) ? value / slope : R(0.0);
  largest = R(1.0) / (abs(u) < R(1e-12) ? R(1e-12) : u);
  // c = (1 - u z) (c.x + c1 z + c2 z^2), from the constant term upwards, which is stable for the largest root.
  Real c1 = c.y + c.x * u;
  Real2 others = quadraticRoots(c.x, c1, c.z + c1 * u);
  return Real3(largest, others.x, others.y);
}

// Visibility at zf from biased moments (algorithm 1 for m = 6; sections 5.4.1 and 5.4.2).
LIB Real visibility6(Real3 odd, Real3 even, Real zf, Real beta) {
  Real b1 = odd.x; Real b2 = even.x; Real b3 = odd.y; Real b4 = even.y; Real b5 = odd.z; Real b6 = even.z;
  // L D L^T of the 4x4 Hankel matrix.
  Real d1 = pivot(b2 - b1 * b1);
  Real l21 = (b3 - b1 * b2) / d1;
  Real l31 = (b4 - b1 * b3) / d1;
  Real d2 = pivot(b4 - b2 * b2 - l21 * l21 * d1);
  Real l32 = (b5 - b2 * b3 - l31 * l21 * d1) / d2;
  Real d3 = pivot(b6 - b3 * b3 - l31 * l31 * d1 - l32 * l32 * d2);
  // B q = (1, zf, zf^2, zf^3).
  Real z2f = zf * zf;
  Real y1 = zf - b1;
  Real y2 = z2f - b2 - l21 * y1;
  Real y3 = z2f * zf - b3 - l31 * y1 - l32 * y2;
  Real q3 = y3 / d3;
  Real q2 = y2 / d2 - l32 * q3;
  Real q1 = y1 / d1 - l21 * q2 - l31 * q3;
  Real q0 = R(1.0) - b1 * q1 - b2 * q2 - b3 * q3;
  Real3 z = cubicRoots(Real4(q0, q1, q2, q3));
  Real v1 = z.x < zf ? R(0.0) : R(1.0);
  Real v2 = z.y < zf ? R(0.0) : R(1.0);
  Real v3 = z.z < zf ? R(0.0) : R(1.0);
  // Newton form on (zf, z.x, z.y, z.z), turned to the canonical basis by expanding the nested products.
  Real f01 = dividedDifference(beta, v1, zf, z.x);
  Real f12 = dividedDifference(v1, v2, z.x, z.y);
  Real f23 = dividedDifference(v2, v3, z.y, z.z);
  Real f012 = dividedDifference(f01, f12, zf, z.y);
  Real f123 = dividedDifference(f12, f23, z.x, z.z);
  Real f0123 = dividedDifference(f012, f123, zf, z.z);
  // ((f0123 (z - z2) + f012) (z - z1) + f01) (z - zf) + beta, coefficients u0..u3.
  Real u3 = f0123;
  Real u2 = f012 - f0123 * z.y;
  Real u1 = f01 - u2 * z.x;
  u2 = u2 - u3 * z.x;
  Real u0 = beta - u1 * zf;
  u1 = u1 - u2 * zf;
  u2 = u2 - u3 * zf;
  return saturateFinite(u0 + u1 * b1 + u2 * b2 + u3 * b3);
}
