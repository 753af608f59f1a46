// Convex polygons in the plane: hull, intersection, smallest enclosing rectangle. Double precision, counter-clockwise.
#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace tyndall::render {

using Polygon = std::vector<glm::dvec2>;

/// Convex hull without collinear points; fewer than three points when all lie on a line.
Polygon convexHull(std::vector<glm::dvec2> points);

/// Intersection of two convex polygons; empty when they do not overlap.
Polygon intersect(const Polygon& subject, const Polygon& clip);

double area(const Polygon& polygon);

/// A rectangle: all points centre + s*half.x*axis + t*half.y*perp(axis), s and t in [-1, 1].
struct Rectangle {
  glm::dvec2 center{0}, half{0};
  glm::dvec2 axis{1, 0};  ///< unit
};
/// The enclosing rectangle of least area; one of its sides lies along an edge of the polygon (at least one point).
Rectangle smallestRectangle(const Polygon& polygon);

}  // namespace tyndall::render
