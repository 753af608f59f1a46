// A row per measured point: stacked bars or dots on a common axis, as inline SVG.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "axis.hpp"
#include "line_plot.hpp"
#include "style.hpp"

namespace tyndall::bench::report {

struct Segment {
  double value = 0;
  int fill = 0;  ///< index of the page's --f0, --f1, …: shades for parts of a bar
  std::string name, tip;
};

struct Dot {
  double value = 0;
  Style style;
  std::string tip;
};

struct Row {
  std::string label, note;  ///< to the left and to the right of the row
  std::vector<Segment> segments;
  std::vector<Dot> dots;
};

struct RowChart {
  std::string title;
  Axis x;
  std::vector<Row> rows;
  std::optional<Rule> rule;
  double noteWidth = 0;  ///< pixels kept for the notes; 0: none are written
};

inline constexpr int kFills = 8;

/// Empty when no row has anything to show.
std::string svg(const RowChart& chart);

/// Squares in the fills' colours with names, as an HTML list.
std::string fillLegend(const std::vector<std::pair<int, std::string>>& entries);

}  // namespace tyndall::bench::report
