// Closed forms of the homogeneous medium.
#pragma once

#include <cmath>
#include <numbers>

namespace tyndall::truth {

/// A part of a ray, metres from the eye, begin <= end.
struct Interval {
  double begin = 0;
  double end = 0;
  double length() const { return end - begin; }
};

/// Henyey and Greenstein 1941, "Diffuse radiation in the galaxy", normalised to 1 over the sphere (1/sr).
/// `cosine` is that of the angle between the directions in which light travels before and after scattering: it is 1 for
/// an eye that looks towards the light, and g > 0 makes that view bright. g in (-1, 1).
inline double phase(double g, double cosine) {
  const double base = 1 + g * g - 2 * g * cosine;
  return (1 - g * g) / (4 * std::numbers::pi * base * std::sqrt(base));
}

/// Below this optical depth transmittance is linear to double precision.
inline constexpr double kThin = 1e-12;

/// Integral of exp(-sigma_t t) dt over the interval, metres.
inline double transmittedLength(double sigma_t, Interval part) {
  const double depth = sigma_t * part.length();
  const double length = depth < kThin ? part.length() : -std::expm1(-depth) / sigma_t;
  return std::exp(-sigma_t * part.begin) * length;
}

/// The distance up to which a share u in [0, 1] of transmittedLength() over the interval is reached.
inline double distanceAtShare(double sigma_t, Interval part, double u) {
  const double depth = sigma_t * part.length();
  if (depth < kThin) return part.begin + u * part.length();
  return part.begin - std::log1p(u * std::expm1(-depth)) / sigma_t;
}

}  // namespace tyndall::truth
