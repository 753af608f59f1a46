#include "app/median.hpp"

#include <algorithm>
#include <numeric>

#include "base/assert.hpp"

namespace tyndall::app {

double totalMs(const std::vector<render::PassTime>& passes) {
  double total = 0;
  for (const render::PassTime& pass : passes) total += pass.milliseconds;
  return total;
}

const std::vector<render::PassTime>& medianFrame(const std::vector<std::vector<render::PassTime>>& frames) {
  TY_ASSERT(!frames.empty(), "no frame was timed");
  std::vector<std::size_t> order(frames.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return totalMs(frames[a]) < totalMs(frames[b]); });
  return frames[order[(order.size() - 1) / 2]];
}

}  // namespace tyndall::app
