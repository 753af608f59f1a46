// From data to pixels: scale, range, ticks.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace tyndall::bench::report {

enum class Scale { kLinear, kLog, kCategory };

struct Axis {
  std::string label;
  Scale scale = Scale::kLinear;
  bool fromZero = false;                ///< linear only: the axis begins at 0 (bars)
  std::vector<std::string> categories;  ///< kCategory: values are 0, 1, …
  bool ticksAtData = false;             ///< a tick at each value (a knob with a few settings) instead of round ones
  std::map<double, std::string> names;  ///< labels of such ticks, where not the value itself
};

struct Tick {
  double value = 0, pixel = 0;
  std::string label;  ///< empty: a minor line
};

/// An axis with its data's range, laid over the pixels [begin, end] (end < begin for an axis that points up).
class AxisMap {
 public:
  AxisMap(const Axis& axis, const std::vector<double>& values, double begin, double end);
  double pixel(double value) const;
  const std::vector<Tick>& ticks() const { return ticks_; }

 private:
  double position(double value) const;  ///< value, or its logarithm
  void logTicks();
  void linearTicks();
  bool ticksAt(const std::vector<double>& data);

  Axis axis_;
  double low_ = 0, high_ = 1, begin_, end_;
  std::vector<Tick> ticks_;
};

/// A value that the scale can show: finite, and positive on a logarithmic axis.
bool showable(Scale scale, double value);

}  // namespace tyndall::bench::report
