// Where the time goes and where the error lies, for one point of each series at about the same error.
#include <algorithm>
#include <cmath>
#include <map>

#include "chapters.hpp"
#include "markup.hpp"
#include "row_chart.hpp"
#include "text.hpp"

namespace tyndall::bench::report {
namespace {

/// The error of the 1-2-5 series at which most series have a point on their curve; of several the least.
Number commonError(const Context& context, const Points& points, Reference reference) {
  Number best;
  int most = 0;
  const auto series = bySeries(points, context.styles);
  for (int decade = -6; decade <= 2; ++decade)
    for (const int s : {1, 2, 5}) {
      const double error = s * std::pow(10.0, decade);
      int reached = 0;
      for (const auto& [name, own] : series) reached += costAtError(costErrors(own, reference), error).has_value();
      if (reached > most) most = reached, best = error;
    }
  return best;
}

/// For each series its point whose error is nearest to `error` (in ratio).
Points nearest(const Context& context, const Points& points, Reference reference, double error) {
  Points chosen;
  for (const auto& [name, own] : bySeries(points, context.styles)) {
    const Point* best = nullptr;
    double least = 0;
    for (const Point* p : own) {
      const Number e = errorOf(*p, reference);
      if (!e || !(*e > 0)) continue;
      const double distance = std::abs(std::log(*e / error));
      if (!best || distance < least) best = p, least = distance;
    }
    if (best) chosen.push_back(best);
  }
  return chosen;
}

std::string noteOf(const Point& p, Reference reference) {
  return (p.volumetrics ? figure(p.volumetrics->median) + " ms, " : "") + "nRMSE " + figure(*errorOf(p, reference));
}

/// Fills for the passes: the ones that take most of some point's time get their own, by first appearance; the rest
/// share the last one.
std::map<std::string, int> fillsOf(const Points& chosen, std::vector<std::pair<int, std::string>>& legend) {
  std::vector<std::pair<std::string, double>> passes;
  for (const Point* p : chosen) {
    double sum = 0;
    for (const Pass& pass : p->passes) sum += pass.owner == "engine" ? 0 : pass.ms;
    for (const Pass& pass : p->passes) {
      if (pass.owner == "engine" || !(sum > 0)) continue;
      auto found = std::find_if(passes.begin(), passes.end(), [&](const auto& q) { return q.first == pass.name; });
      if (found == passes.end()) found = passes.insert(passes.end(), {pass.name, 0});
      found->second = std::max(found->second, pass.ms / sum);
    }
  }
  auto ranked = passes;
  std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  const auto own = static_cast<std::size_t>(passes.size() > kFills ? kFills - 1 : kFills);
  if (ranked.size() > own) ranked.resize(own);
  std::map<std::string, int> fills;
  for (const auto& [name, share] : passes) {
    const bool ofItsOwn = std::any_of(ranked.begin(), ranked.end(), [&](const auto& r) { return r.first == name; });
    const int fill = ofItsOwn ? static_cast<int>(legend.size()) : kFills - 1;
    fills[name] = fill;
    if (ofItsOwn) legend.emplace_back(fill, name);
  }
  if (passes.size() > own) legend.emplace_back(kFills - 1, "further passes");
  return fills;
}

std::string stages(const Points& chosen, Reference reference) {
  std::vector<std::pair<int, std::string>> legend;
  const auto fills = fillsOf(chosen, legend);
  RowChart chart;
  chart.title = "Time of each pass";
  chart.x = {"ms of each of the plugin's passes (medians, so that they need not add up to the median of the whole)",
             Scale::kLinear, true};
  chart.noteWidth = 160;
  for (const Point* p : chosen) {
    Row row = {nameOf(*p), noteOf(*p, reference), {}, {}};
    for (const Pass& pass : p->passes) {
      if (pass.owner == "engine" || !fills.count(pass.name)) continue;
      const std::string share = p->volumetrics && p->volumetrics->median > 0
                                    ? ", " + percent(pass.ms / p->volumetrics->median) + " of the plugin's time"
                                    : "";
      row.segments.push_back({pass.ms, fills.at(pass.name), pass.name,
                              nameOf(*p) + "\n" + pass.name + ": " + figure(pass.ms) + " ms" + share});
    }
    chart.rows.push_back(std::move(row));
  }
  const std::string plot = svg(chart);
  return plot.empty() ? "" : figureBlock({plot}, fillLegend(legend), "Stages of the plugin, engine passes left out.");
}

std::string floors(const Context& context, const Points& chosen, Reference reference) {
  const Number copy = context.results.copyGbS;
  if (!copy || !(*copy > 0)) return {};
  RowChart chart;
  chart.title = "Share of the bandwidth floor";
  chart.x = {"bandwidth floor / time, percent (100: as fast as memory is copied)", Scale::kLinear, true};
  chart.noteWidth = 230;
  for (const Point* p : chosen) {
    if (!p->floorBytes || !p->volumetrics || !(p->volumetrics->median > 0)) continue;
    const double ms = *p->floorBytes / (*copy * 1e9) * 1e3, share = ms / p->volumetrics->median;
    chart.rows.push_back({nameOf(*p),
                          percent(share) + " (" + figure(ms) + " of " + figure(p->volumetrics->median) + " ms)",
                          {{100 * share, 0, "",
                            nameOf(*p) + "\n" + bytes(*p->floorBytes) + " a frame at " + figure(*copy) +
                                " GB/s: " + figure(ms) + " ms\n" + noteOf(*p, reference)}},
                          {}});
  }
  const std::string plot = svg(chart);
  return plot.empty() ? ""
                      : figureBlock({plot}, "",
                                    "Every part of the plugin's images, and of the picture, that a pass is bound to, "
                                    "moved once a pass: these bytes over the "
                                    "bandwidth of a copy measured on the device (" +
                                        figure(*copy) +
                                        " GB/s, read and written), as a share of the time. What is read of the "
                                        "engine's maps is not counted. Over 100 percent: "
                                        "caches served a part, or a pass read a part of an image only. Small shares: "
                                        "arithmetic or scattered reads bind.");
}

std::string parts(const Points& chosen, Reference reference) {
  struct Part {
    const char* name;
    std::optional<Region> Split::*region;
    Style style;
  };
  const std::vector<Part> kParts = {{"all pixels", &Split::all, {1, 1, 0}},
                                    {"silhouettes", &Split::silhouettes, {5, 2, 0}},
                                    {"interior", &Split::interior, {2, 0, 0}},
                                    {"light", &Split::light, {6, 8, 0}}};
  RowChart chart;
  chart.title = "Error by kind of pixel";
  chart.x = {"nRMSE against the " + std::string(referenceName(reference)) +
                 " (each over the mean of the reference over all pixels)",
             Scale::kLog,
             false,
             {},
             false};
  Markup table;
  table.open("div", {{"class", "scroll"}})
      .open("table")
      .element("caption", "Share of the squared error, and of the pixels")
      .open("thead")
      .open("tr")
      .element("th", "point", {{"scope", "col"}});
  for (std::size_t k = 1; k < kParts.size(); ++k) table.element("th", kParts[k].name, {{"scope", "col"}});
  table.close().close().open("tbody");
  bool shares = false;
  for (const Point* p : chosen) {
    const Split& s = split(*p, reference);
    Row row = {nameOf(*p), "", {}, {}};
    double squares = 0, pixels = 0;
    for (std::size_t k = 0; k < kParts.size(); ++k) {
      const auto& region = s.*(kParts[k].region);
      if (!region) continue;
      row.dots.push_back({region->nrmse, kParts[k].style,
                          nameOf(*p) + "\n" + kParts[k].name + ": nRMSE " + figure(region->nrmse) +
                              (region->p99 ? ", p99 " + figure(*region->p99) : "") +
                              (region->bias ? ", bias " + figure(*region->bias) : "") +
                              (region->pixels ? ", " + whole(*region->pixels) + " pixels" : "")});
      if (k > 0 && region->pixels)
        squares += region->nrmse * region->nrmse * *region->pixels, pixels += *region->pixels;
    }
    if (row.dots.size() > 1) chart.rows.push_back(row);
    if (!(squares > 0)) continue;
    shares = true;
    table.open("tr").element("th", nameOf(*p), {{"scope", "row"}});
    for (std::size_t k = 1; k < kParts.size(); ++k) {
      const auto& region = s.*(kParts[k].region);
      if (region && region->pixels)
        table.open("td", {{"class", "number"}})
            .text(percent(region->nrmse * region->nrmse * *region->pixels / squares) + " ")
            .element("small", "of " + percent(*region->pixels / pixels))
            .close();
      else
        table.element("td", "–", {{"class", "none"}});
    }
    table.close();
  }
  table.close().close().close();
  const std::string plot = svg(chart);
  if (plot.empty()) return {};
  std::vector<std::pair<Style, std::string>> legend;
  for (const Part& part : kParts)
    if (std::any_of(chosen.begin(), chosen.end(),
                    [&](const Point* p) { return (split(*p, reference).*(part.region)).has_value(); }))
      legend.emplace_back(part.style, part.name);
  return figureBlock({plot}, markerLegend(legend),
                     "Silhouettes: a relative step of depth over 5 % among a pixel's neighbours, or picture and truth "
                     "end on different surfaces. "
                     "Light: within 16 pixels of a light's image. Interior: the rest.") +
         (shares ? table.take() : "");
}

}  // namespace

std::string breakdownPart(const Context& context, const Points& points, Reference reference) {
  const Number error = commonError(context, points, reference);
  if (!error) return {};
  const Points chosen = nearest(context, points, reference, *error);
  const std::string body = stages(chosen, reference) + floors(context, chosen, reference) + parts(chosen, reference);
  if (body.empty()) return {};
  Markup m;
  m.element("h3", "Where time and error go");
  m.element("p", "One point of each series: the one whose error is nearest to nRMSE " + figure(*error) +
                     ", the error (of 1, 2, 5 times a power of ten) that most curves pass.");
  return m.take() + body;
}

}  // namespace tyndall::bench::report
