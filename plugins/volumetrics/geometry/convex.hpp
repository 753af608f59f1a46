// Convex polygons in the plane, for the region in which light can be blocked.
#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace volumetrics {

using Polygon = std::vector<glm::dvec2>;

/// Convex hull, counter-clockwise, without collinear points (Andrew 1979, monotone chain). Fewer than 3 points: no
/// area.
Polygon convexHull(std::vector<glm::dvec2> points);

/// Intersection of two convex counter-clockwise polygons (Sutherland and Hodgman 1974); empty when they do not overlap.
Polygon intersectConvex(const Polygon& subject, const Polygon& clip);

/// Signed area, positive when counter-clockwise.
double area(const Polygon& polygon);

}  // namespace volumetrics
