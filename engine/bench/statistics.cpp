#include "bench/statistics.hpp"

#include <algorithm>
#include <cmath>

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

}  // namespace tyndall::bench
