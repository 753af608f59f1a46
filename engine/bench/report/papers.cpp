// The papers' tables: their figure, ours beside it, and the ratio to brute force of both. The machines differ, so only
// the ratios can be held against each other.
#include <algorithm>
#include <map>

#include "chapters.hpp"
#include "markup.hpp"
#include "row_chart.hpp"
#include "text.hpp"

namespace tyndall::bench::report {
namespace {

const Style kTheirs = {1, 1, 0}, kOurs = {2, 0, 0};

void number(Markup& m, const Number& value, const std::string& unit = "") {
  if (value)
    m.element("td", figure(*value) + unit, {{"class", "number"}, {"data-v", exact(*value)}});
  else
    m.element("td", "–", {{"class", "none"}});
}

std::string table(const Context& context, const Points& points, const std::string& title) {
  std::map<std::string, const Point*> byKey;
  for (const Point& p : context.results.points) byKey[p.key] = &p;
  RowChart chart;
  chart.title = title + ": time over brute force's, the paper's and here";
  chart.x = {"time / time of brute force (left of 1: faster than brute force)", Scale::kLog};
  chart.rule = Rule{1, ""};
  Markup m;
  m.element("h3", title);
  m.open("div", {{"class", "scroll"}}).open("table", {{"class", "sortable"}}).open("thead").open("tr");
  for (const char* head : {"row", "view", "paper, ms", "here, ms", "quartiles", "nRMSE here", "paper / brute force",
                           "here / brute force", "ratio here / in the paper", "brute force here"})
    m.element("th", head, {{"scope", "col"}});
  m.close().close().open("tbody");
  for (const Point* p : points) {
    const Paper& paper = *p->paper;
    const auto found = byKey.find(paper.baselineKey);
    const Point* baseline = paper.baselineKey.empty() || found == byKey.end() ? nullptr : found->second;
    const Number time = timeOf(*p), brute = baseline ? timeOf(*baseline) : Number();
    const Number ours = time && brute && *brute > 0 ? Number(*time / *brute) : Number();
    const Number quotient =
        ours && paper.figureRatio && *paper.figureRatio > 0 ? Number(*ours / *paper.figureRatio) : Number();
    m.open("tr").element("th", paper.row.empty() ? nameOf(*p) : paper.row, {{"scope", "row"}});
    m.element("td", p->level + " " + std::to_string(p->camera) + ", " + sizeText(viewOf(*p)));
    number(m, paper.figureMs);
    if (p->failed)
      m.element("td", "failed: " + *p->failed, {{"class", "none"}});
    else
      number(m, time);
    const bool quartiles = p->volumetrics && p->volumetrics->low && p->volumetrics->high;
    m.element("td", quartiles ? figure(*p->volumetrics->low) + " to " + figure(*p->volumetrics->high) : "–",
              {{"class", quartiles ? "number" : "none"}});
    number(m, errorOf(*p, referenceOf({p})));
    number(m, paper.figureRatio);
    number(m, ours);
    number(m, quotient);
    m.element("td",
              baseline                    ? nameOf(*baseline)
              : paper.baselineKey.empty() ? "–"
                                          : "not in this file",
              {{"class", baseline ? "" : "none"}});
    m.close();
    Row row = {paper.row.empty() ? nameOf(*p) : paper.row, "", {}, {}};
    if (paper.figureRatio)
      row.dots.push_back({*paper.figureRatio, kTheirs, "the paper: " + figure(*paper.figureRatio) + " of brute force"});
    if (ours)
      row.dots.push_back({*ours, kOurs, "here: " + figure(*ours) + " of brute force\n" + tipOf(*p, referenceOf({p}))});
    if (!row.dots.empty()) chart.rows.push_back(std::move(row));
  }
  m.close().close().close();
  const std::string plot = svg(chart);
  if (plot.empty()) return m.take();
  return m.take() + figureBlock({plot}, markerLegend({{kTheirs, "the paper"}, {kOurs, "here"}}), "");
}

}  // namespace

std::string papersChapter(const Context& context) {
  std::vector<std::pair<std::string, Points>> tables;
  for (const Point& p : context.results.points) {
    if (!p.paper) continue;
    const std::string title = p.paper->paper + (p.paper->table.empty() ? "" : ", " + p.paper->table);
    auto found = std::find_if(tables.begin(), tables.end(), [&](const auto& t) { return t.first == title; });
    if (found == tables.end()) found = tables.insert(tables.end(), {title, {}});
    found->second.push_back(&p);
  }
  if (tables.empty()) return {};
  Markup m;
  m.element("h2", "The papers' tables", {{"id", "papers"}});
  m.element("p",
            "The papers measured on other devices and other scenes, so their milliseconds stand here for orientation "
            "only. What can be compared is each time over "
            "that of brute force on the same machine. A last ratio above 1 means that the technique gains less here "
            "than in its paper.");
  for (const auto& [title, points] : tables) m.raw(table(context, points, title));
  return m.take();
}

}  // namespace tyndall::bench::report
