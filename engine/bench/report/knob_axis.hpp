// An axis for a knob's values: numbers on a linear or logarithmic scale, anything else as categories.
#pragma once

#include <string>
#include <vector>

#include "axis.hpp"
#include "selection.hpp"

namespace tyndall::bench::report {

class KnobAxis {
 public:
  /// The values of `points`' knobs; those without a knob do not count.
  KnobAxis(const std::string& label, const Points& points);
  const Axis& axis() const { return axis_; }
  std::size_t values() const { return values_; }  ///< how many different ones
  Number position(const Point& p) const;

 private:
  Axis axis_;
  std::size_t values_ = 0;
};

}  // namespace tyndall::bench::report
