#include "axis.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/assert.hpp"
#include "text.hpp"

namespace tyndall::bench::report {
namespace {

/// A tick's label: as few digits as tell it from its neighbours, at most 6.
std::string tickLabel(double value) {
  if (std::abs(value) >= 1000 && std::abs(value) < 1e7 && value == std::round(value)) return whole(value);
  for (int digits = 1; digits < 6; ++digits) {
    const double scale = std::pow(10.0, digits - 1 - std::floor(std::log10(std::abs(value))));
    if (value == 0 || std::abs(std::round(value * scale) / scale - value) <= 1e-9 * std::abs(value))
      return figure(value, digits);
  }
  return figure(value, 6);
}

}  // namespace

bool showable(Scale scale, double value) { return std::isfinite(value) && (scale != Scale::kLog || value > 0); }

AxisMap::AxisMap(const Axis& axis, const std::vector<double>& values, double begin, double end)
    : axis_(axis), begin_(begin), end_(end) {
  std::vector<double> data;
  for (const double v : values)
    if (showable(axis.scale, v)) data.push_back(v);
  if (axis_.scale == Scale::kCategory) {
    low_ = -0.5;
    high_ = static_cast<double>(axis_.categories.size()) - 0.5;
    for (std::size_t i = 0; i < axis_.categories.size(); ++i)
      ticks_.push_back({static_cast<double>(i), pixel(static_cast<double>(i)), axis_.categories[i]});
    return;
  }
  TY_ASSERT(!data.empty(), "axis \"" + axis.label + "\" has no data");
  const auto [least, greatest] = std::minmax_element(data.begin(), data.end());
  low_ = position(*least);
  high_ = position(*greatest);
  if (axis_.scale == Scale::kLinear && axis_.fromZero) low_ = std::min(low_, 0.0);
  // Room around the data; at least a factor of two each way where all values are nearly one.
  const bool log = axis_.scale == Scale::kLog;
  const double least_span = log ? 0.3 : 1e-3 * std::max(1.0, std::abs(high_));
  if (high_ - low_ < least_span) {
    const double middle = 0.5 * (low_ + high_), half = log ? 0.301 : std::max(0.5, 0.5 * std::abs(middle));
    low_ = axis_.fromZero ? low_ : middle - half;
    high_ = middle + half;
  }
  const double room = 0.06 * (high_ - low_);
  if (!axis_.fromZero || low_ < 0) low_ -= room;
  high_ += room;
  if (axis_.ticksAtData && ticksAt(data)) return;
  if (log)
    logTicks();
  else
    linearTicks();
}

double AxisMap::position(double value) const { return axis_.scale == Scale::kLog ? std::log10(value) : value; }

double AxisMap::pixel(double value) const {
  return begin_ + (end_ - begin_) * (position(value) - low_) / (high_ - low_);
}

/// False where the labels of ticks at the data's own values would run into each other.
bool AxisMap::ticksAt(const std::vector<double>& data) {
  std::vector<Tick> ticks;
  double end = 0;  // of the last label
  for (const double v : std::set<double>(data.begin(), data.end())) {
    const auto name = axis_.names.find(v);
    const std::string label = name == axis_.names.end() ? tickLabel(v) : name->second;
    const double half = 0.5 * std::max(18.0, 6.2 * static_cast<double>(label.size())), at = std::abs(pixel(v) - begin_);
    if (!ticks.empty() && at - half < end + 4) return false;
    end = at + half;
    ticks.push_back({v, pixel(v), label});
  }
  ticks_ = ticks;
  return true;
}

/// Lines at 1 … 9 of each decade. Labels at 1, at 1-2-5 or at 1-2-3-5-7, whichever is the first to give three.
void AxisMap::logTicks() {
  const int first = static_cast<int>(std::floor(low_)), last = static_cast<int>(std::floor(high_));
  const int decades = last - first + 1;
  const int step = std::max(1, static_cast<int>(std::ceil(decades / 8.0)));  // every n-th decade on very long axes
  const std::vector<std::set<int>> sets = {{1}, {1, 2, 5}, {1, 2, 3, 5, 7}, {1, 2, 3, 4, 5, 6, 7, 8, 9}};
  for (const auto& labelled : sets) {
    ticks_.clear();
    int labels = 0;
    for (int decade = first; decade <= last; ++decade)
      for (int m = 1; m <= 9; ++m) {
        const double value = m * std::pow(10.0, decade);
        const double p = std::log10(value);
        if (p < low_ - 1e-12 || p > high_ + 1e-12 || (step > 1 && m > 1)) continue;
        const bool label = labelled.count(m) && (decade - first) % step == 0;
        labels += label;
        ticks_.push_back({value, pixel(value), label ? tickLabel(value) : ""});
      }
    if (labels >= 3 && !(labels == 3 && labelled.size() == 1 && decades < 4)) return;
  }
}

void AxisMap::linearTicks() {
  const double rough = (high_ - low_) / 6, power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double m : {1.0, 2.0, 5.0})
    if (m * power >= rough) {
      step = m * power;
      break;
    }
  for (double i = std::ceil(low_ / step); i * step <= high_; ++i)
    ticks_.push_back({i * step, pixel(i * step), tickLabel(i * step)});
}

}  // namespace tyndall::bench::report
