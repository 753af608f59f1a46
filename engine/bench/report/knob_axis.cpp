#include "knob_axis.hpp"

#include <algorithm>
#include <set>

namespace tyndall::bench::report {

KnobAxis::KnobAxis(const std::string& label, const Points& points) {
  std::set<double> numbers;
  bool numeric = true;
  for (const Point* p : points) {
    if (!p->knob) continue;
    numeric = numeric && p->knob->value.number;
    if (p->knob->value.number) numbers.insert(*p->knob->value.number);
    if (std::find(axis_.categories.begin(), axis_.categories.end(), p->knob->value.text) == axis_.categories.end())
      axis_.categories.push_back(p->knob->value.text);
  }
  axis_.label = label;
  values_ = axis_.categories.size();
  if (!numeric || numbers.empty()) {
    if (axis_.categories == std::vector<std::string>{"true", "false"}) axis_.categories = {"false", "true"};
    axis_.scale = Scale::kCategory;
    return;
  }
  // Steps, map sizes and the like are varied by factors: a range of 8 or more wants logarithms.
  const double least = *numbers.begin(), greatest = *numbers.rbegin();
  axis_.scale = least > 0 && greatest >= 8 * least ? Scale::kLog : Scale::kLinear;
  axis_.ticksAtData = true;
  axis_.categories.clear();
}

Number KnobAxis::position(const Point& p) const {
  if (!p.knob) return {};
  if (axis_.scale != Scale::kCategory) return p.knob->value.number;
  const auto found = std::find(axis_.categories.begin(), axis_.categories.end(), p.knob->value.text);
  return static_cast<double>(found - axis_.categories.begin());
}

}  // namespace tyndall::bench::report
