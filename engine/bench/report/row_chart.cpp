#include "row_chart.hpp"

#include <algorithm>
#include <cmath>

#include "markup.hpp"

namespace tyndall::bench::report {
namespace {

constexpr double kWidth = 860, kRow = 26, kBar = 16, kTop = 8, kLetter = 6.2;  // 12 px letters are 6.2 wide on average
constexpr std::size_t kLongestLabel = 44;

/// At most `count` characters of UTF-8, the last one an ellipsis when something was cut.
std::string shortened(const std::string& text, std::size_t count) {
  std::size_t characters = 0, cut = text.size();
  for (std::size_t i = 0; i < text.size(); ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xC0) == 0x80) continue;
    if (++characters == count) cut = i;
    if (characters > count) return text.substr(0, cut) + "…";
  }
  return text;
}

bool visible(const Segment& s) { return s.value > 0 && std::isfinite(s.value); }

bool hasContent(const Row& row, Scale scale) {
  return std::any_of(row.segments.begin(), row.segments.end(), visible) ||
         std::any_of(row.dots.begin(), row.dots.end(), [&](const Dot& d) { return showable(scale, d.value); });
}

void bars(Markup& m, const Row& row, const AxisMap& x, double y) {
  double sum = 0;
  for (const Segment& s : row.segments) {
    if (!visible(s)) continue;
    const double left = x.pixel(sum), right = x.pixel(sum + s.value);
    sum += s.value;
    m.open("g", {{"class", "part f" + std::to_string(s.fill % kFills)}}).element("title", s.tip);
    m.leaf("rect", {{"x", left}, {"y", y - kBar / 2}, {"width", right - left}, {"height", kBar}});
    if (!s.name.empty() && kLetter * static_cast<double>(s.name.size()) + 6 < right - left)
      m.element("text", s.name, {{"class", "part"}, {"x", 0.5 * (left + right)}, {"y", y + 4}});
    m.close();
  }
}

void dots(Markup& m, const Row& row, const AxisMap& x, Scale scale, double y) {
  double least = 1e300, greatest = -1e300;
  for (const Dot& d : row.dots) {
    if (!showable(scale, d.value)) continue;
    least = std::min(least, x.pixel(d.value));
    greatest = std::max(greatest, x.pixel(d.value));
  }
  if (greatest > least) m.leaf("line", {{"class", "reach"}, {"x1", least}, {"x2", greatest}, {"y1", y}, {"y2", y}});
  for (const Dot& d : row.dots) {
    if (!showable(scale, d.value)) continue;
    m.open("g", {{"class", "mark " + colourClass(d.style.colour)},
                 {"transform", "translate(" + coordinate(x.pixel(d.value)) + " " + coordinate(y) + ")"}});
    m.element("title", d.tip).leaf("path", {{"class", "dot"}, {"d", markerPath(d.style.marker)}}).close();
  }
}

}  // namespace

std::string svg(const RowChart& chart) {
  std::vector<const Row*> rows;
  std::vector<double> values;
  std::size_t longest = 0;
  for (const Row& row : chart.rows) {
    if (!hasContent(row, chart.x.scale)) continue;
    rows.push_back(&row);
    double sum = 0;
    for (const Segment& s : row.segments) sum += visible(s) ? s.value : 0;
    if (!row.segments.empty()) values.push_back(sum);
    for (const Dot& d : row.dots) values.push_back(d.value);
    longest = std::max(longest, shortened(row.label, kLongestLabel).size());
  }
  if (rows.empty()) return {};
  if (chart.rule) values.push_back(chart.rule->x);

  const double left = 16 + kLetter * static_cast<double>(std::min(longest, kLongestLabel)),
               right = kWidth - 12 - chart.noteWidth;
  const double bottom = kTop + kRow * static_cast<double>(rows.size()), height = bottom + 46;
  const AxisMap x(chart.x, values, left, right);
  Markup m;
  m.open("svg", {{"class", "plot"},
                 {"xmlns", "http://www.w3.org/2000/svg"},
                 {"role", "img"},
                 {"aria-label", chart.title},
                 {"viewBox", "0 0 " + coordinate(kWidth) + " " + coordinate(height)},
                 {"style", "max-width:" + coordinate(kWidth) + "px"}});
  for (const Tick& t : x.ticks()) {
    m.leaf("line", {{"class", t.label.empty() ? "grid minor" : "grid"},
                    {"x1", t.pixel},
                    {"x2", t.pixel},
                    {"y1", kTop},
                    {"y2", bottom}});
    if (!t.label.empty()) m.element("text", t.label, {{"class", "tick x"}, {"x", t.pixel}, {"y", bottom + 16}});
  }
  if (chart.rule) {
    const double px = x.pixel(chart.rule->x);
    m.leaf("line", {{"class", "rule"}, {"x1", px}, {"x2", px}, {"y1", kTop}, {"y2", bottom}});
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = *rows[i];
    const double y = kTop + kRow * (static_cast<double>(i) + 0.5);
    m.open("g").element("title", row.label);
    m.element("text", shortened(row.label, kLongestLabel), {{"class", "tick y"}, {"x", left - 8}, {"y", y + 4}})
        .close();
    bars(m, row, x, y);
    dots(m, row, x, chart.x.scale, y);
    if (chart.noteWidth > 0) m.element("text", row.note, {{"class", "note"}, {"x", right + 8}, {"y", y + 4}});
  }
  m.leaf("rect", {{"class", "frame"}, {"x", left}, {"y", kTop}, {"width", right - left}, {"height", bottom - kTop}});
  m.element("text", chart.x.label, {{"class", "axis x"}, {"x", 0.5 * (left + right)}, {"y", bottom + 36}});
  m.close();
  return m.take();
}

std::string fillLegend(const std::vector<std::pair<int, std::string>>& entries) {
  Markup m;
  m.open("ul", {{"class", "legend"}});
  for (const auto& [fill, name] : entries) {
    m.open("li").open("svg", {{"class", "swatch"},
                              {"xmlns", "http://www.w3.org/2000/svg"},
                              {"viewBox", "0 0 16 16"},
                              {"width", 16},
                              {"height", 16},
                              {"aria-hidden", "true"}});
    m.open("g", {{"class", "part f" + std::to_string(fill % kFills)}})
        .leaf("rect", {{"x", 1}, {"y", 2}, {"width", 14}, {"height", 12}})
        .close();
    m.close().text(" " + name).close();
  }
  m.close();
  return m.take();
}

}  // namespace tyndall::bench::report
