#include "medium_cases.hpp"

#include <algorithm>

namespace tyndall::stability {
namespace {

using Long = long double;

/// Below the smallest normal float results may be flushed to zero, and relative errors say nothing.
constexpr Long kSmallest = 1e-36L;

double relative(Long got, Long truth) {
  return static_cast<double>(std::abs(got - truth) / std::max(std::abs(truth), kSmallest));
}
double apart(Long got, Long truth) { return static_cast<double>(std::abs(got - truth)); }

double clippedError(const MediumCase& c, const std::array<float, 2>& got) {
  const Long first = c.in[0], last = c.in[1], along = c.in[2], h = c.in[3];
  // Clip by hand: t along <= h.
  const bool empty = got[1] < got[0];
  if (std::abs(along) < 1e-12L) return empty == (h < 0) ? 0 : 1;
  const Long t = h / along;
  const Long from = along > 0 ? first : std::max(first, t), to = along > 0 ? std::min(last, t) : last;
  return std::max(relative(got[0], from), relative(got[1], to));
}

double arcError(const MediumCase& c, const std::array<float, 2>& got) {
  // The arc in which A cos + B sin >= 0, by testing its ends: each inner end is a zero, and the middle lies inside.
  const Long A = c.in[0], B = c.in[1], low = c.in[2], high = c.in[3], size = std::hypot(A, B);
  const auto value = [&](Long theta) { return (A * std::cos(theta) + B * std::sin(theta)) / size; };
  double worst = 0;
  if (got[0] > got[1]) {  // empty: nothing inside
    for (Long s = 0; s <= 1; s += 0.125L) worst = std::max(worst, static_cast<double>(value(low + s * (high - low))));
    return worst;
  }
  const Long first = got[0], last = got[1];
  if (first > low) worst = std::max(worst, static_cast<double>(std::abs(value(first))));
  if (last < high) worst = std::max(worst, static_cast<double>(std::abs(value(last))));
  for (Long s = 0; s <= 1; s += 0.125L) {
    const Long theta = low + s * (high - low);
    const Long v = theta >= first && theta <= last ? -value(theta) : value(theta);  // positive: wrong side
    worst = std::max(worst, static_cast<double>(v));
  }
  return worst;
}

}  // namespace

double errorOf(const MediumCase& c, const std::array<float, 2>& got) {
  const Long a = c.in[0], b = c.in[1], d = c.in[2];
  switch (c.routine) {
    case Routine::kOneMinusExp: return relative(got[0], -std::expm1(-a));
    case Routine::kTransmittanceIntegral: {
      const Long truth = (a == 0 ? d - b : -std::expm1(-a * (d - b)) / a) * std::exp(-a * b);
      return truth < kSmallest ? apart(got[0], truth) : relative(got[0], truth) / static_cast<double>(1 + a * d);
    }
    case Routine::kDistanceAtShare: {
      const Long t = got[0];
      if (!(t >= 0 && t <= b)) return 1;
      const Long share = a == 0 ? t / b : std::expm1(-a * t) / std::expm1(-a * b);
      return apart(share, d);
    }
    case Routine::kRunningWeight: {
      const Long truth = b == 0 ? 1 / (a + 1) : std::exp(-a * b) * std::expm1(-b) / std::expm1(-(a + 1) * b);
      return truth < kSmallest ? apart(got[0], truth) : relative(got[0], truth) / static_cast<double>(1 + a * b);
    }
    case Routine::kPhase: {
      const Long s = 1 + b * b - 2 * b * a;
      return relative(got[0], (1 - b * b) / (4 * std::acos(-1.0L) * s * std::sqrt(s)));
    }
    case Routine::kInclination: return apart(got[0], std::atan2(a, b));
    case Routine::kNormalisedInclination:
      return apart(got[0], std::clamp((a - b) / (d - b), Long(0), Long(1))) * static_cast<double>(d - b);
    case Routine::kLagrangeSum: return apart(got[0], 1);
    case Routine::kClipToHalfPlane: return clippedError(c, got);
    default: return arcError(c, got);
  }
}

}  // namespace tyndall::stability
