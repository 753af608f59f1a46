// Curves of measured points with error bars, as inline SVG.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "axis.hpp"
#include "results.hpp"
#include "style.hpp"

namespace tyndall::bench::report {

struct Mark {
  double x = 0, y = 0;
  Number yLow, yHigh;  ///< quartiles
  std::string tip;     ///< what the reader sees over the mark; lines separated by \n
  std::string name;    ///< written beside the mark where there is room; empty: not
};

struct Line {
  std::string series;
  Style style;
  std::vector<Mark> marks;  ///< joined in this order
  bool joined = true;
};

/// A dashed line across the plot at one x.
struct Rule {
  double x = 0;
  std::string label;
};

struct LinePlot {
  std::string title;  ///< for readers who cannot see it
  Axis x, y;
  std::vector<Line> lines;
  std::vector<std::pair<double, double>> front;  ///< drawn as the border of what is dominated, to the upper right
  std::optional<Rule> rule;
  double width = 440, height = 320;
};

/// Empty when no mark can be shown (on a logarithmic axis: none is positive).
std::string svg(const LinePlot& plot);

/// A small picture of a series' line and marker.
std::string swatch(Style style);
/// Markers without a line, with their names, as an HTML list.
std::string markerLegend(const std::vector<std::pair<Style, std::string>>& entries);
/// The swatches of these series with their names, as an HTML list.
std::string legend(const std::vector<std::string>& series, const Styles& styles);

}  // namespace tyndall::bench::report
