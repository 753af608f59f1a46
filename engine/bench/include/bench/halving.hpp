// Successive halving: many candidates are measured cheaply, fewer and fewer ever better.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace tyndall::bench {

struct Score {
  double milliseconds = 0, error = 0;
};

/// What is asked for: the least time with an error of at most `maxError`, or the least error within `budgetMs`. One of
/// the two is set.
struct Goal {
  std::optional<double> maxError, budgetMs;
  double bounded(const Score& s) const { return maxError ? s.error : s.milliseconds; }
  double wanted(const Score& s) const { return maxError ? s.milliseconds : s.error; }
  double bound() const { return maxError ? *maxError : *budgetMs; }
  bool met(const Score& s, double slack = 1) const { return bounded(s) <= bound() * slack; }
};

/// Indices of scores, best first: those that meet the bound, widened by `slack` (>= 1: cheap measurements err), by what
/// is wanted; then the others by how far off the bound they are.
std::vector<std::size_t> ranking(const std::vector<Score>& scores, const Goal& goal, double slack);

/// The first `keep` of the ranking, and whoever is on the Pareto front of the whole field between half and twice the
/// bound: where cheap measurements misjudge the bound, the right candidate is among these.
std::vector<std::size_t> survivors(const std::vector<Score>& scores, const Goal& goal, double slack, std::size_t keep);

}  // namespace tyndall::bench
