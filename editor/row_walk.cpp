#include "row_walk.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace tyndall::editor {

Walk walkOf(const WalkRow& row, std::uint32_t elements, float depth) {
  Walk walk;
  if (row.before.size() < 2 || row.levels.empty()) return walk;
  // Ties within a bin are taken as evenly spread.
  const auto bins = static_cast<double>(row.before.size() - 1);
  const double at = static_cast<double>(depth) * bins;
  const auto bin = static_cast<std::size_t>(std::clamp(at, 0.0, bins - 1));
  const double part = std::clamp(at - static_cast<double>(bin), 0.0, 1.0);
  walk.rank = std::lerp(static_cast<double>(row.before[bin]), static_cast<double>(row.before[bin + 1]), part);
  const auto size = static_cast<std::uint32_t>(row.levels.front().size());
  const auto bits = static_cast<std::uint32_t>(std::bit_width(size)) - 1;
  walk.elements = std::min(elements, size);
  const auto whole = std::min(static_cast<std::uint32_t>(walk.rank), size - 1);
  std::uint32_t left = walk.elements, first = 0, span = size;
  double undecided = 1;
  for (std::uint32_t level = 0; level < row.levels.size() && level < bits && left > 0; ++level) {
    const WalkRow::Texel& texel = row.levels[level][first + left - 1];
    WalkStep step{first, first + span, left};
    step.zeros = std::min(static_cast<std::uint32_t>(std::lround(texel.zeros)), left);
    step.share = texel.share;
    span /= 2;
    step.second = whole >= first + span;
    const double ofFirst = undecided * static_cast<double>(texel.share);
    if (step.second) {
      walk.blocked += ofFirst, walk.blockers += step.zeros;
      undecided -= ofFirst, left -= step.zeros, first += span;
    } else {
      undecided = ofFirst, left = step.zeros;
    }
    step.blocked = walk.blocked, step.undecided = undecided;
    walk.steps.push_back(step);
  }
  walk.left = left;
  // What is left is weighed as if it were spread evenly over the node.
  if (left > 0) walk.blocked += undecided * std::clamp((walk.rank - first) / span, 0.0, 1.0);
  return walk;
}

}  // namespace tyndall::editor
