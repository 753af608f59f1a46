#include "convex.hpp"

#include <algorithm>
#include <limits>

#include "base/assert.hpp"

namespace tyndall::render {

namespace {

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

}  // namespace

// Andrew 1979, Another Efficient Algorithm for Convex Hulls in Two Dimensions (the monotone chain).
Polygon convexHull(std::vector<glm::dvec2> points) {
  const auto before = [](glm::dvec2 a, glm::dvec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Polygon hull;
  const auto chain = [&](auto first, auto last, std::size_t floor) {
    for (auto p = first; p != last; ++p) {
      while (hull.size() >= floor + 2 && cross(hull.back() - hull[hull.size() - 2], *p - hull.back()) <= 0)
        hull.pop_back();
      hull.push_back(*p);
    }
    hull.pop_back();  // the other chain starts with it
  };
  chain(points.begin(), points.end(), 0);
  chain(points.rbegin(), points.rend(), hull.size());
  return hull;
}

// Sutherland and Hodgman 1974, Reentrant Polygon Clipping.
Polygon intersect(const Polygon& subject, const Polygon& clip) {
  Polygon result = subject;
  for (std::size_t i = 0; i < clip.size() && !result.empty(); ++i) {
    const glm::dvec2 from = clip[i], along = clip[(i + 1) % clip.size()] - from;
    Polygon kept;
    for (std::size_t j = 0; j < result.size(); ++j) {
      const glm::dvec2 a = result[j], b = result[(j + 1) % result.size()];
      const double sideA = cross(along, a - from), sideB = cross(along, b - from);
      if (sideA >= 0) kept.push_back(a);
      if ((sideA > 0 && sideB < 0) || (sideA < 0 && sideB > 0)) kept.push_back(a + (b - a) * (sideA / (sideA - sideB)));
    }
    result = std::move(kept);
  }
  return result.size() < 3 ? Polygon{} : result;
}

double area(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) twice += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  return 0.5 * twice;
}

// Freeman and Shapira 1975, Determining the Minimum-Area Encasing Rectangle for an Arbitrary Closed Curve: a side of
// the best rectangle lies on an edge. Polygons here have a dozen edges, so each edge simply looks at all points.
Rectangle smallestRectangle(const Polygon& polygon) {
  TY_ASSERT(!polygon.empty(), "a polygon without points");
  Rectangle best;
  double bestArea = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    glm::dvec2 axis = polygon[(i + 1) % polygon.size()] - polygon[i];
    const double length = glm::length(axis);
    axis = length > 0 ? axis / length : glm::dvec2(1, 0);
    const glm::dvec2 perp(-axis.y, axis.x);
    glm::dvec2 low(std::numeric_limits<double>::max()), high(std::numeric_limits<double>::lowest());
    for (const glm::dvec2& p : polygon) {
      const glm::dvec2 q(glm::dot(p, axis), glm::dot(p, perp));
      low = glm::min(low, q);
      high = glm::max(high, q);
    }
    const glm::dvec2 size = high - low;
    if (size.x * size.y >= bestArea) continue;
    bestArea = size.x * size.y;
    const glm::dvec2 middle = 0.5 * (low + high);
    best = {middle.x * axis + middle.y * perp, 0.5 * size, axis};
  }
  return best;
}

}  // namespace tyndall::render
