// Cost against error: the Pareto front, and comparisons of curves at equal error or equal cost. Pure functions.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tyndall::bench {

/// One measured point; both are better when smaller. Cost is a time in ms wherever the benchmark uses it.
struct CostError {
  double cost = 0;
  double error = 0;
};

/// Indices of the points that no other point beats (no worse in both, better in one), by rising cost and so falling
/// error. Of equal points the first counts. Points that are not finite are never on the front.
std::vector<std::size_t> paretoFront(std::span<const CostError> points);

/// The front as a curve for logarithmic interpolation: points with a cost or error of 0 or less are left out first.
std::vector<CostError> frontCurve(std::span<const CostError> points);

/// Cost at which the front of `points` has the error, interpolated linearly in log error and log cost between
/// neighbours of the front. Never extrapolated: nothing outside the errors that were measured.
std::optional<double> costAtError(std::span<const CostError> points, double error);
/// The same the other way round: the error that the front has at a cost.
std::optional<double> errorAtCost(std::span<const CostError> points, double cost);

/// A range of errors in which the same one of two curves is cheaper.
struct Stretch {
  enum class Cheaper { kFirst, kEqual, kSecond } cheaper = Cheaper::kEqual;
  double from = 0, to = 0;                   ///< errors, from < to; equal where the curves share one error only
  double leastRatio = 1, greatestRatio = 1;  ///< second's cost / first's cost within the range
};

/// Compares the fronts of both over the errors that both have, from small to large errors. Costs whose ratio is at most
/// `equal` (1 or more: the noise of the figures) count as equal. Empty where they share no error.
std::vector<Stretch> compareAtEqualError(std::span<const CostError> first, std::span<const CostError> second,
                                         double equal = 1);

}  // namespace tyndall::bench
