// The maths of the plot of error against time: logarithmic axes and the front of the best.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace tyndall::editor {

/// A logarithmic axis over [low, high], both above 0.
struct LogAxis {
  double low = 1, high = 10;

  /// 0 at low, 1 at high.
  double share(double value) const { return std::log(value / low) / std::log(high / low); }
  double valueAt(double share) const { return low * std::pow(high / low, share); }

  struct Tick {
    double value;
    bool major;  ///< a power of ten
  };
  /// 1 to 9 times every power of ten on the axis, rising.
  std::vector<Tick> ticks() const;
};
/// An axis that holds all values with some room at both ends, and at least a factor of four. Values that are not above
/// 0 are left out.
LogAxis axisFor(const std::vector<double>& values);
/// "0.01", "3", "100": as few digits as tell it.
std::string tickText(double value);

struct PlotPoint {
  double milliseconds = 0, error = 0;
};
/// Indices of the points that no other beats in time and error both, in order of time.
std::vector<std::size_t> paretoFront(const std::vector<PlotPoint>& points);

}  // namespace tyndall::editor
