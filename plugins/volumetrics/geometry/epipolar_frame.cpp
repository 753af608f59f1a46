#include "geometry/epipolar_frame.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/convex.hpp"

namespace volumetrics {
namespace {

constexpr double kPi = std::numbers::pi;

/// Corners of the frustum as directions of unit length along the axis, in order round the screen.
std::array<glm::dvec3, 4> cornerDirections(const RayBlock& rays) {
  const glm::dvec3 f(rays.forward), r(rays.right), u(rays.up);
  return {f - r - u, f + r - u, f + r + u, f - r + u};
}

/// Inward normals of the four side planes.
std::array<glm::dvec3, 4> sidePlanes(const std::array<glm::dvec3, 4>& corners) {
  std::array<glm::dvec3, 4> planes;
  for (std::size_t i = 0; i < 4; ++i) {
    planes[i] = glm::normalize(glm::cross(corners[i], corners[(i + 1) % 4]));
    if (glm::dot(planes[i], corners[(i + 2) % 4]) < 0) planes[i] = -planes[i];
  }
  return planes;
}

bool inside(const std::array<glm::dvec3, 4>& planes, const glm::dvec3& direction) {
  return std::all_of(planes.begin(), planes.end(), [&](const auto& n) { return glm::dot(n, direction) >= 0; });
}

double angleTo(const glm::dvec3& direction, const glm::dvec3& axis) {
  return std::atan2(glm::length(glm::cross(direction, axis)), glm::dot(direction, axis));
}

}  // namespace

InclinationRange inclinationRange(const RayBlock& rays, const glm::vec3& towards) {
  const glm::dvec3 axis(towards);
  const auto corners = cornerDirections(rays);
  const auto planes = sidePlanes(corners);
  InclinationRange range{kPi, 0};
  const auto take = [&](double theta) {
    range.min = std::min(range.min, theta);
    range.max = std::max(range.max, theta);
  };
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec3 q = corners[i];
    const glm::dvec3 e = corners[(i + 1) % 4] - q;
    take(angleTo(q, axis));
    // Where the z of the normalised vector is extremal along the edge q + t e (appendix A).
    const double qz = glm::dot(q, axis), ez = glm::dot(e, axis), qe = glm::dot(q, e);
    const double denominator = ez * qe - qz * glm::dot(e, e);
    if (std::abs(denominator) < 1e-14) continue;
    const double t = (qz * qe - ez * glm::dot(q, q)) / denominator;
    if (t > 0 && t < 1) take(angleTo(q + t * e, axis));
  }
  if (inside(planes, axis)) range.min = 0;
  if (inside(planes, -axis)) range.max = kPi;
  return range;
}

EpipolarBlock epipolarBlock(const EpipolarInput& input) {
  EpipolarBlock block{};
  const glm::dvec3 axis(input.towards);
  const auto corners = cornerDirections(input.rays);
  const auto planes = sidePlanes(corners);

  // e1 points along the middle of the view, so that azimuths of a partial circle never wrap.
  glm::dvec3 e1 = glm::dvec3(input.rays.forward) - axis * glm::dot(axis, glm::dvec3(input.rays.forward));
  if (glm::length(e1) < 1e-6) e1 = glm::cross(axis, std::abs(axis.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
  e1 = glm::normalize(e1);
  const glm::dvec3 e2 = glm::cross(axis, e1);
  block.e1 = glm::vec3(e1);
  block.e2 = glm::vec3(e2);

  double phiMin = -kPi, phiMax = kPi;
  block.fullCircle = inside(planes, axis) || inside(planes, -axis) ? 1 : 0;
  if (block.fullCircle == 0) {
    phiMin = kPi;
    phiMax = -kPi;
    for (const glm::dvec3& q : corners) {
      const double phi = std::atan2(glm::dot(q, e2), glm::dot(q, e1));
      phiMin = std::min(phiMin, phi);
      phiMax = std::max(phiMax, phi);
    }
  }
  block.phiMin = static_cast<float>(phiMin);
  block.phiStep = static_cast<float>(std::max(phiMax - phiMin, 1e-6) / input.slices);

  // Section 5.1.1: the range of theta is stretched by 10 % (a guard band against leaking at its ends).
  const InclinationRange range = inclinationRange(input.rays, input.towards);
  const double guard = 0.05 * std::max(range.max - range.min, 1e-3);
  block.thetaMin = static_cast<float>(range.min - guard);
  block.thetaMax = static_cast<float>(range.max + guard);
  block.meanTheta = static_cast<float>((range.min + range.max) / 2);
  block.columns = input.columns;
  block.slices = input.slices;

  block.planeCount = 4;
  for (std::size_t i = 0; i < 4; ++i)
    block.planes[i] = glm::vec3(glm::dot(planes[i], e1), glm::dot(planes[i], e2), glm::dot(planes[i], axis));

  // Seen along the light: the frustum from the eye to the far corners, and the casters. Outside either nothing is shadowed or
  // nothing is seen.
  const auto project = [&](const glm::dvec3& v) { return glm::dvec2(glm::dot(v, e1), glm::dot(v, e2)); };
  std::vector<glm::dvec2> seen{glm::dvec2(0)};
  for (const glm::dvec3& q : corners) seen.push_back(project(q * static_cast<double>(input.rays.zfar)));
  std::vector<glm::dvec2> casters;
  for (const glm::vec3& corner : input.casterCorners) casters.push_back(project(glm::dvec3(corner) - glm::dvec3(input.rays.eye)));
  const Polygon region = intersectConvex(convexHull(casters), convexHull(seen));
  if (region.size() < 3 || area(region) <= 0) return block;
  block.polygonCount = static_cast<std::uint32_t>(std::min<std::size_t>(region.size(), kMaxPolygon));
  for (std::uint32_t i = 0; i < block.polygonCount; ++i) {
    const glm::dvec2 a = region[i];
    const glm::dvec2 edge = region[(i + 1) % region.size()] - a;
    const double length = glm::length(edge);
    if (length < 1e-12) {  // two corners in one place: a half-plane that excludes nothing
      block.polygon[i] = glm::vec3(0, 0, 1);
      continue;
    }
    const glm::dvec2 outward = glm::dvec2(edge.y, -edge.x) / length;
    block.polygon[i] = glm::vec3(outward, glm::dot(outward, a));
  }
  return block;
}

}  // namespace volumetrics
