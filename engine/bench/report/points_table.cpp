// Every point with all its figures in one sortable table; what failed, and why.
#include <algorithm>

#include "chapters.hpp"
#include "markup.hpp"
#include "text.hpp"

namespace tyndall::bench::report {
namespace {

void number(Markup& m, const Number& value) {
  if (value)
    m.element("td", figure(*value), {{"class", "number"}, {"data-v", exact(*value)}});
  else
    m.element("td", "–", {{"class", "none"}});
}

void times(Markup& m, const std::optional<Spread>& s) {
  number(m, s ? Number(s->median) : Number());
  number(m, s ? s->low : Number());
  number(m, s ? s->high : Number());
}

std::string settingsText(const Settings& settings) {
  std::string text;
  for (const auto& [id, value] : settings) text += (text.empty() ? "" : ", ") + id + "=" + value.text;
  return text;
}

Number nrmse(const std::optional<Region>& r) { return r ? Number(r->nrmse) : Number(); }

Number floorShare(const Results& results, const Point& p) {
  if (!results.copyGbS || !(*results.copyGbS > 0) || !p.floorBytes || !p.volumetrics || !(p.volumetrics->median > 0))
    return {};
  return 100 * *p.floorBytes / (*results.copyGbS * 1e6) / p.volumetrics->median;
}

void row(Markup& m, const Context& context, const Point& p) {
  m.open("tr")
      .element("td", p.level)
      .element("td", std::to_string(p.camera))
      .element("td", sizeText(p.width, p.height), {{"data-v", coordinate(1.0 * p.width * p.height)}});
  m.element("td", p.series).element("td", p.label);
  times(m, p.volumetrics);
  number(m, p.volumetrics ? p.volumetrics->n : Number());
  number(m, p.shadow ? Number(p.shadow->median) : Number());
  number(m, p.frame ? Number(p.frame->median) : Number());
  const auto& all = p.truth.all;
  number(m, nrmse(all));
  number(m, all ? all->p99 : Number());
  number(m, all ? all->maximum : Number());
  number(m, all ? all->bias : Number());
  number(m, nrmse(p.truth.silhouettes));
  number(m, nrmse(p.truth.interior));
  number(m, nrmse(p.truth.light));
  number(m, nrmse(p.march.all));
  number(m, p.temporal ? p.temporal->nrmseMean : Number());
  number(m, p.temporal ? p.temporal->flicker : Number());
  number(m, p.memoryBytes ? Number(*p.memoryBytes / 1e6) : Number());
  number(m, floorShare(context.results, p));
  m.element("td", p.technique).element("td", list(p.plots)).element("td", settingsText(p.settings)).close();
}

}  // namespace

std::string pointsChapter(const Context& context) {
  const auto& points = context.results.points;
  const auto failed = static_cast<std::size_t>(
      std::count_if(points.begin(), points.end(), [](const Point& p) { return p.failed.has_value(); }));
  Markup m;
  if (failed > 0) {
    m.element("h2", "Failed points", {{"id", "failed"}});
    m.element("p", std::to_string(failed) + " of " + std::to_string(points.size()) +
                       " points have no figures. They are in no plot above.");
    m.open("div", {{"class", "scroll"}}).open("table", {{"class", "sortable"}}).open("thead").open("tr");
    for (const char* head : {"level", "camera", "size", "point", "settings", "reason"})
      m.element("th", head, {{"scope", "col"}});
    m.close().close().open("tbody");
    for (const Point& p : points)
      if (p.failed)
        m.open("tr")
            .element("td", p.level)
            .element("td", std::to_string(p.camera))
            .element("td", sizeText(p.width, p.height))
            .element("td", nameOf(p))
            .element("td", settingsText(p.settings))
            .element("td", p.failed->empty() ? "no reason given" : *p.failed)
            .close();
    m.close().close().close();
  }
  m.element("h2", "All points", {{"id", "points"}});
  if (points.size() == failed) {
    m.element("p", points.empty() ? "The file has no points." : "No point has figures.");
    return m.take();
  }
  m.element("p",
            "Errors are over the mean of the reference; times in ms; memory in 10⁶ bytes. A click on a column's head "
            "sorts by it.");
  m.open("div", {{"class", "scroll tall"}}).open("table", {{"class", "sortable points"}}).open("thead").open("tr");
  for (const char* head : {"level",    "camera",      "size",           "series",
                           "label",    "volumetrics", "lower quartile", "upper quartile",
                           "n",        "shadow maps", "frame",          "nRMSE, truth",
                           "p99",      "largest",     "bias",           "silhouettes",
                           "interior", "light",       "nRMSE, march",   "nRMSE in motion",
                           "flicker",  "memory",      "floor, %",       "technique",
                           "plots",    "settings"})
    m.element("th", head, {{"scope", "col"}});
  m.close().close().open("tbody");
  for (const Point& p : points)
    if (!p.failed) row(m, context, p);
  m.close().close().close();
  m.open("p")
      .text("The same figures, and the passes, lie in the results.json this page was made from. As CSV, for example:")
      .close();
  m.element("pre",
            "jq -r '.points[] | [.key, .level, .series, .label, .volumetrics_ms.median, .error.truth.all.nrmse] | "
            "@csv' results.json");
  return m.take();
}

}  // namespace tyndall::bench::report
