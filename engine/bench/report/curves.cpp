#include "bench/curves.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tyndall::bench {
namespace {

/// Straight line through (x0, y0) and (x1, y1) in logarithms.
double interpolate(double x0, double y0, double x1, double y1, double x) {
  if (x == x0) return y0;
  if (x == x1) return y1;
  const double t = std::log(x / x0) / std::log(x1 / x0);
  return std::exp(std::log(y0) + t * std::log(y1 / y0));
}

/// `curve` has falling errors.
std::optional<double> costOnCurve(std::span<const CostError> curve, double error) {
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (curve[i].error == error) return curve[i].cost;
    if (i > 0 && curve[i].error < error && error < curve[i - 1].error)
      return interpolate(curve[i - 1].error, curve[i - 1].cost, curve[i].error, curve[i].cost, error);
  }
  return std::nullopt;
}

Stretch::Cheaper cheaperAt(double logRatio, double logEqual) {
  if (logRatio > logEqual) return Stretch::Cheaper::kFirst;
  if (logRatio < -logEqual) return Stretch::Cheaper::kSecond;
  return Stretch::Cheaper::kEqual;
}

void append(std::vector<Stretch>& stretches, Stretch::Cheaper cheaper, double from, double to, double r0, double r1) {
  const double least = std::min(r0, r1), greatest = std::max(r0, r1);
  if (!stretches.empty() && stretches.back().cheaper == cheaper) {
    Stretch& last = stretches.back();
    last.to = to;
    last.leastRatio = std::min(last.leastRatio, least);
    last.greatestRatio = std::max(last.greatestRatio, greatest);
  } else {
    stretches.push_back({cheaper, from, to, least, greatest});
  }
}

}  // namespace

std::vector<std::size_t> paretoFront(std::span<const CostError> points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order,
                [&](std::size_t i) { return !std::isfinite(points[i].cost) || !std::isfinite(points[i].error); });
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points[a].cost != points[b].cost ? points[a].cost < points[b].cost : points[a].error < points[b].error;
  });
  std::vector<std::size_t> front;
  for (const std::size_t i : order)
    if (front.empty() || points[i].error < points[front.back()].error) front.push_back(i);
  return front;
}

std::vector<CostError> frontCurve(std::span<const CostError> points) {
  std::vector<CostError> positive;
  for (const CostError& p : points)
    if (p.cost > 0 && p.error > 0) positive.push_back(p);
  std::vector<CostError> curve;
  for (const std::size_t i : paretoFront(positive)) curve.push_back(positive[i]);
  return curve;
}

std::optional<double> costAtError(std::span<const CostError> points, double error) {
  return costOnCurve(frontCurve(points), error);
}

std::optional<double> errorAtCost(std::span<const CostError> points, double cost) {
  // The front falls in both directions, so that cost and error can change places.
  std::vector<CostError> swapped;
  for (const CostError& p : points) swapped.push_back({p.error, p.cost});
  return costOnCurve(frontCurve(swapped), cost);
}

std::vector<Stretch> compareAtEqualError(std::span<const CostError> first, std::span<const CostError> second,
                                         double equal) {
  const auto a = frontCurve(first), b = frontCurve(second);
  if (a.empty() || b.empty()) return {};
  const double lowest = std::max(a.back().error, b.back().error);
  const double highest = std::min(a.front().error, b.front().error);
  if (lowest > highest) return {};

  std::vector<double> errors = {lowest, highest};
  for (const auto* curve : {&a, &b})
    for (const CostError& p : *curve)
      if (p.error > lowest && p.error < highest) errors.push_back(p.error);
  std::sort(errors.begin(), errors.end());
  errors.erase(std::unique(errors.begin(), errors.end()), errors.end());

  const double logEqual = std::log(std::max(1.0, equal));
  const auto logRatio = [&](double error) { return std::log(*costOnCurve(b, error) / *costOnCurve(a, error)); };
  std::vector<Stretch> stretches;
  if (errors.size() == 1) {
    const double r = logRatio(lowest);
    append(stretches, cheaperAt(r, logEqual), lowest, lowest, std::exp(r), std::exp(r));
    return stretches;
  }
  for (std::size_t i = 1; i < errors.size(); ++i) {
    // In logarithms the ratio is a straight line between two errors: it is cut where it passes the noise's limits.
    const double e0 = errors[i - 1], e1 = errors[i], r0 = logRatio(e0), r1 = logRatio(e1);
    std::vector<double> cuts = {0, 1};
    for (const double limit : {-logEqual, logEqual})
      if ((r0 - limit) * (r1 - limit) < 0) cuts.push_back((limit - r0) / (r1 - r0));
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t c = 1; c < cuts.size(); ++c) {
      if (cuts[c] <= cuts[c - 1]) continue;
      const auto errorAt = [&](double t) {
        return t == 0 ? e0 : t == 1 ? e1 : std::exp(std::lerp(std::log(e0), std::log(e1), t));
      };
      const auto ratioAt = [&](double t) { return std::exp(std::lerp(r0, r1, t)); };
      const double middle = std::lerp(r0, r1, 0.5 * (cuts[c - 1] + cuts[c]));
      append(stretches, cheaperAt(middle, logEqual), errorAt(cuts[c - 1]), errorAt(cuts[c]), ratioAt(cuts[c - 1]),
             ratioAt(cuts[c]));
    }
  }
  return stretches;
}

}  // namespace tyndall::bench
