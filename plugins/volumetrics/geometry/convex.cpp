#include "geometry/convex.hpp"

#include <algorithm>

namespace volumetrics {
namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace

Polygon convexHull(std::vector<glm::dvec2> points) {
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  Polygon hull;
  const auto chain = [&](auto first, auto last) {
    const std::size_t start = hull.size();
    for (auto it = first; it != last; ++it) {
      while (hull.size() >= start + 2 && cross(hull[hull.size() - 2], hull.back(), *it) <= 0) hull.pop_back();
      hull.push_back(*it);
    }
    hull.pop_back();  // the next chain starts with it
  };
  if (points.size() < 3) return points;
  chain(points.begin(), points.end());
  chain(points.rbegin(), points.rend());
  return hull;
}

Polygon intersectConvex(const Polygon& subject, const Polygon& clip) {
  Polygon result = subject;
  for (std::size_t i = 0; i < clip.size() && !result.empty(); ++i) {
    const glm::dvec2 a = clip[i];
    const glm::dvec2 b = clip[(i + 1) % clip.size()];
    Polygon next;
    for (std::size_t j = 0; j < result.size(); ++j) {
      const glm::dvec2 p = result[j];
      const glm::dvec2 q = result[(j + 1) % result.size()];
      const double dp = cross(a, b, p);
      const double dq = cross(a, b, q);
      if (dp >= 0) next.push_back(p);
      if ((dp > 0 && dq < 0) || (dp < 0 && dq > 0)) next.push_back(p + (q - p) * (dp / (dp - dq)));
    }
    result = std::move(next);
  }
  return result;
}

double area(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = polygon[i];
    const glm::dvec2 b = polygon[(i + 1) % polygon.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return twice / 2;
}

}  // namespace volumetrics
