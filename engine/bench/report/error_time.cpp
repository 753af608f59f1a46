// Run time against error: the plot that everything else explains.
#include <algorithm>
#include <set>

#include "chapters.hpp"
#include "line_plot.hpp"
#include "markup.hpp"
#include "sentences.hpp"
#include "text.hpp"

namespace tyndall::bench::report {
namespace {

std::string caption(const LinePlot& plot, std::size_t points, std::size_t without, std::size_t zero,
                    Reference reference) {
  std::string text = "The plugin's GPU time (median, bars: quartiles) against nRMSE over all pixels (" +
                     std::string(referenceName(reference)) +
                     "), both logarithmic; lower left is better. Grey staircase: the Pareto front of " +
                     std::to_string(points) + " " + plural(points, "point") +
                     "; the names are its points. The engine's shadow maps are not in these times.";
  if (plot.rule) text += " Dashed: how well the truth itself has converged.";
  if (without)
    text += " " + std::to_string(without) + " " + plural(without, "point") + " without a time or an error " +
            (without == 1 ? "is" : "are") + " left out.";
  if (zero) text += " " + std::to_string(zero) + " with a time or an error of 0 cannot be drawn on these axes.";
  return text;
}

/// The plot of points that have a positive time and error, with their front; `series` receives the curves' names.
LinePlot plotOf(const Context& context, const Level& level, const View& view, const Points& drawn, Reference reference,
                std::vector<std::string>& series) {
  LinePlot plot;
  plot.title =
      "Run time against error, " + level.name + " camera " + std::to_string(level.camera) + ", " + sizeText(view);
  if (reference == Reference::kMarch) plot.title += ", against the converged march";
  plot.x = {"nRMSE against the " + std::string(referenceName(reference)), Scale::kLog};
  plot.y = {"volumetrics, ms", Scale::kLog};
  plot.width = 860;
  plot.height = 520;
  if (reference == Reference::kTruth && level.truthSelfNrmse && *level.truthSelfNrmse > 0)
    plot.rule = Rule{*level.truthSelfNrmse, "truth's convergence"};
  Points better;
  const auto all = costErrors(drawn, reference, &better);
  std::set<const Point*> front;
  for (const std::size_t i : paretoFront(all)) {
    plot.front.emplace_back(all[i].error, all[i].cost);
    front.insert(better[i]);
  }
  for (const auto& [name, own] : bySeries(drawn, context.styles)) {
    Line line = {name, context.styles.of(name), {}, true};
    for (const Point* p : own)
      line.marks.push_back({*errorOf(*p, reference), *timeOf(*p), p->volumetrics->low, p->volumetrics->high,
                            tipOf(*p, reference), front.count(p) ? nameOf(*p) : ""});
    plot.lines.push_back(std::move(line));
    series.push_back(name);
  }
  return plot;
}

/// The plot, and in words what it shows; "" without a point that has both time and error.
std::string figureAndFindings(const Context& context, const Level& level, const View& view, const Points& points,
                              Reference reference) {
  const Points measured = measuredOf(points, reference);
  if (measured.empty()) return {};
  Points drawn;
  for (const Point* p : measured)
    if (*timeOf(*p) > 0 && *errorOf(*p, reference) > 0) drawn.push_back(p);
  std::vector<std::string> series;
  const LinePlot plot = plotOf(context, level, view, drawn, reference, series);
  Markup m;
  m.raw(figureBlock(
      {svg(plot)}, legend(series, context.styles),
      caption(plot, drawn.size(), points.size() - measured.size(), measured.size() - drawn.size(), reference)));
  m.open("ul", {{"class", "findings"}});
  for (const Finding& f : findings(context, level, points, reference))
    m.open("li").element("b", f.about + ":").text(" " + f.text).close();
  m.close();
  m.element("p",
            "exact and the plain march stand for the Pareto fronts of all series of their techniques (exact; "
            "ray_march), the others for themselves. Ratios are of times interpolated at equal error.",
            {{"class", "caption"}});
  return m.take();
}

}  // namespace

std::string errorTimePart(const Context& context, const Level& level, const View& view, const Points& points) {
  const Reference reference = referenceOf(points);
  const std::string main = figureAndFindings(context, level, view, points, reference);
  if (main.empty()) return {};
  const Points measured = measuredOf(points, reference);
  Markup m;
  m.raw(main).raw(equalTables(context, measured, reference));
  // Against the converged march, the error of the shadow map that both share drops out: what is left is the technique's
  // own.
  const std::string own =
      reference == Reference::kTruth ? figureAndFindings(context, level, view, points, Reference::kMarch) : "";
  if (!own.empty())
    m.open("details")
        .element("summary", "The same against the converged march, which shares the engine's shadow maps")
        .raw(own)
        .close();
  m.raw(breakdownPart(context, measured, reference));
  return m.take();
}

}  // namespace tyndall::bench::report
