// GPU times of the passes over the last frames. Knows neither window nor device.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "render/frame.hpp"
#include "render/graph.hpp"

namespace tyndall::editor {

class PassHistory {
 public:
  static constexpr std::size_t kFrames = 120;  ///< the window: two seconds at 60 frames a second

  struct Line {
    std::string name, owner;
    double current = 0, median = 0,
           worst = 0;  ///< ms; median and worst over the frames of the window that had the pass
    bool ran = false;  ///< in the newest frame
  };
  using Key = std::pair<std::string, std::string>;  ///< owner, name
  using Frame = std::map<Key, double>;              ///< ms

  /// A finished frame. Passes of the editor's own and copies to the host do not count.
  void add(const std::vector<render::PassTime>& passes);
  void clear() { frames_.clear(), order_.clear(); }

  /// In the order that the passes ran, each that ran in the window.
  std::vector<Line> lines() const;
  Line total() const;
  /// Sums by owner, in the order of their first pass.
  std::vector<Line> owners() const;
  const std::deque<Frame>& frames() const { return frames_; }
  const std::vector<Key>& order() const { return order_; }

 private:
  std::deque<Frame> frames_;
  std::vector<Key> order_;
};

}  // namespace tyndall::editor
