// Medians with their spread, and what they say of a value that was not measured.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace tyndall::bench {

/// Median and quartiles (linear between ranks) of `count` measurements; all 0 where there are none.
struct Spread {
  double median = 0, low = 0, high = 0;
  std::uint32_t count = 0;
};
Spread spreadOf(std::vector<double> values);

/// What one more value of the same kind stays under in 19 of 20 cases, if logarithms of the values are spread normally:
/// the one-sided prediction limit exp(m + t s sqrt(1 + 1/n)), m and s mean and standard deviation of the logarithms, t
/// Student's quantile of 95 % for n - 1 degrees of freedom. None for fewer than three values, of which it would say
/// nothing of use, or where one is not above 0.
std::optional<double> predictionLimit(const std::vector<double>& values);

}  // namespace tyndall::bench
