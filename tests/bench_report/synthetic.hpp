// A small results.json with every kind of point, whose figures follow simple laws so that tests can compute what is
// right.
#pragma once

#include <nlohmann/json.hpp>

namespace tyndall::bench::test {

/// Two levels, five series; error and time of each are power laws of its knob. Has every plot family, papers' rows, one
/// failed point.
nlohmann::json results();

/// A point without anything that may be missing but the time and the error.
nlohmann::json point(const std::string& series, const std::string& technique, const std::string& label, double ms,
                     double nrmse);

}  // namespace tyndall::bench::test
