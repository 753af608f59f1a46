#include "bench/halving.hpp"

#include <algorithm>
#include <numeric>
#include <set>

namespace tyndall::bench {

std::vector<std::size_t> ranking(const std::vector<Score>& scores, const Goal& goal, double slack) {
  std::vector<std::size_t> order(scores.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const bool metA = goal.met(scores[a], slack), metB = goal.met(scores[b], slack);
    if (metA != metB) return metA;
    return metA ? goal.wanted(scores[a]) < goal.wanted(scores[b]) : goal.bounded(scores[a]) < goal.bounded(scores[b]);
  });
  return order;
}

std::vector<std::size_t> survivors(const std::vector<Score>& scores, const Goal& goal, double slack, std::size_t keep) {
  const std::vector<std::size_t> order = ranking(scores, goal, slack);
  std::set<std::size_t> kept(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(std::min(keep, order.size())));
  for (std::size_t i = 0; i < scores.size(); ++i) {
    const double bounded = goal.bounded(scores[i]);
    if (bounded < 0.5 * goal.bound() || bounded > 2 * goal.bound()) continue;
    const bool beaten = std::any_of(scores.begin(), scores.end(), [&](const Score& other) {
      return other.milliseconds <= scores[i].milliseconds && other.error <= scores[i].error &&
             (other.milliseconds < scores[i].milliseconds || other.error < scores[i].error);
    });
    if (!beaten) kept.insert(i);
  }
  std::vector<std::size_t> result;
  for (const std::size_t i : order)
    if (kept.contains(i)) result.push_back(i);
  return result;
}

}  // namespace tyndall::bench
