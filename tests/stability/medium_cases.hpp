// Routines of lib/medium.glsl and lib/epipolar.glsl with inputs that reach their extremes, and what they should give,
// in long double and by closed forms other than the routines' own. Shared by the CPU's and the device's stress tests.
#pragma once

#include <array>
#include <cmath>

#include "lib/cpp.hpp"
#include "random.hpp"

namespace tyndall::stability {

enum class Routine {
  kOneMinusExp,
  kTransmittanceIntegral,
  kDistanceAtShare,
  kRunningWeight,
  kPhase,
  kInclination,
  kNormalisedInclination,
  kLagrangeSum,
  kClipToHalfPlane,
  kClipToFrustumPlane,
  kCount
};

struct MediumCase {
  Routine routine;
  std::array<float, 4> in{};
};

struct RoutineRow {
  const char* name;
  double allowed;  ///< as tight as measured, with the reason beside it
};
/// `error` below is relative where a routine's values span decades; of a distance at a share it is the miss of the
/// share.
inline constexpr std::array<RoutineRow, static_cast<std::size_t>(Routine::kCount)> kRoutines = {{
    {"oneMinusExp, relative", 1e-6},  // 1 - e^-x just above x = 0.05 cancels to 20 half ulps
    {"transmittanceIntegral, relative / (1 + depth)",
     1.5e-6},  // the same, and the argument of exp rounds with the depth
    {"distanceAtTransmittanceShare, missed share",
     6e-5},  // above x = 1e-3 the log of a number rounded next to 1: 6e-8 / x
    {"runningWeight, relative / (1 + depth)", 1.5e-6},
    {"phaseHenyeyGreenstein, relative", 1e-6},
    {"inclination, radians", 5e-7},
    {"normalisedInclination * range", 1e-6},
    {"chebyshevLagrange, sum of 1 to 6 weights - 1", 4e-6},  // weights up to 1 on [-1, 1], six of five factors each
    {"clipToHalfPlane, relative", 3e-7},
    {"clipToFrustumPlane, radians", 1e-6},
}};

inline MediumCase makeMediumCase(Random& random, Routine routine) {
  const auto f = [](double x) { return static_cast<float>(x); };
  // Zero, tiny, usual and huge.
  const auto wide = [&](double low, double high) { return random.next() < 0.05 ? 0.0 : random.decades(low, high); };
  MediumCase c{routine};
  switch (routine) {
    case Routine::kOneMinusExp: c.in = {f(wide(1e-30, 1e4))}; break;
    case Routine::kTransmittanceIntegral: {
      const double a = wide(1e-6, 1e5);
      c.in = {f(wide(1e-12, 1e3)), f(a), f(a + wide(1e-6, 1e5))};
      break;
    }
    case Routine::kDistanceAtShare:
      c.in = {f(wide(1e-12, 1e2)), f(random.decades(1e-3, 1e5)),
              f(random.next() < 0.05 ? std::round(random.next()) : random.next())};
      break;
    case Routine::kRunningWeight: c.in = {f(std::floor(wide(1, 4096))), f(wide(1e-12, 1e4))}; break;
    case Routine::kPhase: {
      // Everywhere, and towards both ends: the narrower the lobe, the more what lies near its middle counts.
      const auto towardsOne = [&](double least) {
        return (random.next() < 0.5 ? -1 : 1) * (1 - random.decades(least, 1));
      };
      const bool ends = random.next() < 0.5;
      c.in = {f(ends ? towardsOne(1e-9) : random.between(-1, 1)),
              f(ends ? towardsOne(1e-3) : random.between(-0.999, 0.999))};
      break;
    }
    case Routine::kInclination:
      c.in = {f(wide(1e-12, 1e6)), f((random.next() < 0.5 ? -1 : 1) * random.decades(1e-12, 1e6))};
      break;
    case Routine::kNormalisedInclination: {
      const double low = random.between(0, 3.1);
      c.in = {f(random.between(-0.1, 3.2)), f(low), f(low + random.decades(1e-4, 3))};
      break;
    }
    case Routine::kLagrangeSum:
      c.in = {f(1 + random.below(6)),
              f(random.next() < 0.1 ? std::round(random.between(-1, 1)) : random.between(-1, 1))};
      break;
    case Routine::kClipToHalfPlane:
      c.in = {f(random.between(0, 5)), f(random.between(5, 100)), f((random.next() < 0.5 ? -1 : 1) * wide(1e-20, 1)),
              f(random.between(-10, 10))};
      break;
    default: {
      const double angle = random.between(-3.14159, 3.14159), size = random.decades(1e-6, 1);
      c.in = {f(size * std::cos(angle)), f(size * std::sin(angle)), f(random.between(0, 1.5)),
              f(random.between(1.6, 3.14159))};
    }
  }
  return c;
}

/// The routine in numbers of type Real; the device's shader returns the same.
template <class Real>
std::array<Real, 2> evaluate(const MediumCase& c) {
  using namespace lib::f32;
  using namespace lib::f64;
  using namespace lib::f80;
  const Real a = c.in[0], b = c.in[1], d = c.in[2], e = c.in[3];
  switch (c.routine) {
    case Routine::kOneMinusExp: return {oneMinusExp(a)};
    case Routine::kTransmittanceIntegral: return {transmittanceIntegral(a, b, d)};
    case Routine::kDistanceAtShare: return {distanceAtTransmittanceShare(a, b, d)};
    case Routine::kRunningWeight: return {runningWeight(a, b)};
    case Routine::kPhase: return {phaseHenyeyGreenstein(a, b)};
    case Routine::kInclination: return {inclination(a, b)};
    case Routine::kNormalisedInclination: return {normalisedInclination(a, b, d)};
    case Routine::kLagrangeSum: {
      Real sum = 0;
      for (int k = 0; k < static_cast<int>(a); ++k) sum += chebyshevLagrange(k, static_cast<int>(a), b);
      return {sum};
    }
    case Routine::kClipToHalfPlane: {
      const auto clipped = clipToHalfPlane(glm::vec<2, Real>(a, b), d, e);
      return {clipped.x, clipped.y};
    }
    default: {
      const auto clipped = clipToFrustumPlane(glm::vec<2, Real>(d, e), a, b);
      return {clipped.x, clipped.y};
    }
  }
}

/// How far `got` is from the truth, in the measure of kRoutines.
double errorOf(const MediumCase& c, const std::array<float, 2>& got);

}  // namespace tyndall::stability
