#include "bench/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace tyndall::bench {

Spread spreadOf(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    const double rank = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(rank);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return std::lerp(values[below], values[above], rank - static_cast<double>(below));
  };
  return {at(0.5), at(0.25), at(0.75), static_cast<std::uint32_t>(values.size())};
}

namespace {

/// Student's quantile of 95 % (one side), for degrees of freedom from 2 on; beyond the table by the first term of its
/// expansion in their inverse.
double quantile95(std::size_t freedom) {
  constexpr double kTable[] = {2.920, 2.353, 2.132, 2.015, 1.943, 1.895, 1.860, 1.833, 1.812, 1.796,
                               1.782, 1.771, 1.761, 1.753, 1.746, 1.740, 1.734, 1.729, 1.725};
  if (freedom < 2 + std::size(kTable)) return kTable[freedom - 2];
  constexpr double kNormal = 1.6449;
  return kNormal + kNormal * (kNormal * kNormal + 1) / (4 * static_cast<double>(freedom));
}

}  // namespace

std::optional<double> predictionLimit(const std::vector<double>& values) {
  if (values.size() < 3) return std::nullopt;
  const auto count = static_cast<double>(values.size());
  double mean = 0, squares = 0;
  for (const double value : values) {
    if (!(value > 0)) return std::nullopt;
    mean += std::log(value) / count;
  }
  for (const double value : values) squares += std::pow(std::log(value) - mean, 2);
  return std::exp(mean + quantile95(values.size() - 1) * std::sqrt(squares / (count - 1) * (1 + 1 / count)));
}

}  // namespace tyndall::bench
