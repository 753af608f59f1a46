// From a sweep to the points that are measured.
#pragma once

#include <string>
#include <vector>

#include "app/catalogue.hpp"
#include "bench/results.hpp"

namespace tyndall::bench {

/// The points of one view, without figures. `content`: app::Level::contentHash; another content, other points. Every
/// value is checked against the catalogue's table, which is left at its defaults. Points with the same `measurement`
/// differ in what they are shown as alone. Errors: an unknown id or a refused value, named with the sweep's.
struct PlannedPoint {
  PointFigures figures;
  Assignments all;          ///< the sweep's settings and the point's own
  std::string measurement;  ///< the same text for what need not be measured twice
  bool motion = false;
};
Result<std::vector<PlannedPoint>> pointsOf(const Sweep& sweep, app::Catalogue& catalogue, const std::string& level,
                                           std::uint64_t content, std::uint32_t camera);

/// Puts defaults and then `assignments` into the table.
Result<void> applySettings(params::Table& table, const Assignments& assignments);

}  // namespace tyndall::bench
