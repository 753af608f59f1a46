// Error and time against each knob.
#include <algorithm>
#include <set>

#include "chapters.hpp"
#include "knob_axis.hpp"
#include "line_plot.hpp"
#include "markup.hpp"
#include "text.hpp"

namespace tyndall::bench::report {
namespace {

enum class Shows { kError, kTime };

/// Every series a curve over the knob; `shown` receives those that have a mark.
std::string knobPlot(const Context& context, const KnobAxis& axis, const Points& points, Shows what,
                     std::set<std::string>& shown) {
  const Reference reference = referenceOf(points);
  LinePlot plot;
  plot.x = axis.axis();
  plot.y = {what == Shows::kTime ? "volumetrics, ms" : "nRMSE against the " + std::string(referenceName(reference)),
            Scale::kLog};
  plot.title = plot.y.label + " against " + plot.x.label;
  for (const auto& [series, own] : bySeries(points, context.styles)) {
    Line line = {series, context.styles.of(series), {}, plot.x.scale != Scale::kCategory};
    for (const Point* p : own) {
      const Number x = axis.position(*p), y = what == Shows::kTime ? timeOf(*p) : errorOf(*p, reference);
      if (!x || !y) continue;
      Mark mark = {*x, *y, {}, {}, tipOf(*p, reference) + "\n" + p->knob->id + " = " + p->knob->value.text, ""};
      if (what == Shows::kTime) mark.yLow = p->volumetrics->low, mark.yHigh = p->volumetrics->high;
      line.marks.push_back(std::move(mark));
    }
    if (!line.marks.empty()) shown.insert(series);
    plot.lines.push_back(std::move(line));
  }
  return svg(plot);
}

/// Both plots of one knob on one view; "" where it has a single value, as that shows nothing.
std::string knobBlock(const Context& context, const std::string& id, const View& view, const Points& points) {
  const KnobAxis axis(id, points);
  if (axis.values() < 2) return {};
  std::set<std::string> shown;
  std::vector<std::string> plots;
  for (const Shows what : {Shows::kError, Shows::kTime})
    if (std::string drawn = knobPlot(context, axis, points, what, shown); !drawn.empty())
      plots.push_back(std::move(drawn));
  if (plots.empty()) return {};
  Markup m;
  m.element("h4", id + ", " + sizeText(view));
  return m.take() + figureBlock(plots, legend(context.styles.inOrder(shown), context.styles), "");
}

}  // namespace

std::string knobsPart(const Context& context, const Points& points) {
  std::vector<std::pair<std::string, Points>> knobs;
  for (const Point* p : points) {
    if (!p->knob) continue;
    auto found = std::find_if(knobs.begin(), knobs.end(), [&](const auto& k) { return k.first == p->knob->id; });
    if (found == knobs.end()) found = knobs.insert(knobs.end(), {p->knob->id, {}});
    found->second.push_back(p);
  }
  std::string body;
  for (const auto& [id, own] : knobs)
    for (const auto& [view, members] : byView(own)) body += knobBlock(context, id, view, members);
  if (body.empty()) return {};
  Markup m;
  m.element("h3", "Error and time against each knob");
  return m.take() + body;
}

}  // namespace tyndall::bench::report
