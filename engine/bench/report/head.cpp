// The page's head: what was measured, on what, how to do it again, and what to mind when reading it.
#include <algorithm>
#include <map>
#include <set>

#include "chapters.hpp"
#include "markup.hpp"
#include "text.hpp"

namespace tyndall::bench::report {
namespace {

std::string commandOf(const Results& r) {
  if (!r.command.empty()) return r.command;
  std::string text = "tyndall bench";
  std::set<std::string> seen;
  for (const Level& l : r.levels)
    if (!l.name.empty() && seen.insert(l.name).second) text += " " + l.name;
  if (!r.sweep.empty()) text += " --sweep " + r.sweep;
  return text + " --out DIR";
}

void facts(Markup& m, const Results& r) {
  std::map<std::string, std::size_t> sizes;
  for (const Point& p : r.points)
    if (p.width > 0) ++sizes[sizeText(p.width, p.height)];
  std::vector<std::string> sizeList;
  for (const auto& [size, count] : sizes) sizeList.push_back(size + " (" + std::to_string(count) + ")");
  m.open("dl");
  const auto fact = [&](const char* name, const std::string& value) {
    if (!value.empty()) m.element("dt", name).element("dd", value);
  };
  fact("Device", r.device);
  fact("Driver", r.driver);
  fact("Sweep", r.sweep);
  fact("Started", r.started);
  fact("Bandwidth of a copy", r.copyGbS ? figure(*r.copyGbS) + " GB/s, read and written" : "not measured");
  fact("Points", std::to_string(r.points.size()) + (sizeList.empty() ? "" : ", at " + list(sizeList)));
  m.element("dt", "Again by").open("dd").element("code", commandOf(r)).close();
  m.close();
  if (r.settings.empty()) return;
  m.open("details", {{"open", "open"}})
      .element("summary", "Settings that all points share")
      .open("ul", {{"class", "settings"}});
  for (const auto& [id, value] : r.settings) m.open("li").element("code", id + " = " + value.text).close();
  m.close().close();
}

void mind(Markup& m, const Results& r) {
  double worst = 0, n = 0;
  std::vector<double> spreads;
  for (const Point& p : r.points) {
    if (!p.volumetrics || !p.volumetrics->low || !p.volumetrics->high || !(p.volumetrics->median > 0)) continue;
    spreads.push_back((*p.volumetrics->high - *p.volumetrics->low) / p.volumetrics->median);
    worst = std::max(worst, spreads.back());
    if (p.volumetrics->n) n = n == 0 ? *p.volumetrics->n : std::min(n, *p.volumetrics->n);
  }
  m.element("h2", "To mind", {{"id", "mind"}}).open("ul");
  m.element("li",
            "Times are GPU times of the plugin's own passes. The engine's shadow maps, G-buffer and lighting are not "
            "in them; a table at the end has shadow maps and whole frame too.");
  if (!spreads.empty()) {
    std::nth_element(spreads.begin(), spreads.begin() + static_cast<std::ptrdiff_t>(spreads.size() / 2), spreads.end());
    m.element("li", "Noise: error bars are quartiles" +
                        (n > 0 ? " of " + whole(n) + " or more repetitions" : std::string()) +
                        "; from quartile to quartile they span " + percent(spreads[spreads.size() / 2]) +
                        " of the median at half of the points, " + percent(worst) +
                        " at the worst. Smaller differences mean nothing.");
  }
  m.element("li",
            "Errors are those of the in-scattered radiance, RMSE over the mean of the reference (nRMSE), at the size "
            "and on the camera named: other sizes and views have other errors. They do not vary from run to run. "
            "Points with an error of 1 or more, which a black picture has, are plotted, and count for no front and no "
            "comparison.");
  m.element("li",
            "The ray-traced truth is sampled and has an error of its own; the table below has its samples a view ray "
            "and light, and its difference from a truth with half of them. Errors near that are the truth's.");
  m.element("li",
            "Silhouettes hold errors that are no technique's: rasteriser and ray tracer may end a pixel's ray on "
            "different surfaces. The split of the error tells them apart.");
  m.close();
}

void levels(Markup& m, const Results& r, const Contents& contents) {
  if (r.levels.empty()) return;
  m.element("h2", "Levels", {{"id", "levels"}});
  m.open("div", {{"class", "scroll"}}).open("table", {{"class", "sortable"}}).open("thead").open("tr");
  for (const char* head : {"level", "camera", "triangles", "lights", "a light in view", "truth's samples",
                           "truth against half the samples, nRMSE", "points"})
    m.element("th", head, {{"scope", "col"}});
  m.close().close().open("tbody");
  const auto number = [&](const Number& v, bool count) {
    if (v)
      m.element("td", count ? whole(*v) : figure(*v), {{"class", "number"}, {"data-v", exact(*v)}});
    else
      m.element("td", "–", {{"class", "none"}});
  };
  for (const Level& l : r.levels) {
    m.open("tr").open("th", {{"scope", "row"}});
    const bool chapter =
        std::any_of(contents.begin(), contents.end(), [&](const auto& c) { return c.first == anchorOf(l); });
    if (chapter)
      m.element("a", l.name, {{"href", "#" + anchorOf(l)}});
    else
      m.text(l.name);
    m.close().element("td", std::to_string(l.camera), {{"class", "number"}});
    number(l.triangles, true);
    number(l.lights, true);
    m.element("td", l.lightInView ? (*l.lightInView ? "yes" : "no") : "–");
    number(l.truthSamples, true);
    number(l.truthSelfNrmse, false);
    number(
        static_cast<double>(std::count_if(r.points.begin(), r.points.end(),
                                          [&](const Point& p) { return p.level == l.name && p.camera == l.camera; })),
        true);
    m.close();
  }
  m.close().close().close();
}

}  // namespace

std::string headChapter(const Context& context, const Contents& contents) {
  Markup m;
  facts(m, context.results);
  mind(m, context.results);
  levels(m, context.results, contents);
  m.open("nav").open("ul");
  for (const auto& [anchor, title] : contents) m.open("li").element("a", title, {{"href", "#" + anchor}}).close();
  m.close().close();
  return m.take();
}

}  // namespace tyndall::bench::report
