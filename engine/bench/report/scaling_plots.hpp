// Plots of time and error against one quantity, and the exponents of their power laws.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "axis.hpp"
#include "selection.hpp"

namespace tyndall::bench::report {

struct ScalingCurve {
  std::string series;
  std::vector<std::pair<double, const Point*>> points;  ///< by rising x
};

/// What the plots of one block show against x, each in a panel of its own.
struct Panels {
  bool shadow = false;  ///< the engine's shadow maps, beside the plugin's time
  bool error = false;   ///< where the points have errors
};

/// The points' curves over `x`; `values` receives the different x, rising.
std::vector<ScalingCurve> scalingCurves(const Context& context, const Points& points,
                                        const std::function<Number(const Point&)>& x, std::vector<double>& values);

/// Exponent of the power law through (x, y) by least squares in logarithms; from three points on whose x span a factor
/// of 1.5 or more.
Number powerLawExponent(const std::vector<std::pair<double, double>>& points);

/// A heading, the panels, a legend, and `where` with the exponents of the times as caption.
std::string scalingBlock(const Context& context, const std::vector<ScalingCurve>& curves, const Axis& axis,
                         const std::string& title, Panels panels, const std::string& where);

}  // namespace tyndall::bench::report
