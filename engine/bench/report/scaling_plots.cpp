#include "scaling_plots.hpp"

#include <algorithm>
#include <cmath>

#include "chapters.hpp"
#include "line_plot.hpp"
#include "markup.hpp"
#include "text.hpp"

namespace tyndall::bench::report {
namespace {

enum class Shows { kVolumetrics, kShadow, kError };

std::string labelOf(Shows what, Reference reference) {
  switch (what) {
    case Shows::kVolumetrics: return "volumetrics, ms";
    case Shows::kShadow: return "engine's shadow maps, ms";
    case Shows::kError: break;
  }
  return "nRMSE against the " + std::string(referenceName(reference));
}

std::string panel(const Context& context, const std::vector<ScalingCurve>& curves, const Axis& x, Shows what) {
  Points all;
  for (const ScalingCurve& c : curves)
    for (const auto& entry : c.points) all.push_back(entry.second);
  const Reference reference = referenceOf(all);
  LinePlot plot;
  plot.x = x;
  plot.y = {labelOf(what, reference), Scale::kLog};
  plot.title = plot.y.label + " against " + x.label;
  for (const ScalingCurve& c : curves) {
    Line line = {c.series, context.styles.of(c.series), {}, x.scale != Scale::kCategory};
    for (const auto& [px, p] : c.points) {
      const auto& time = what == Shows::kShadow ? p->shadow : p->volumetrics;
      const std::string tip =
          tipOf(*p, reference) + "\n" + x.label + (x.scale == Scale::kCategory ? "" : ": " + whole(px));
      if (what == Shows::kError) {
        if (const Number e = errorOf(*p, reference)) line.marks.push_back({px, *e, {}, {}, tip, ""});
      } else if (time) {
        line.marks.push_back({px, time->median, time->low, time->high, tip, ""});
      }
    }
    plot.lines.push_back(std::move(line));
  }
  return svg(plot);
}

/// The exponents of the plugin's times in words, "" where no curve has one.
std::string exponents(const std::vector<ScalingCurve>& curves) {
  std::vector<std::string> found;
  for (const ScalingCurve& c : curves) {
    std::vector<std::pair<double, double>> times;
    for (const auto& [x, p] : c.points)
      if (const Number t = timeOf(*p)) times.emplace_back(x, *t);
    if (const Number e = powerLawExponent(times))
      found.push_back(c.series + " " + (std::abs(*e) < 0.005 ? "0" : figure(*e, 2)));
  }
  return found.empty() ? ""
                       : " Slope of the times in logarithms, least squares (1: proportional): " + list(found) + ".";
}

}  // namespace

std::vector<ScalingCurve> scalingCurves(const Context& context, const Points& points,
                                        const std::function<Number(const Point&)>& x, std::vector<double>& values) {
  std::vector<ScalingCurve> curves;
  for (const auto& [series, own] : bySeries(points, context.styles)) {
    ScalingCurve c = {series, {}};
    for (const Point* p : own)
      if (const Number v = x(*p)) c.points.emplace_back(*v, p), values.push_back(*v);
    std::stable_sort(c.points.begin(), c.points.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    if (!c.points.empty()) curves.push_back(std::move(c));
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return curves;
}

Number powerLawExponent(const std::vector<std::pair<double, double>>& points) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, least = 0, greatest = 0;
  for (const auto& [x, y] : points) {
    if (!(x > 0) || !(y > 0)) continue;
    const double lx = std::log(x), ly = std::log(y);
    least = n == 0 ? lx : std::min(least, lx);
    greatest = n == 0 ? lx : std::max(greatest, lx);
    ++n, sx += lx, sy += ly, sxx += lx * lx, sxy += lx * ly;
  }
  const double spread = n * sxx - sx * sx;
  if (n < 3 || greatest - least < std::log(1.5) || !(spread > 0)) return {};
  return (n * sxy - sx * sy) / spread;
}

std::string scalingBlock(const Context& context, const std::vector<ScalingCurve>& curves, const Axis& axis,
                         const std::string& title, Panels panels, const std::string& where) {
  std::vector<Shows> wanted = {Shows::kVolumetrics};
  if (panels.shadow) wanted.push_back(Shows::kShadow);
  if (panels.error) wanted.push_back(Shows::kError);
  std::vector<std::string> plots, series;
  for (const Shows what : wanted)
    if (std::string drawn = panel(context, curves, axis, what); !drawn.empty()) plots.push_back(std::move(drawn));
  if (plots.empty()) return {};
  for (const ScalingCurve& c : curves) series.push_back(c.series);
  const std::string slopes = axis.scale == Scale::kCategory ? "" : exponents(curves);
  Markup m;
  m.element("h3", title);
  return m.take() + figureBlock(plots, legend(series, context.styles), where + slopes);
}

}  // namespace tyndall::bench::report
