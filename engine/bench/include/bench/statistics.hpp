// Medians with their spread.
#pragma once

#include <cstdint>
#include <vector>

namespace tyndall::bench {

/// Median and quartiles (linear between ranks) of `count` measurements; all 0 where there are none.
struct Spread {
  double median = 0, low = 0, high = 0;
  std::uint32_t count = 0;
};
Spread spreadOf(std::vector<double> values);

}  // namespace tyndall::bench
