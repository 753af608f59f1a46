// A view ray as a spot or point light sees it: what part of the ray the light reaches, and distance along the ray as an angle at
// the light. Lengths in metres, angles in radians. Include lib/portable.h first. No include guard on purpose: C++ includes this text
// once for each precision.
//
// Along the ray, s is the distance from the point nearest to the light; `pass` is that point's distance from the light. So the distance
// from the light is sqrt(s^2 + pass^2), and intervals of s are empty where x >= y.
// Equal angles (Kulla and Fajardo 2012, "Importance Sampling Techniques for Path Tracing in Participating Media", section 4.1): with
// s = pass cot(a), ds/(s^2 + pass^2) = -da/pass, so that the inverse square is gone.

// The part of `interval` within `range` of the light; range 0 is unlimited.
LIB Real2 clipToRange(Real2 interval, Real pass, Real range) {
  if (range <= R(0.0)) return interval;
  Real half2 = range * range - pass * pass;
  if (half2 <= R(0.0)) return Real2(R(1.0), R(0.0));
  Real half_ = sqrt(half2);
  return Real2(max(interval.x, -half_), min(interval.y, half_));
}

// The part inside a cone whose apex is the light and whose outer half angle, at most pi/2, has this cosine and sine. `direction` is the
// ray's, `nearest` the vector from the light to the ray's nearest point, `axis` the cone's; direction and axis of length one.
// On the boundary A s^2 + 2 B s + C = 0, with along = direction.axis, across = nearest.axis, and u and n the squares of the parts of direction
// and nearest at right angles to the axis:
//   A = sin^2 along^2 - cos^2 u,  B = along across,  C = sin^2 across^2 - cos^2 n,
//   B^2 - A C = cos^2 (sin^2 (across^2 + along^2 pass^2) - cos^2 (axis.(nearest x direction))^2).
// Nothing in it is a difference of numbers near one, so that narrow cones keep their digits. The cone is convex: there is one part at most.
LIB Real2 clipToCone(Real2 interval, Real3 direction, Real3 nearest, Real3 axis, Real cosOuter, Real sinOuter) {
  Real c2 = cosOuter * cosOuter;
  Real s2 = sinOuter * sinOuter;
  Real along = dot(direction, axis);
  Real across = dot(nearest, axis);
  Real3 u = cross(direction, axis);
  Real3 n = cross(nearest, axis);
  Real beside = dot(axis, cross(nearest, direction));
  Real a = s2 * along * along - c2 * dot(u, u);
  Real b = along * across;
  Real c = s2 * across * across - c2 * dot(n, n);
  Real discriminant = c2 * (s2 * (across * across + along * along * dot(nearest, nearest)) - c2 * beside * beside);
  // a < 0: the ray is steeper than the cone's side and meets one nappe twice or nothing; it is the light's own where across > 0.
  if (a < R(0.0) && (discriminant <= R(0.0) || across <= R(0.0))) return Real2(R(1.0), R(0.0));
  Real root = sqrt(max(discriminant, R(0.0)));
  Real q = -(b + (b < R(0.0) ? -root : root));
  Real first = q == R(0.0) ? R(0.0) : c / q;
  // a = 0: the ray is parallel to the cone's side and meets it once.
  Real second = a == R(0.0) ? (q < R(0.0) ? R(-1e30) : R(1e30)) : q / a;
  Real low = min(first, second);
  Real high = max(first, second);
  if (a < R(0.0)) return Real2(max(interval.x, low), min(interval.y, high));
  // The ray comes from one nappe and goes into the other: the light's own is where it goes to if along > 0.
  return along > R(0.0) ? Real2(max(interval.x, high), interval.y) : Real2(interval.x, min(interval.y, low));
}

// 1 - cos of the angle at the light between `axis` (length one) and `from`, a vector from the light: |from x axis|^2/(d (d + from.axis)),
// which keeps its digits on the axis. `distance2` is the square of the distance d and `more` what that was raised by where the point counts as
// farther off than it is, across the axis (docs/conventions.md, "Near a lamp"): from.from + more.
LIB Real versineToAxis(Real3 from, Real3 axis, Real distance2, Real more) {
  Real along = dot(from, axis);
  Real3 beside = cross(from, axis);
  Real d = sqrt(distance2);
  return along > R(0.0) ? (dot(beside, beside) + more) / (d * (d + along)) : R(1.0) - along / d;
}

// KHR_lights_punctual, without the inverse square: the range's window (recommended there, after Karis 2013, "Real Shading in Unreal
// Engine 4", equation 9) and the cone, as shared/lamp.h keeps it. A point light has versine 0, outer 1 and scale 1.
LIB Real coneAttenuation(Real versine_, Real coneOuter, Real coneScale) {
  Real cone = clamp((coneOuter - versine_) * coneScale, R(0.0), R(1.0));
  return cone * cone;
}
LIB Real localAttenuation(Real distance2, Real range, Real versine_, Real coneOuter, Real coneScale) {
  Real q = range > R(0.0) ? distance2 / (range * range) : R(0.0);
  return clamp(R(1.0) - q * q, R(0.0), R(1.0)) * coneAttenuation(versine_, coneOuter, coneScale);
}

// Angle at the light between two points of the ray, from <= to. One arc tangent of a difference, not a difference of two.
LIB Real angleBetween(Real pass, Real from, Real to) { return atan(pass * (to - from), pass * pass + from * to); }

// (cosine, sine), by their series where the angle is small: a device may give sines no more than an absolute error of 2^-11, and
// strata add up the error. Next terms: angle^8/40320 and angle^9/362880, below rounding.
LIB Real2 turnBy(Real angle) {
  Real x = angle * angle;
  return abs(angle) < R(0.25) ? Real2(R(1.0) - x / R(2.0) * (R(1.0) - x / R(12.0) * (R(1.0) - x / R(30.0))),
                                      angle * (R(1.0) - x / R(6.0) * (R(1.0) - x / R(20.0) * (R(1.0) - x / R(42.0)))))
                              : Real2(cos(angle), sin(angle));
}

// Sum of two angles, both as (cosine, sine).
LIB Real2 turned(Real2 a, Real2 by) { return Real2(a.x * by.x - a.y * by.y, a.y * by.x + a.x * by.y); }
