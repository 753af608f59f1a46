// Whether memory grows, from readings that go up and down.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace tyndall::editor {

struct MemoryGrowth {
  double before = 0, after = 0;  ///< in the readings' unit
  double grown() const { return after - before; }
};

/// The medians of a tenth of the readings: of those after the first fifth, which is the warm-up, and of the last ones.
/// Which pipelines and which levels' remains a reading meets is chance, so that two single ones tell little. At least
/// two readings.
inline MemoryGrowth growthOf(const std::vector<double>& readings) {
  const std::size_t count = readings.size(), part = std::max<std::size_t>(1, count / 10);
  const std::size_t first = std::min(count > part ? count - part - 1 : 0, std::max<std::size_t>(1, count / 5));
  const auto median = [&](std::size_t from) {
    std::vector<double> some(readings.begin() + static_cast<std::ptrdiff_t>(from),
                             readings.begin() + static_cast<std::ptrdiff_t>(from + part));
    std::nth_element(some.begin(), some.begin() + static_cast<std::ptrdiff_t>(part / 2), some.end());
    return some[part / 2];
  };
  return {median(first), median(count - part)};
}

}  // namespace tyndall::editor
