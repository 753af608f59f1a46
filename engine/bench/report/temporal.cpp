// Error and flicker along a moving path, against time.
#include <set>

#include "chapters.hpp"
#include "line_plot.hpp"
#include "markup.hpp"
#include "text.hpp"

namespace tyndall::bench::report {
namespace {

using Get = Number (*)(const Temporal&);
Number meanError(const Temporal& t) { return t.nrmseMean; }
Number flicker(const Temporal& t) { return t.flicker; }

/// Temporal figure against time, every series a curve.
std::string againstTime(const Context& context, const Points& points, const std::string& label, Get get,
                        std::set<std::string>& shown) {
  LinePlot plot;
  plot.title = label + " against time";
  plot.x = {label, Scale::kLog};
  plot.y = {"volumetrics, ms", Scale::kLog};
  for (const auto& [series, own] : bySeries(points, context.styles)) {
    Line line = {series, context.styles.of(series), {}, true};
    for (const Point* p : own) {
      const Number x = get(p->temporal.value_or(Temporal())), y = timeOf(*p);
      if (!x || !y) continue;
      line.marks.push_back({*x, *y, p->volumetrics->low, p->volumetrics->high,
                            tipOf(*p, referenceOf(points)) + "\n" + label + " " + figure(*x),
                            own.size() == 1 ? series : p->label});
    }
    if (!line.marks.empty()) shown.insert(series);
    plot.lines.push_back(std::move(line));
  }
  return svg(plot);
}

}  // namespace

std::string temporalPart(const Context& context, const Points& points) {
  std::string body;
  for (const auto& [view, members] : byView(points)) {
    std::set<std::string> shown;
    std::vector<std::string> plots;
    for (const auto& [label, get] :
         {std::pair<std::string, Get>{"mean nRMSE along the path", &meanError}, {"flicker", &flicker}})
      if (std::string drawn = againstTime(context, members, label, get, shown); !drawn.empty())
        plots.push_back(std::move(drawn));
    if (!plots.empty())
      body += figureBlock(plots, legend(context.styles.inOrder(shown), context.styles),
                          sizeText(view) +
                              ". Along a moving path: the mean of the frames' nRMSE; flicker: RMS over pixels and "
                              "frames of the change from frame to frame minus the reference's own change, "
                              "over the reference's mean. Lower left is better.");
  }
  if (body.empty()) return {};
  Markup m;
  m.element("h3", "In motion");
  return m.take() + body;
}

}  // namespace tyndall::bench::report
