// Time against what a scene or a user gives: resolution, size of the maps, lights, triangles.
#include <algorithm>
#include <map>

#include "chapters.hpp"
#include "knob_axis.hpp"
#include "markup.hpp"
#include "scaling_plots.hpp"
#include "text.hpp"

namespace tyndall::bench::report {
namespace {

const Level* levelOf(const Results& results, const Point& p) {
  const auto found = std::find_if(results.levels.begin(), results.levels.end(),
                                  [&](const Level& l) { return l.name == p.level && l.camera == p.camera; });
  return found == results.levels.end() ? nullptr : &*found;
}

std::string nameOf(const Level& level) { return level.name + ", camera " + std::to_string(level.camera); }

Axis axisFor(const std::string& label, const std::vector<double>& values) {
  const bool log = values.front() > 0 && values.back() >= 4 * values.front();
  return {label, log ? Scale::kLog : Scale::kLinear, false, {}, true, {}};
}

std::string levelsOf(const Points& points) {
  std::vector<std::string> names;
  for (const Point* p : points) {
    const std::string name = p->level + " camera " + std::to_string(p->camera);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return list(names);
}

std::string resolutions(const Context& context, const Level& level) {
  const Points points = inLevel(pointsOf(context.results, "resolution"), level);
  std::vector<double> values;
  const auto curves = scalingCurves(
      context, points,
      [](const Point& p) { return p.width > 0 && p.height > 0 ? Number(1.0 * p.width * p.height) : Number(); }, values);
  if (values.size() < 2) return {};
  Axis axis = axisFor("pixels", values);
  for (const Point* p : points) axis.names[1.0 * p->width * p->height] = sizeText(p->width, p->height);
  return scalingBlock(context, curves, axis, "Resolution: " + nameOf(level), {false, true},
                      "The axis counts pixels; sizes that share their number of pixels share their place.");
}

std::string maps(const Context& context, const Level& level) {
  std::map<std::string, Points> byKnob;
  for (const Point* p : inLevel(pointsOf(context.results, "map"), level))
    if (p->knob) byKnob[p->knob->id].push_back(p);
  std::string body;
  for (const auto& [id, own] : byKnob)
    for (const auto& [view, points] : byView(own)) {
      const KnobAxis axis(id, points);
      if (axis.values() < 2) continue;
      std::vector<double> values;
      const auto curves = scalingCurves(
          context, points, [&](const Point& p) { return axis.position(p); }, values);
      // The engine's shadow maps depend on their own size, not on that of the plugin's maps.
      body += scalingBlock(context, curves, axis.axis(), "Size of the map: " + nameOf(level) + ", " + sizeText(view),
                           {id.rfind("shadows.", 0) == 0, true}, "A map's side, in texels.");
    }
  return body;
}

/// Levels differ along the axis; the size of the picture does not.
std::string acrossLevels(const Context& context, const std::string& plot, const std::string& title,
                         Number Level::*property) {
  std::string body;
  std::map<std::pair<int, int>, Points> bySize;
  for (const Point* p : pointsOf(context.results, plot)) bySize[{p->width, p->height}].push_back(p);
  for (const auto& [size, points] : bySize) {
    std::vector<double> values;
    const auto curves = scalingCurves(
        context, points,
        [&](const Point& p) {
          if (p.knob && p.knob->value.number && shortId(p.knob->id) == plot) return p.knob->value.number;
          const Level* level = levelOf(context.results, p);
          return level ? level->*property : Number();
        },
        values);
    if (values.size() < 2) continue;
    body += scalingBlock(context, curves, axisFor(plot, values), title + ", " + sizeText(size.first, size.second),
                         {true, false},
                         "Levels: " + levelsOf(points) + "; they may differ in more than their " + plot + ".");
  }
  return body;
}

}  // namespace

std::string scalingChapter(const Context& context) {
  std::string body;
  for (const Level& level : context.results.levels) body += resolutions(context, level);
  for (const Level& level : context.results.levels) body += maps(context, level);
  body += acrossLevels(context, "lights", "Lights", &Level::lights);
  body += acrossLevels(context, "triangles", "Triangles", &Level::triangles);
  if (body.empty()) return {};
  Markup m;
  m.element("h2", "Scaling", {{"id", "scaling"}});
  m.element("p", "Time against what scene and user give; bars: quartiles.");
  return m.take() + body;
}

}  // namespace tyndall::bench::report
