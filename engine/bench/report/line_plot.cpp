#include "line_plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "markup.hpp"

namespace tyndall::bench::report {
namespace {

struct Box {
  double left, top, right, bottom;
};

bool overlap(const Box& a, const Box& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

/// The plot's inner rectangle in user units.
struct Frame {
  double left, top, right, bottom;
};

class Drawing {
 public:
  Drawing(const LinePlot& plot, Frame f, const std::vector<double>& xs, const std::vector<double>& ys)
      : plot_(plot), f_(f), x_(plot.x, xs, f.left, f.right), y_(plot.y, ys, f.bottom, f.top) {}

  std::string draw() {
    m_.open("svg", {{"class", "plot"},
                    {"xmlns", "http://www.w3.org/2000/svg"},
                    {"role", "img"},
                    {"aria-label", plot_.title},
                    {"viewBox", "0 0 " + coordinate(plot_.width) + " " + coordinate(plot_.height)},
                    {"style", "max-width:" + coordinate(plot_.width) + "px"}});
    axes();
    front();
    rule();
    for (const Line& line : plot_.lines) curve(line);
    for (const Line& line : plot_.lines)
      for (const Mark& mark : line.marks)
        if (shown(mark)) marker(line, mark);
    names();
    m_.close();
    return m_.take();
  }

 private:
  bool shown(const Mark& m) const { return showable(plot_.x.scale, m.x) && showable(plot_.y.scale, m.y); }

  void axes() {
    for (const Tick& t : x_.ticks()) {
      m_.leaf("line", {{"class", t.label.empty() ? "grid minor" : "grid"},
                       {"x1", t.pixel},
                       {"x2", t.pixel},
                       {"y1", f_.top},
                       {"y2", f_.bottom}});
      if (!t.label.empty()) m_.element("text", t.label, {{"class", "tick x"}, {"x", t.pixel}, {"y", f_.bottom + 16}});
    }
    for (const Tick& t : y_.ticks()) {
      m_.leaf("line", {{"class", t.label.empty() ? "grid minor" : "grid"},
                       {"x1", f_.left},
                       {"x2", f_.right},
                       {"y1", t.pixel},
                       {"y2", t.pixel}});
      if (!t.label.empty()) m_.element("text", t.label, {{"class", "tick y"}, {"x", f_.left - 6}, {"y", t.pixel + 4}});
    }
    m_.leaf("rect", {{"class", "frame"},
                     {"x", f_.left},
                     {"y", f_.top},
                     {"width", f_.right - f_.left},
                     {"height", f_.bottom - f_.top}});
    m_.element("text", plot_.x.label, {{"class", "axis x"}, {"x", 0.5 * (f_.left + f_.right)}, {"y", f_.bottom + 36}});
    m_.element("text", plot_.y.label,
               {{"class", "axis y"},
                {"transform", "translate(14 " + coordinate(0.5 * (f_.top + f_.bottom)) + ") rotate(-90)"}});
  }

  /// A staircase: what lies above and to the right of it is beaten in both.
  void front() {
    if (plot_.front.empty()) return;
    std::string path;
    double lastX = 0;
    for (const auto& [vx, vy] : plot_.front) {  // by rising y, so from right to left
      const double px = x_.pixel(vx), py = y_.pixel(vy);
      if (path.empty())
        path = "M" + coordinate(f_.right) + " " + coordinate(py) + "H" + coordinate(px);
      else
        path += "H" + coordinate(lastX) + "V" + coordinate(py) + "H" + coordinate(px);
      lastX = px;
    }
    path += "V" + coordinate(f_.top);
    m_.leaf("path", {{"class", "front"}, {"d", path}});
  }

  void rule() {
    if (!plot_.rule || !showable(plot_.x.scale, plot_.rule->x)) return;
    const double px = x_.pixel(plot_.rule->x);
    if (px < f_.left || px > f_.right) return;
    m_.leaf("line", {{"class", "rule"}, {"x1", px}, {"x2", px}, {"y1", f_.top}, {"y2", f_.bottom}});
    m_.element("text", plot_.rule->label,
               {{"class", "rule"},
                {"transform", "translate(" + coordinate(px - 4) + " " + coordinate(f_.top + 6) + ") rotate(-90)"}});
    taken_.push_back({px - 14, f_.top, px + 1, f_.top + 6.3 * static_cast<double>(plot_.rule->label.size())});
  }

  void curve(const Line& line) {
    std::string path;
    const Mark* last = nullptr;
    for (const Mark& mark : line.marks) {
      if (!shown(mark)) continue;
      if (last && line.joined) keepClear(x_.pixel(last->x), y_.pixel(last->y), x_.pixel(mark.x), y_.pixel(mark.y));
      last = &mark;
      path += (path.empty() ? "M" : "L") + coordinate(x_.pixel(mark.x)) + " " + coordinate(y_.pixel(mark.y));
    }
    if (!line.joined || path.find('L') == std::string::npos) return;
    m_.leaf("path", {{"class", "curve " + colourClass(line.style.colour)},
                     {"d", path},
                     {"stroke-dasharray", line.style.dash ? dashes(line.style.dash) : "none"},
                     {"data-series", line.series}});
  }

  /// Names would rather not lie on a line: boxes along it.
  void keepClear(double x0, double y0, double x1, double y1) {
    const int steps = 1 + static_cast<int>(std::hypot(x1 - x0, y1 - y0) / 6);
    for (int i = 0; i <= steps; ++i) {
      const double t = 1.0 * i / steps, px = std::lerp(x0, x1, t), py = std::lerp(y0, y1, t);
      lines_.push_back({px - 3, py - 3, px + 3, py + 3});
    }
  }

  void marker(const Line& line, const Mark& mark) {
    const double px = x_.pixel(mark.x), py = y_.pixel(mark.y);
    m_.open("g", {{"class", "mark " + colourClass(line.style.colour)},
                  {"transform", "translate(" + coordinate(px) + " " + coordinate(py) + ")"},
                  {"data-series", line.series}});
    m_.element("title", mark.tip);
    if (mark.yLow && mark.yHigh && showable(plot_.y.scale, *mark.yLow)) {
      const double a = y_.pixel(*mark.yHigh) - py, b = y_.pixel(*mark.yLow) - py;
      m_.leaf("path", {{"class", "bar"},
                       {"d", "M-3 " + coordinate(a) + "H3M0 " + coordinate(a) + "V" + coordinate(b) + "M-3 " +
                                 coordinate(b) + "H3"}});
    }
    m_.leaf("path", {{"class", "dot"}, {"d", markerPath(line.style.marker)}});
    m_.close();
    taken_.push_back({px - 5, py - 5, px + 5, py + 5});
  }

  /// Names beside their marks, at the first of eight places that is free, clear of lines too where that can be; none
  /// where all are taken.
  void names() {
    for (const Line& line : plot_.lines)
      for (const Mark& mark : line.marks) {
        if (mark.name.empty() || !shown(mark)) continue;
        auto box = place(mark, true);
        if (!box) box = place(mark, false);
        if (!box) continue;
        m_.element("text", mark.name, {{"class", "name"}, {"x", box->left}, {"y", box->bottom - 3}});
        taken_.push_back(*box);
      }
  }

  std::optional<Box> place(const Mark& mark, bool clearOfLines) const {
    const double px = x_.pixel(mark.x), py = y_.pixel(mark.y);
    const double w = 5.9 * static_cast<double>(mark.name.size()), h = 12;
    const std::array<std::array<double, 2>, 8> places = {{{9, -h / 2},
                                                          {-9 - w, -h / 2},
                                                          {6, -h - 5},
                                                          {-w - 6, 5},
                                                          {6, 5},
                                                          {-w - 6, -h - 5},
                                                          {-w / 2, -h - 8},
                                                          {-w / 2, 8}}};
    for (const auto& [dx, dy] : places) {
      const Box box = {px + dx, py + dy, px + dx + w, py + dy + h};
      const auto hits = [&](const Box& b) { return overlap(b, box); };
      if (box.left < f_.left || box.right > f_.right || box.top < f_.top || box.bottom > f_.bottom) continue;
      if (std::any_of(taken_.begin(), taken_.end(), hits)) continue;
      if (!clearOfLines || std::none_of(lines_.begin(), lines_.end(), hits)) return box;
    }
    return {};
  }

  const LinePlot& plot_;
  Frame f_;
  AxisMap x_, y_;
  Markup m_;
  std::vector<Box> taken_, lines_;
};

}  // namespace

std::string svg(const LinePlot& plot) {
  std::vector<double> xs, ys;
  for (const Line& line : plot.lines)
    for (const Mark& mark : line.marks) {
      if (!showable(plot.x.scale, mark.x) || !showable(plot.y.scale, mark.y)) continue;
      xs.push_back(mark.x);
      ys.push_back(mark.y);
      if (mark.yLow && mark.yHigh) ys.insert(ys.end(), {*mark.yLow, *mark.yHigh});
    }
  if (xs.empty()) return {};
  if (plot.rule) xs.push_back(plot.rule->x);
  return Drawing(plot, {58, 10, plot.width - 28, plot.height - 46}, xs, ys).draw();
}

std::string swatch(Style style) {
  Markup m;
  m.open("svg", {{"class", "swatch"},
                 {"xmlns", "http://www.w3.org/2000/svg"},
                 {"viewBox", "-18 -8 36 16"},
                 {"width", 36},
                 {"height", 16},
                 {"aria-hidden", "true"}});
  m.leaf("path", {{"class", "curve " + colourClass(style.colour)},
                  {"d", "M-17 0H17"},
                  {"stroke-dasharray", style.dash ? dashes(style.dash) : "none"}});
  m.open("g", {{"class", "mark " + colourClass(style.colour)}})
      .leaf("path", {{"class", "dot"}, {"d", markerPath(style.marker)}})
      .close();
  m.close();
  return m.take();
}

std::string markerLegend(const std::vector<std::pair<Style, std::string>>& entries) {
  Markup m;
  m.open("ul", {{"class", "legend"}});
  for (const auto& [style, name] : entries) {
    m.open("li").open("svg", {{"class", "swatch"},
                              {"xmlns", "http://www.w3.org/2000/svg"},
                              {"viewBox", "-8 -8 16 16"},
                              {"width", 16},
                              {"height", 16},
                              {"aria-hidden", "true"}});
    m.open("g", {{"class", "mark " + colourClass(style.colour)}});
    m.leaf("path", {{"class", "dot"}, {"d", markerPath(style.marker)}}).close();
    m.close().text(" " + name).close();
  }
  m.close();
  return m.take();
}

std::string legend(const std::vector<std::string>& series, const Styles& styles) {
  Markup m;
  m.open("ul", {{"class", "legend"}});
  for (const std::string& s : series)
    m.open("li", {{"data-series", s}}).raw(swatch(styles.of(s))).text(" " + s).close();
  m.close();
  return m.take();
}

}  // namespace tyndall::bench::report
