// The epipolar frame (Peters et al. 2017, section 5.1.1; Baran et al. 2010): O is the eye, `a` the unit vector from the eye
// towards the light. Of a point q: slice azimuth phi about a, inclination theta between q-O and a, and for a directional
// light the column c = t sin(theta), the distance from the axis. theta is constant along a view ray and grows along a light ray.
// Peters counts the inclination from the other end (pi - theta); theta is used so that "depth" grows away from the light.
// Needs lib/medium.glsl before it.

// Inclination of the point at distance c >= 0 from the axis and height s along it. Range [0, pi].
LIB Real inclination(Real c, Real s) { return atan(c, s); }

// Normalised depth in [0, 1] of an inclination, clamped to the map's range (a guard band is part of the range).
LIB Real normalisedInclination(Real theta, Real thetaMin, Real thetaMax) {
  return clamp((theta - thetaMin) / (thetaMax - thetaMin), R(0.0), R(1.0));
}

// The part of t in [0, 1e30) of the planar ray p = t * d (d unit) that lies inside the half-plane n.p <= h, applied to the
// interval (first, last). An empty interval comes back with last < first.
LIB Real2 clipToHalfPlane(Real2 interval, Real along, Real h) {
  if (abs(along) < R(1e-12)) {
    return h >= R(0.0) ? interval : Real2(R(1.0), R(0.0));
  }
  Real t = h / along;
  return along > R(0.0) ? Real2(interval.x, min(interval.y, t)) : Real2(max(interval.x, t), interval.y);
}

// Inclinations theta in [lo, hi] for which A cos(theta) + B sin(theta) >= 0, intersected with `interval` (inside [0, pi]). One
// side plane of the frustum cuts a slice there: A = n.a, B = n.(cos(phi) e1 + sin(phi) e2).
// The arc is one interval of length pi about atan2(B, A), taken so that its end is not below 0; in [0, pi] it is one interval.
LIB Real2 clipToFrustumPlane(Real2 interval, Real A, Real B) {
  const Real halfPi = R(1.5707963267948966);
  Real centre = atan(B, A);
  centre = centre < -halfPi ? centre + R(4.0) * halfPi : centre;
  return Real2(max(interval.x, centre - halfPi), min(interval.y, centre + halfPi));
}

// The k-th of `count` Chebyshev nodes on [-1, 1], cos((2k+1) pi / (2 count)).
LIB Real chebyshevNode(int k, int count) {
  return cos(R(3.14159265358979324) * (R(2.0) * Real(k) + R(1.0)) / (R(2.0) * Real(count)));
}

// Lagrange weight of node k at x for `count` Chebyshev nodes on [-1, 1]. The weights of all k sum to 1.
LIB Real chebyshevLagrange(int k, int count, Real x) {
  Real own = chebyshevNode(k, count);
  Real weight = R(1.0);
  for (int j = 0; j < count; ++j) {
    if (j != k) {
      Real other = chebyshevNode(j, count);
      weight *= (x - other) / (own - other);
    }
  }
  return weight;
}

// Coordinate in which the reference inclinations are spread, for a directional light: log(1 + kappa cosecant(theta)), with kappa the
// optical depth (> 0) of the widest row seen across the light. The weights depend on theta through its cosecant only; as long as kappa
// times it is small they hardly change with it, and beyond they change with its logarithm. sin(theta) is floored at 0.02:
// below it the whole slice is nearer to the epipole than a pixel.
LIB Real cosecant(Real theta) { return R(1.0) / max(sin(theta), R(0.02)); }
LIB Real referenceCoordinate(Real cosecant_, Real kappa) { return log(R(1.0) + kappa * cosecant_); }
// Its inverse.
LIB Real referenceCosecant(Real coordinate, Real kappa) { return (exp(coordinate) - R(1.0)) / kappa; }

// Columns of a row that grow evenly away from the eye: the share of the row's length that its first share `at` of columns spans, and its
// inverse. `nearest`, in (0, 1], is the width of the first columns in even ones (the last are 2 - nearest of them); 1: all are even. Being
// quadratic, the columns' transmittances follow by products alone.
LIB Real columnsReach(Real nearest, Real at) { return at * (nearest + (R(1.0) - nearest) * at); }
LIB Real columnsWithin(Real nearest, Real reach) {
  return R(2.0) * reach / (nearest + sqrt(nearest * nearest + R(4.0) * (R(1.0) - nearest) * reach));
}

// The least width of a row's first columns.
const Real kLeastNearest = R(0.1);

// Width of the first columns, in even ones, at which columns pass equal parts of the transmittance of a row of optical depth x.
LIB Real nearestForTransmittance(Real x) { return x < R(1e-3) ? R(1.0) - R(0.5) * x : max(oneMinusExp(x) / x, kLeastNearest); }

// sinh(x/2) / (x/2): what a column of optical depth x weighs against the transmittance in its middle times its width. Terms up to x^6:
// within 1e-4 up to x = 3; a column of far more leaves nothing to the next, so that what it weighs no longer matters.
LIB Real columnFullness(Real x) {
  Real most = min(x, R(16.0));
  Real y = most * most;
  return R(1.0) + y * (R(1.0 / 24.0) + y * (R(1.0 / 1920.0) + y * R(1.0 / 322560.0)));
}

// Share that column u adds to the running normalised average of columns 0..u, for weights exp(-u x) (1 - exp(-x)):
// w_u / sum_{j<=u} w_j, with x = sigma_t * column width / sin(theta) >= 0. For x = 0: 1/(u+1).
LIB Real runningWeight(Real u, Real x) {
  Real n = u + R(1.0);
  return x * n < R(1e-4) ? (R(1.0) - R(0.5) * x * u) / n : exp(-u * x) * oneMinusExp(x) / oneMinusExp(n * x);
}
