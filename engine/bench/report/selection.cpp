#include "selection.hpp"

#include <algorithm>

#include "text.hpp"

namespace tyndall::bench::report {
namespace {

std::string spreadText(const Spread& s) {
  std::string text = figure(s.median) + " ms";
  if (s.low && s.high)
    text += " (quartiles " + figure(*s.low) + " to " + figure(*s.high) + (s.n ? ", n = " + whole(*s.n) : "") + ")";
  return text;
}

bool commonKnob(const Points& points) {
  return std::all_of(points.begin(), points.end(), [&](const Point* p) {
    return p->knob && p->knob->value.number && p->knob->id == points.front()->knob->id;
  });
}

}  // namespace

View viewOf(const Point& p) { return {p.level, p.camera, p.seconds, p.width, p.height}; }

std::string sizeText(int width, int height) {
  return width > 0 && height > 0 ? std::to_string(width) + "×" + std::to_string(height) : "size not given";
}

std::string sizeText(const View& v) {
  return sizeText(v.width, v.height) + (v.seconds && *v.seconds != 0 ? ", at " + figure(*v.seconds) + " s" : "");
}

std::string nameOf(const Point& p) { return p.label.empty() ? p.series : p.series + ", " + p.label; }

Points pointsOf(const Results& results, const std::string& plot) {
  Points points;
  for (const Point& p : results.points)
    if (!p.failed && p.in(plot)) points.push_back(&p);
  return points;
}

std::vector<std::pair<View, Points>> byView(const Points& points) {
  std::vector<std::pair<View, Points>> views;
  for (const Point* p : points) {
    const View view = viewOf(*p);
    auto found = std::find_if(views.begin(), views.end(), [&](const auto& v) { return v.first == view; });
    if (found == views.end()) found = views.insert(views.end(), {view, {}});
    found->second.push_back(p);
  }
  return views;
}

std::vector<std::pair<std::string, Points>> bySeries(const Points& points, const Styles& styles) {
  std::vector<std::pair<std::string, Points>> all;
  for (const std::string& series : styles.series()) {
    Points own;
    for (const Point* p : points)
      if (p->series == series) own.push_back(p);
    if (own.empty()) continue;
    const bool knob = commonKnob(own);
    std::stable_sort(own.begin(), own.end(), [&](const Point* a, const Point* b) {
      return knob ? *a->knob->value.number < *b->knob->value.number : timeOf(*a).value_or(0) < timeOf(*b).value_or(0);
    });
    all.emplace_back(series, std::move(own));
  }
  return all;
}

Points inLevel(const Points& points, const Level& level) {
  Points own;
  for (const Point* p : points)
    if (p->level == level.name && p->camera == level.camera) own.push_back(p);
  return own;
}

Reference referenceOf(const Points& points) {
  const bool truth = std::any_of(points.begin(), points.end(), [](const Point* p) { return p->truth.all.has_value(); });
  const bool march = std::any_of(points.begin(), points.end(), [](const Point* p) { return p->march.all.has_value(); });
  return march && !truth ? Reference::kMarch : Reference::kTruth;
}

const char* referenceName(Reference r) { return r == Reference::kTruth ? "ray-traced truth" : "converged march"; }

const Split& split(const Point& p, Reference r) { return r == Reference::kTruth ? p.truth : p.march; }

Number errorOf(const Point& p, Reference r) {
  const auto& all = split(p, r).all;
  return all ? Number(all->nrmse) : Number();
}

Number timeOf(const Point& p) { return p.volumetrics ? Number(p.volumetrics->median) : Number(); }

Points measuredOf(const Points& points, Reference reference) {
  Points measured;
  for (const Point* p : points)
    if (timeOf(*p) && errorOf(*p, reference)) measured.push_back(p);
  return measured;
}

std::vector<CostError> costErrors(const Points& points, Reference reference, Points* which) {
  std::vector<CostError> all;
  for (const Point* p : measuredOf(points, reference)) {
    if (*errorOf(*p, reference) >= kBlack) continue;
    all.push_back({*timeOf(*p), *errorOf(*p, reference)});
    if (which) which->push_back(p);
  }
  return all;
}

std::string tipOf(const Point& p, Reference reference) {
  std::string text = nameOf(p) + "\n" + p.level + ", camera " + std::to_string(p.camera) + ", " + sizeText(viewOf(p));
  if (const auto& all = split(p, reference).all) {
    text += "\nnRMSE " + figure(all->nrmse) + " against the " + referenceName(reference);
    if (all->p99) text += ", p99 " + figure(*all->p99);
    if (all->maximum) text += ", largest " + figure(*all->maximum);
    if (all->bias) text += ", bias " + figure(*all->bias);
  }
  if (p.volumetrics) text += "\nvolumetrics " + spreadText(*p.volumetrics);
  if (p.shadow) text += "\nshadow maps " + spreadText(*p.shadow);
  if (p.frame) text += "\nframe " + spreadText(*p.frame);
  if (p.memoryBytes) text += "\nmemory " + bytes(*p.memoryBytes);
  if (p.temporal && p.temporal->flicker) text += "\nflicker " + figure(*p.temporal->flicker);
  for (const auto& [id, value] : p.settings) text += "\n" + id + " = " + value.text;
  return text;
}

double noise(const Points& points) {
  double worst = 0;
  for (const Point* p : points) {
    if (!p->volumetrics || !(p->volumetrics->median > 0)) continue;
    const Spread& s = *p->volumetrics;
    worst = std::max(
        {worst, (s.high.value_or(s.median) - s.median) / s.median, (s.median - s.low.value_or(s.median)) / s.median});
  }
  return worst;
}

}  // namespace tyndall::bench::report
