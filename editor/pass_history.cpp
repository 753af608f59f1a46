#include "pass_history.hpp"

#include <algorithm>

namespace tyndall::editor {
namespace {

/// `values`: of the frames that had it, oldest first.
PassHistory::Line lineOf(std::string name, std::string owner, std::vector<double> values, bool ran) {
  PassHistory::Line line{std::move(name), std::move(owner), 0, 0, 0, ran};
  if (values.empty()) return line;
  if (ran) line.current = values.back();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  line.median = *middle;
  if (values.size() % 2 == 0) line.median = (line.median + *std::max_element(values.begin(), middle)) / 2;
  line.worst = *std::max_element(values.begin(), values.end());
  return line;
}

}  // namespace

void PassHistory::add(const std::vector<render::PassTime>& passes) {
  Frame frame;
  std::vector<Key> order;
  for (const render::PassTime& pass : passes) {
    if (pass.owner == "editor" || pass.owner == "readback") continue;
    const Key key{pass.owner, pass.name};
    if (!frame.contains(key)) order.push_back(key);
    frame[key] += pass.milliseconds;
  }
  frames_.push_back(std::move(frame));
  if (frames_.size() > kFrames) frames_.pop_front();
  // The newest frame's order first, then what only older frames had; what left the window is forgotten.
  for (const Key& key : order_) {
    const bool known = std::find(order.begin(), order.end(), key) != order.end();
    const bool seen = std::any_of(frames_.begin(), frames_.end(), [&](const Frame& f) { return f.contains(key); });
    if (!known && seen) order.push_back(key);
  }
  order_ = std::move(order);
}

std::vector<PassHistory::Line> PassHistory::lines() const {
  std::vector<Line> lines;
  for (const Key& key : order_) {
    std::vector<double> values;
    for (const Frame& frame : frames_)
      if (const auto found = frame.find(key); found != frame.end()) values.push_back(found->second);
    lines.push_back(lineOf(key.second, key.first, std::move(values), frames_.back().contains(key)));
  }
  return lines;
}

PassHistory::Line PassHistory::total() const {
  std::vector<double> values;
  for (const Frame& frame : frames_) {
    double sum = 0;
    for (const auto& [key, milliseconds] : frame) sum += milliseconds;
    values.push_back(sum);
  }
  const bool any = !values.empty();
  return lineOf("total", "", std::move(values), any);
}

std::vector<PassHistory::Line> PassHistory::owners() const {
  std::vector<std::string> names;
  for (const Key& key : order_)
    if (std::find(names.begin(), names.end(), key.first) == names.end()) names.push_back(key.first);
  std::vector<Line> lines;
  for (const std::string& name : names) {
    std::vector<double> values;
    bool ran = false;
    for (const Frame& frame : frames_) {
      double sum = 0;
      ran = false;
      for (const auto& [key, milliseconds] : frame)
        if (key.first == name) sum += milliseconds, ran = true;
      if (ran) values.push_back(sum);
    }
    lines.push_back(lineOf("  of it", name, std::move(values), ran));
  }
  return lines;
}

}  // namespace tyndall::editor
