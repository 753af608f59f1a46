// Tables at equal error and at equal time.
#include <algorithm>
#include <cmath>

#include "chapters.hpp"
#include "markup.hpp"
#include "text.hpp"

namespace tyndall::bench::report {
namespace {

/// 1, 2, 5 times powers of ten within [low, high], or of ten only where that makes more than 12.
std::vector<double> ladder(double low, double high) {
  for (const std::vector<int>& steps : {std::vector<int>{1, 2, 5}, std::vector<int>{1}}) {
    std::vector<double> rungs;
    for (int decade = static_cast<int>(std::floor(std::log10(low))); decade <= std::log10(high); ++decade)
      for (const int s : steps)
        if (const double v = s * std::pow(10.0, decade); v >= low && v <= high) rungs.push_back(v);
    if (rungs.size() <= 12 || steps.size() == 1) return rungs;
  }
  return {};
}

struct Curve {
  std::string name;
  Style style;
  std::vector<CostError> front;
};

void cell(Markup& m, const std::optional<double>& value, const std::optional<double>& march,
          const std::optional<double>& bound, const char* unit) {
  if (value) {
    m.open("td", {{"class", "number"}}).text(figure(*value) + unit);
    if (march) m.text(" ").element("small", figure(*value / *march) + "×");
    m.close();
  } else if (bound) {
    m.element("td", "≤ " + figure(*bound) + unit + " †", {{"class", "number"}});
  } else {
    m.element("td", "not reached", {{"class", "none"}});
  }
}

}  // namespace

std::string equalTables(const Context& context, const Points& points, Reference reference) {
  std::vector<Curve> curves;
  Points marches;
  for (const auto& [series, own] : bySeries(points, context.styles)) {
    Curve c = {series, context.styles.of(series), frontCurve(costErrors(own, reference))};
    if (!c.front.empty()) curves.push_back(std::move(c));
    for (const Point* p : own)
      if (isBruteForce(p->technique)) marches.push_back(p);
  }
  if (curves.size() < 2) return {};
  const auto everything = frontCurve(costErrors(points, reference));
  const auto march = frontCurve(costErrors(marches, reference));
  double greatestError = 0, greatestCost = 0, leastError = everything.back().error, leastCost = everything.front().cost;
  for (const Curve& c : curves) {
    greatestError = std::max(greatestError, c.front.front().error);
    greatestCost = std::max(greatestCost, c.front.back().cost);
  }

  Markup m;
  const std::string note =
      std::string("Interpolated linearly in both logarithms along each series' own Pareto front; never extrapolated.") +
      (march.empty() ? "" : " Small: ratio to the plain march (the front of all its series) in the same column.") +
      " † the whole series has less error (takes less time) than the column says: its coarsest (slowest) point is an "
      "upper bound, and no ratio is formed.";
  const auto table = [&](const std::string& title, const std::vector<double>& columns, const std::string& head,
                         bool byError) {
    if (columns.empty()) return;
    m.open("div", {{"class", "scroll"}}).open("table", {{"class", "equal"}});
    m.element("caption", title).open("thead").open("tr").element("th", "series", {{"scope", "col"}});
    for (const double c : columns) m.element("th", head + figure(c, 2) + (byError ? "" : " ms"), {{"scope", "col"}});
    m.close().close().open("tbody");
    for (const Curve& c : curves) {
      m.open("tr").element("th", c.name, {{"scope", "row"}});
      for (const double at : columns) {
        if (byError) {
          const bool finer = c.front.front().error < at;  // its coarsest point has less error already
          cell(m, costAtError(c.front, at), costAtError(march, at), finer ? Number(c.front.front().cost) : Number(),
               " ms");
        } else {
          const bool sooner = c.front.back().cost < at;  // its slowest point takes less already
          cell(m, errorAtCost(c.front, at), errorAtCost(march, at), sooner ? Number(c.front.back().error) : Number(),
               "");
        }
      }
      m.close();
    }
    m.close().close().close();
  };
  table("Time at equal error", ladder(leastError, greatestError), "nRMSE ", true);
  table("nRMSE at equal time", ladder(leastCost, greatestCost), "", false);
  m.element("p", note, {{"class", "caption"}});
  return m.take();
}

}  // namespace tyndall::bench::report
