// Time against what a scene or a user gives: resolution, size of the maps, lights, triangles.
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "chapters.hpp"
#include "knob_axis.hpp"
#include "line_plot.hpp"
#include "markup.hpp"
#include "text.hpp"

namespace tyndall::bench::report {
namespace {

struct Curve {
  std::string series;
  std::vector<std::pair<double, const Point*>> points;
};

const Level* levelOf(const Results& results, const Point& p) {
  const auto found = std::find_if(results.levels.begin(), results.levels.end(),
                                  [&](const Level& l) { return l.name == p.level && l.camera == p.camera; });
  return found == results.levels.end() ? nullptr : &*found;
}

/// Exponent of the power law through the points by least squares in logarithms; from three different x on.
Number exponent(const std::vector<std::pair<double, double>>& points) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  double least = 0, greatest = 0;
  for (const auto& [x, y] : points) {
    if (!(x > 0) || !(y > 0)) continue;
    const double lx = std::log(x), ly = std::log(y);
    least = n == 0 ? lx : std::min(least, lx);
    greatest = n == 0 ? lx : std::max(greatest, lx);
    ++n, sx += lx, sy += ly, sxx += lx * lx, sxy += lx * ly;
  }
  const double spread = n * sxx - sx * sx;
  if (n < 3 || greatest - least < std::log(1.5) || !(spread > 1e-12)) return {};
  return (n * sxy - sx * sy) / spread;
}

/// Median times against x, and the exponents in words. `shadow`: the engine's shadow maps instead of the plugin.
std::string timePlot(const Context& context, const std::vector<Curve>& curves, const Axis& x, bool shadow,
                     std::string& exponents) {
  LinePlot plot;
  plot.title = (shadow ? "Shadow maps' time against " : "Volumetrics' time against ") + x.label;
  plot.x = x;
  plot.y = {shadow ? "engine's shadow maps, ms" : "volumetrics, ms", Scale::kLog};
  std::vector<std::string> found;
  for (const Curve& c : curves) {
    Line line = {c.series, context.styles.of(c.series), {}, x.scale != Scale::kCategory};
    std::vector<std::pair<double, double>> data;
    for (const auto& [px, p] : c.points) {
      const auto& time = shadow ? p->shadow : p->volumetrics;
      if (!time) continue;
      data.emplace_back(px, time->median);
      line.marks.push_back(
          {px, time->median, time->low, time->high,
           tipOf(*p, referenceOf({p})) + "\n" + x.label + ": " + (x.scale == Scale::kCategory ? "" : whole(px)), ""});
    }
    if (const Number e = exponent(data); e && x.scale != Scale::kCategory)
      found.push_back(c.series + " " + figure(*e, 2));
    plot.lines.push_back(std::move(line));
  }
  if (!shadow && !found.empty())
    exponents = "Slope in logarithms, least squares (1: proportional): " + list(found) + ".";
  return svg(plot);
}

std::string block(const Context& context, const std::vector<Curve>& curves, const Axis& axis, const std::string& title,
                  bool shadows, const std::string& where) {
  std::vector<std::string> plots, series;
  std::string exponents, none;
  for (const bool shadow : {false, true}) {
    if (shadow && !shadows) continue;
    if (std::string drawn = timePlot(context, curves, axis, shadow, shadow ? none : exponents); !drawn.empty())
      plots.push_back(std::move(drawn));
  }
  if (plots.empty()) return {};
  for (const Curve& c : curves) series.push_back(c.series);
  Markup m;
  m.element("h3", title);
  return m.take() +
         figureBlock(plots, legend(series, context.styles), where + (exponents.empty() ? "" : " " + exponents));
}

using Coordinate = std::function<Number(const Point&)>;

std::vector<Curve> curvesOf(const Context& context, const Points& points, const Coordinate& x,
                            std::vector<double>& values) {
  std::vector<Curve> curves;
  for (const auto& [series, own] : bySeries(points, context.styles)) {
    Curve c = {series, {}};
    for (const Point* p : own)
      if (const Number v = x(*p)) c.points.emplace_back(*v, p), values.push_back(*v);
    std::stable_sort(c.points.begin(), c.points.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    if (!c.points.empty()) curves.push_back(std::move(c));
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return curves;
}

Axis axisFor(const std::string& label, const std::vector<double>& values) {
  const bool log = values.front() > 0 && values.back() >= 4 * values.front();
  return {label, log ? Scale::kLog : Scale::kLinear, false, {}, true};
}

std::string levelsOf(const Points& points) {
  std::vector<std::string> names;
  for (const Point* p : points) {
    const std::string name = p->level + " camera " + std::to_string(p->camera);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return list(names);
}

/// Levels differ along the axis; size and time do not.
std::string acrossLevels(const Context& context, const std::string& plot, const std::string& label,
                         const std::string& title, Number Level::*property) {
  std::string body;
  std::map<std::pair<int, int>, Points> bySize;
  for (const Point* p : pointsOf(context.results, plot)) bySize[{p->width, p->height}].push_back(p);
  for (const auto& [size, points] : bySize) {
    std::vector<double> values;
    const auto curves = curvesOf(
        context, points,
        [&](const Point& p) {
          const Level* level = levelOf(context.results, p);
          if (p.knob && p.knob->value.number && shortId(p.knob->id) == plot) return p.knob->value.number;
          return level ? level->*property : Number();
        },
        values);
    if (values.size() < 2) continue;
    body += block(context, curves, axisFor(label, values), title + ", " + sizeText(size.first, size.second), true,
                  "Levels: " + levelsOf(points) + ".");
  }
  return body;
}

}  // namespace

std::string scalingChapter(const Context& context) {
  std::string body;
  for (const Level& level : context.results.levels) {
    const Points points = inLevel(pointsOf(context.results, "resolution"), level);
    std::vector<double> values;
    const auto curves = curvesOf(
        context, points,
        [](const Point& p) { return p.width > 0 && p.height > 0 ? Number(1.0 * p.width * p.height) : Number(); },
        values);
    if (values.size() < 2) continue;
    std::vector<std::string> sizes;
    for (const Point* p : points)
      if (const std::string s = sizeText(p->width, p->height); std::find(sizes.begin(), sizes.end(), s) == sizes.end())
        sizes.push_back(s);
    body += block(context, curves, axisFor("pixels", values),
                  "Resolution: " + level.name + ", camera " + std::to_string(level.camera), false,
                  "Sizes: " + list(sizes) + ".");
  }
  for (const Level& level : context.results.levels) {
    std::map<std::string, Points> byKnob;
    for (const Point* p : inLevel(pointsOf(context.results, "map"), level))
      if (p->knob) byKnob[p->knob->id].push_back(p);
    for (const auto& [id, own] : byKnob)
      for (const auto& [view, points] : byView(own)) {
        const KnobAxis axis(id, points);
        if (axis.values() < 2) continue;
        std::vector<double> values;
        const auto curves = curvesOf(
            context, points, [&](const Point& p) { return axis.position(p); }, values);
        body +=
            block(context, curves, axis.axis(),
                  "Size of the map: " + level.name + ", camera " + std::to_string(level.camera) + ", " + sizeText(view),
                  true, id + ".");
      }
  }
  body += acrossLevels(context, "lights", "lights", "Lights", &Level::lights);
  body += acrossLevels(context, "triangles", "triangles", "Triangles", &Level::triangles);
  if (body.empty()) return {};
  Markup m;
  m.element("h2", "Scaling", {{"id", "scaling"}});
  m.element("p",
            "Time against what scene and user give, both logarithmic where the range asks for it; bars: quartiles.");
  return m.take() + body;
}

}  // namespace tyndall::bench::report
