// What the figures of one view say, in words: made from the data, never from expectation.
#pragma once

#include <string>
#include <vector>

#include "selection.hpp"

namespace tyndall::bench::report {

struct Finding {
  std::string about, text;
};

/// The front, by series from the least error on; where the plain march or a rival is cheaper than ours at equal error
/// and where ours is; how far the truth itself can be trusted.
std::vector<Finding> findings(const Context& context, const Level& level, const Points& points, Reference reference);

}  // namespace tyndall::bench::report
