// Which of several timed frames speaks for them all.
#pragma once

#include <vector>

#include "render/graph.hpp"

namespace tyndall::app {

double totalMs(const std::vector<render::PassTime>& passes);

/// The frame whose total is the median (of an even number: the lower of the two in the middle). One whole frame is
/// taken, not a median per pass, so that its passes add up to its total. `frames` must not be empty.
const std::vector<render::PassTime>& medianFrame(const std::vector<std::vector<render::PassTime>>& frames);

}  // namespace tyndall::app
