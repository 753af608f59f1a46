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

using Get = Number (*)(const Point&, Reference);
Number timeValue(const Point& p, Reference) { return timeOf(p); }

}  // namespace

std::string knobsPart(const Context& context, const Points& points) {
  std::vector<std::string> ids;
  for (const Point* p : points)
    if (p->knob && std::find(ids.begin(), ids.end(), p->knob->id) == ids.end()) ids.push_back(p->knob->id);
  std::string body;
  for (const std::string& id : ids) {
    Points own;
    for (const Point* p : points)
      if (p->knob && p->knob->id == id) own.push_back(p);
    for (const auto& [view, members] : byView(own)) {
      const Reference reference = referenceOf(members);
      const KnobAxis axis(id, members);
      if (axis.values() < 2) continue;  // a curve of one value shows nothing
      std::set<std::string> shown;
      std::vector<std::string> plots;
      for (const auto& [label, get] :
           {std::pair<std::string, Get>{"nRMSE against the " + std::string(referenceName(reference)), &errorOf},
            {"volumetrics, ms", &timeValue}}) {
        LinePlot plot;
        plot.title = label + " against " + id;
        plot.x = axis.axis();
        plot.y = {label, Scale::kLog, false, {}, false};
        for (const auto& [series, line_points] : bySeries(members, context.styles)) {
          Line line = {series, context.styles.of(series), {}, axis.axis().scale != Scale::kCategory};
          for (const Point* p : line_points) {
            const Number x = axis.position(*p), y = get(*p, reference);
            if (!x || !y) continue;
            const bool time = get == &timeValue;
            line.marks.push_back({*x, *y, time ? p->volumetrics->low : Number(), time ? p->volumetrics->high : Number(),
                                  tipOf(*p, reference) + "\n" + id + " = " + p->knob->value.text, ""});
          }
          if (!line.marks.empty()) shown.insert(series);
          plot.lines.push_back(std::move(line));
        }
        if (std::string drawn = svg(plot); !drawn.empty()) plots.push_back(std::move(drawn));
      }
      if (plots.empty()) continue;
      Markup m;
      m.element("h4", id + ", " + sizeText(view));
      body += m.take() + figureBlock(plots, legend(context.styles.inOrder(shown), context.styles), "");
    }
  }
  if (body.empty()) return {};
  Markup m;
  m.element("h3", "Error and time against each knob");
  return m.take() + body;
}

}  // namespace tyndall::bench::report
