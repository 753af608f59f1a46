#include "sun.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace tyndall::truth {
namespace {

/// Keeps the part of a convex polygon where a x + b y <= c (Sutherland and Hodgman 1974).
std::vector<glm::dvec2> clipped(const std::vector<glm::dvec2>& polygon, double a, double b, double c) {
  std::vector<glm::dvec2> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
    const double outsideP = a * p.x + b * p.y - c, outsideQ = a * q.x + b * q.y - c;
    if (outsideP <= 0) kept.push_back(p);
    if ((outsideP < 0 && outsideQ > 0) || (outsideP > 0 && outsideQ < 0))
      kept.push_back(p + (q - p) * (outsideP / (outsideP - outsideQ)));
  }
  return kept;
}

}  // namespace

std::optional<Interval> shadowable(const Box& casters, const glm::dvec3& travel, const glm::dvec3& direction,
                                   double length) {
  if (casters.empty()) return std::nullopt;
  // Points (t, s): the point at t on the ray, moved back by s towards the sun, is in the box. That is a convex polygon.
  const glm::dvec3 farthest = glm::max(glm::abs(casters.min), glm::abs(casters.max));
  const double reach = length + glm::length(farthest) + 1;
  const double pad = 1e-5 * reach;  // covers the roundings of Embree's floats
  std::vector<glm::dvec2> polygon{{0, 0}, {length, 0}, {length, reach}, {0, reach}};
  for (int k = 0; k < 3; ++k) {
    polygon = clipped(polygon, direction[k], -travel[k], casters.max[k] + pad);
    polygon = clipped(polygon, -direction[k], travel[k], -casters.min[k] + pad);
  }
  if (polygon.empty()) return std::nullopt;
  const auto [first, last] =
      std::minmax_element(polygon.begin(), polygon.end(), [](glm::dvec2 p, glm::dvec2 q) { return p.x < q.x; });
  return Interval{std::clamp(first->x, 0.0, length), std::clamp(last->x, 0.0, length)};
}

glm::dvec3 sunScatter(const glm::dvec3& travel, const LightImage* image, const glm::dvec3& direction, double length,
                      const Medium& medium, const Box& casters, std::uint32_t samples, ShadowRays& rays) {
  const double p = phase(medium.g, -glm::dot(travel, direction));
  const auto part = shadowable(casters, travel, direction, length);
  const auto strata = [&](Interval interval, auto&& one) {
    if (interval.length() <= 0) return;
    const double weight = transmittedLength(medium.sigma_t, interval) / samples;
    for (std::uint32_t i = 0; i < samples; ++i) {
      const glm::dvec3 point = distanceAtShare(medium.sigma_t, interval, (i + 0.5) / samples) * direction;
      one(point, image ? weight * image->colorTowards(point) : glm::dvec3(weight));
    }
  };
  glm::dvec3 lit(0);
  for (const Interval end : {Interval{0, part ? part->begin : length}, Interval{part ? part->end : length, length}}) {
    if (image)
      strata(end, [&](const glm::dvec3&, const glm::dvec3& weight) { lit += weight; });
    else
      lit += transmittedLength(medium.sigma_t, end);
  }
  if (part)
    strata(*part, [&](const glm::dvec3& point, const glm::dvec3& weight) {
      rays.add(point, -travel, std::numeric_limits<double>::infinity(), weight);
    });
  return p * (lit + rays.finish());
}

}  // namespace tyndall::truth
