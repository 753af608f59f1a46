// Measures the points of a sweep on one view after another.
#pragma once

#include <functional>

#include "bench/stand.hpp"

namespace tyndall::bench {

/// Says what is going on; false: stop as soon as may be.
struct Watcher {
  std::function<bool(const std::string& what, std::size_t done, std::size_t all)> tell;
};

/// Measures the points of `planned` that `results` has not, and adds them and the view's figures. Times come from
/// rounds: every point once a round, a discarded frame before each timed one, so that a drift of the machine meets all
/// alike. Errors are taken at the sweep's error_size against the truth and against the march. A point whose settings a
/// device cannot run is added with the reason. Returns false if the watcher stopped it: then nothing of this view is
/// added.
Result<bool> measureView(Stand& stand, const Sweep& sweep, const app::Level& level, std::uint32_t camera,
                         const std::vector<PlannedPoint>& planned, Results& results, const Watcher& watcher);

}  // namespace tyndall::bench
