// Rows of a spot or point light (the frame of lib/epipolar.glsl with the light at a finite distance D from the eye): theta is the
// inclination of a view ray at the eye, psi that of a light ray at the light, both from the line between them; a point of the view ray at
// distance t has psi = atan(t sin(theta), D - t cos(theta)), which grows along it from 0 to pi - theta. With dt/d^2 = dpsi/(D sin(theta)),
// in-scattering is sigma_s I/(D sin(theta)) times an integral over psi without the peak of the inverse square. Angles in radians.
// Include lib/portable.h and lib/medium.glsl first.

// The angle at the light of a point at distance t along a view ray, t and D in metres.
LIB Real angleAtLight(Real sine, Real cosine, Real t, Real D) { return atan(t * sine, D - t * cosine); }

// Length of the way from the eye to the point and on to the light, over D: (sin(theta) + sin(psi))/sin(theta + psi). It grows without
// bound towards psi = pi - theta; from there on, where no point is, it stays at 10^4.
LIB Real wayOverDistance(Real theta, Real psi) {
  Real half_ = cos(R(0.5) * (theta + psi));
  return half_ < R(1e-4) ? R(1e4) : min(cos(R(0.5) * (theta - psi)) / half_, R(1e4));
}

// What a light ray adds to a view ray per radian of psi, but for its own strength: phase function, transmittance of the whole way and the
// range's window (KHR_lights_punctual; range over D, 0: unlimited). The optical depth of the way is cut at `most`, and the window at `least`:
// for a view ray itself they are 1e9 and 0; a reference ray, which stands for others that see columns that it does not, keeps some weight there.
LIB Real localWeight(Real theta, Real psi, Real sigmaD, Real g, Real rangeOverD, Real most, Real least) {
  Real sum = theta + psi;
  Real window = R(1.0);
  if (rangeOverD > R(0.0)) {
    Real sine = sin(sum);
    Real q = sine > R(1e-4) && sum < R(3.14159265) ? sin(theta) / (sine * rangeOverD) : R(1e4);
    q = q * q;
    window = max(R(1.0) - q * q, least);
  }
  return phaseHenyeyGreenstein(cos(sum), g) * exp(-min(sigmaD * wayOverDistance(theta, psi), most)) * window;
}

// The interval of psi in [0, pi] in which a light ray of a slice is inside a cone about the light's axis, whose outer half angle has this
// cosine and sine: with the ray -a cos(psi) + e sin(psi), `along` = -(a.axis), `across` = e.axis, and `beside` the axis's part at right angles
// to the slice. Empty where x > y. With l^2 = along^2 + across^2 = 1 - beside^2, half of it is acos(cos/l), whose tangent is written without a
// difference of numbers near one.
LIB Real2 coneAngles(Real along, Real across, Real beside, Real cosOuter, Real sinOuter) {
  const Real pi = R(3.14159265358979324);
  Real inside = sinOuter * sinOuter - beside * beside;
  if (inside <= R(0.0)) return Real2(R(1.0), R(0.0));
  Real middle = atan(across, along);
  Real half_ = atan(sqrt(inside), cosOuter);
  // An interval shorter than pi; below 0 it may come in again at pi.
  if (middle + half_ < R(0.0)) middle += R(2.0) * pi;
  return Real2(max(middle - half_, R(0.0)), min(middle + half_, pi));
}
