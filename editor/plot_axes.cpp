#include "plot_axes.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>

namespace tyndall::editor {

std::vector<LogAxis::Tick> LogAxis::ticks() const {
  std::vector<Tick> list;
  const int first = static_cast<int>(std::floor(std::log10(low))), last = static_cast<int>(std::ceil(std::log10(high)));
  for (int power = first; power <= last; ++power)
    for (int times = 1; times <= 9; ++times) {
      const double value = times * std::pow(10.0, power);
      // A rounding error must not lose the tick on the axis's end.
      if (value >= low * (1 - 1e-9) && value <= high * (1 + 1e-9)) list.push_back({value, times == 1});
    }
  return list;
}

LogAxis axisFor(const std::vector<double>& values) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const double value : values)
    if (value > 0 && std::isfinite(value)) least = std::min(least, value), most = std::max(most, value);
  if (most <= 0) return {};
  LogAxis axis{least / 1.4, most * 1.4};
  if (const double lack = 4 / (axis.high / axis.low); lack > 1)
    axis.low /= std::sqrt(lack), axis.high *= std::sqrt(lack);
  return axis;
}

std::string tickText(double value) {
  char text[32];
  std::snprintf(text, sizeof text, value >= 1000 && value < 1e6 ? "%.0f" : "%.3g", value);
  return text;
}

std::vector<std::size_t> paretoFront(const std::vector<PlotPoint>& points) {
  std::vector<std::size_t> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points[a].milliseconds != points[b].milliseconds ? points[a].milliseconds < points[b].milliseconds
                                                            : points[a].error < points[b].error;
  });
  std::vector<std::size_t> front;
  for (const std::size_t i : order)
    if (front.empty() || points[i].error < points[front.back()].error) front.push_back(i);
  return front;
}

}  // namespace tyndall::editor
