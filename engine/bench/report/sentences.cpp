#include "sentences.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "text.hpp"

namespace tyndall::bench::report {
namespace {

std::string range(double a, double b, const std::string& unit = "") {
  const std::string x = figure(a), y = figure(b);
  return (x == y ? x : x + " to " + y) + unit;
}

/// Runs of the same series along the front, from the least error on.
std::string frontSentence(const Points& front, Reference reference) {
  std::vector<std::string> runs;
  for (auto p = front.rbegin(); p != front.rend();) {
    auto end = std::find_if(p, front.rend(), [&](const Point* q) { return q->series != (*p)->series; });
    std::vector<std::string> labels;
    for (auto q = p; q != end; ++q)
      if (!(*q)->label.empty()) labels.push_back((*q)->label);
    const Point &first = **p, &last = **(end - 1);
    runs.push_back(first.series + " at nRMSE " + range(*errorOf(first, reference), *errorOf(last, reference)) + ", " +
                   range(*timeOf(first), *timeOf(last), " ms") + (labels.empty() ? "" : " (" + list(labels) + ")"));
    p = end;
  }
  std::string text = "From the least error to the least time: ";
  for (std::size_t i = 0; i < runs.size(); ++i) text += (i ? "; " : "") + runs[i];
  return text + ".";
}

struct Side {
  std::string name;
  std::vector<CostError> curve;
};

std::string ends(const Side& a, const Side& b) {
  const double lowA = a.curve.back().error, lowB = b.curve.back().error;
  if (figure(lowA) == figure(lowB)) return "";
  const Side& finer = lowA < lowB ? a : b;
  const Side& other = lowA < lowB ? b : a;
  return other.name + " does not reach less than nRMSE " + figure(other.curve.back().error) + "; " + finer.name +
         " goes down to " + figure(finer.curve.back().error) + ", at " + figure(finer.curve.back().cost) + " ms.";
}

/// For curves that share no error: one has less error throughout; does it cost less too?
std::string apart(const Side& a, const Side& b) {
  const Side& finer = a.curve.back().error < b.curve.back().error ? a : b;
  const Side& coarser = &finer == &a ? b : a;
  const double cheapest = finer.curve.front().cost;
  const auto beaten =
      std::count_if(coarser.curve.begin(), coarser.curve.end(), [&](const CostError& c) { return cheapest < c.cost; });
  return "not reached, their errors do not overlap: every point of " + finer.name +
         " has less error, and its cheapest (" + figure(cheapest) + " ms) takes less time than " +
         std::to_string(beaten) + " of the " + std::to_string(coarser.curve.size()) + " on the front of " +
         coarser.name;
}

/// Where ours is cheaper at equal error, where the other is, and what only one of them reaches.
std::string duel(const Side& ours, const Side& other, double equal) {
  const auto stretches = compareAtEqualError(ours.curve, other.curve, equal);
  std::vector<std::string> parts;
  for (const Stretch& s : stretches) {
    const std::string at = s.from == s.to ? "at nRMSE " + figure(s.from) : "from nRMSE " + range(s.from, s.to);
    if (s.cheaper == Stretch::Cheaper::kEqual)
      parts.push_back(at + " they differ by no more than the quartiles, " + percent(equal - 1));
    else if (s.cheaper == Stretch::Cheaper::kFirst)
      parts.push_back(at + " " + ours.name + " is " + range(s.leastRatio, s.greatestRatio) + " times as fast");
    else
      parts.push_back(at + " " + other.name + " is " + range(1 / s.greatestRatio, 1 / s.leastRatio) + " times as fast");
  }
  std::string text = parts.empty() ? apart(ours, other) : "";
  for (std::size_t i = 0; i < parts.size(); ++i) text += (i ? "; " : "") + parts[i];
  const std::string e = ends(ours, other);
  text += "." + (e.empty() ? "" : " " + e);
  const CostError &coarseOurs = ours.curve.front(), &coarseOther = other.curve.front();
  if (coarseOther.error > coarseOurs.error && coarseOther.cost < coarseOurs.cost)
    text += " With more error than any point of " + ours.name + " (over " + figure(coarseOurs.error) + "), " +
            other.name + " takes as little as " + figure(coarseOther.cost) + " ms.";
  return text;
}

}  // namespace

std::vector<Finding> findings(const Context& context, const Level& level, const Points& points, Reference reference) {
  Points measured;
  const auto all = costErrors(points, reference, &measured);
  const auto indices = paretoFront(all);
  if (indices.empty()) return {};
  Points front;
  for (const std::size_t i : indices) front.push_back(measured[i]);
  std::vector<Finding> lines = {{"Pareto front", frontSentence(front, reference)}};

  const auto curveOf = [&](const std::function<bool(const Point&)>& wanted, Points* members) {
    Points own;
    for (const Point* p : measured)
      if (wanted(*p)) own.push_back(p);
    if (members) members->insert(members->end(), own.begin(), own.end());
    return frontCurve(costErrors(own, reference));
  };
  Points ourPoints, marchPoints;
  const Side ours = {"exact", curveOf([](const Point& p) { return isOurs(p.technique); }, &ourPoints)};
  const Side march = {"the plain march",
                      curveOf([](const Point& p) { return isBruteForce(p.technique); }, &marchPoints)};
  const auto with = [&](Points other) {
    other.insert(other.end(), ourPoints.begin(), ourPoints.end());
    return 1 + noise(other);
  };
  const auto duels = [&](const Side& other, double equal) {
    lines.push_back({ours.name + " against " + other.name + " at equal error", duel(ours, other, equal)});
  };
  if (!ours.curve.empty() && !march.curve.empty()) duels(march, with(marchPoints));
  if (!ours.curve.empty())
    for (const auto& [series, own] : bySeries(measured, context.styles)) {
      if (isOurs(own.front()->technique) || isBruteForce(own.front()->technique)) continue;
      const Side rival = {series, curveOf([&](const Point& p) { return p.series == series; }, nullptr)};
      if (!rival.curve.empty()) duels(rival, with(own));
    }
  if (reference == Reference::kTruth && level.truthSelfNrmse) {
    const auto below =
        std::count_if(all.begin(), all.end(), [&](const CostError& c) { return c.error < 2 * *level.truthSelfNrmse; });
    lines.push_back({"The truth's own error",
                     "The truth differs from itself with half the samples by nRMSE " + figure(*level.truthSelfNrmse) +
                         ": of errors below about twice that (" + std::to_string(below) + " " +
                         plural(static_cast<std::size_t>(below), "point") + ") a part is the truth's."});
  }
  return lines;
}

}  // namespace tyndall::bench::report
