#include "geometry/epipolar_frame.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/convex.hpp"

namespace volumetrics {
namespace {

constexpr double kPi = std::numbers::pi;

double angleTo(const glm::dvec3& direction, const glm::dvec3& axis) {
  return std::atan2(glm::length(glm::cross(direction, axis)), glm::dot(direction, axis));
}

}  // namespace

std::array<glm::dvec3, 4> cornerDirections(const RayBlock& rays) {
  const glm::dvec3 f(rays.forward), r(rays.right), u(rays.up);
  return {f - r - u, f + r - u, f + r + u, f - r + u};
}

std::array<glm::dvec3, 4> sidePlanes(const std::array<glm::dvec3, 4>& corners) {
  std::array<glm::dvec3, 4> planes;
  for (std::size_t i = 0; i < 4; ++i) {
    planes[i] = glm::normalize(glm::cross(corners[i], corners[(i + 1) % 4]));
    if (glm::dot(planes[i], corners[(i + 2) % 4]) < 0) planes[i] = -planes[i];
  }
  return planes;
}

bool inFrustum(const std::array<glm::dvec3, 4>& planes, const glm::dvec3& direction) {
  return std::all_of(planes.begin(), planes.end(), [&](const auto& n) { return glm::dot(n, direction) >= 0; });
}

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
  if (inFrustum(planes, axis)) range.min = 0;
  if (inFrustum(planes, -axis)) range.max = kPi;
  return range;
}

void fillDepths(const RectificationInput& input, RectificationBlock& block) {
  const InclinationRange range = inclinationRange(input.rays, input.towards);
  const double guard = kDepthGuard * std::max(range.max - range.min, 1e-3);
  block.depthLow = static_cast<float>(range.min - guard);
  block.depthScale = static_cast<float>(1 / (range.max - range.min + 2 * guard));
  block.depthPower = 1;
  block.meanTheta = static_cast<float>((range.min + range.max) / 2);
}

Polygon fillFrame(const RectificationInput& input, const glm::dvec3& e1, RectificationBlock& block) {
  const glm::dvec3 axis(input.towards);
  const glm::dvec3 e2 = glm::cross(axis, e1);
  block.e1 = glm::vec3(e1);
  block.e2 = glm::vec3(e2);
  block.columns = input.columns;
  block.slices = input.slices;
  block.splits = 1;
  const auto corners = cornerDirections(input.rays);
  const auto planes = sidePlanes(corners);
  block.planeCount = 4;
  for (std::size_t i = 0; i < 4; ++i)
    block.planes[i] = glm::vec3(glm::dot(planes[i], e1), glm::dot(planes[i], e2), glm::dot(planes[i], axis));

  // Seen along the light: the frustum from the eye to the far corners, and the casters. Outside either nothing is
  // shadowed or nothing is seen.
  const auto project = [&](const glm::dvec3& v) { return glm::dvec2(glm::dot(v, e1), glm::dot(v, e2)); };
  std::vector<glm::dvec2> seen{glm::dvec2(0)};
  for (const glm::dvec3& q : corners) seen.push_back(project(q * static_cast<double>(input.rays.zfar)));
  std::vector<glm::dvec2> casters;
  for (const glm::vec3& corner : input.casterCorners)
    casters.push_back(project(glm::dvec3(corner) - glm::dvec3(input.rays.eye)));
  const Polygon region = input.wholeView ? convexHull(seen) : intersectConvex(convexHull(casters), convexHull(seen));
  block.reach = 0;
  if (region.size() < 3 || area(region) <= 0) return {};
  for (const glm::dvec2& corner : region) block.reach = std::max(block.reach, static_cast<float>(glm::length(corner)));
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
  return region;
}

namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }
double azimuth(const glm::dvec2& p) { return std::atan2(p.y, p.x); }

struct Edge {
  glm::dvec2 start, end;
  double pixels;  // share of `pixels` that this part of the border has
};

void append(RectificationBlock& block, const Edge& edge, double phiStart, double phiEnd) {
  BorderEdge& out = block.edges[block.edgeCount++];
  out.start = glm::vec2(edge.start);
  out.delta = glm::vec2(edge.end - edge.start);
  out.phiStart = static_cast<float>(phiStart);
  out.phiEnd = static_cast<float>(phiEnd);
  out.sliceCount = static_cast<float>(edge.pixels);  // scaled to slices once all are known
}

/// Slices spaced along the screen's border. Seen along the light, the azimuth passes every slice once on the parts of
/// the border on which it grows and once on those on which it falls: the longer of the two on screen carries the
/// slices.
void spaceByBorder(const RectificationInput& input, RectificationBlock& block) {
  const auto corners = cornerDirections(input.rays);
  const double width = 2.0 / input.rays.pixelScale.x, height = 2.0 / input.rays.pixelScale.y;
  std::array<std::vector<Edge>, 2> runs;
  std::array<double, 2> length{};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto flat = [&](const glm::dvec3& q) {
      return glm::dvec2(glm::dot(q, glm::dvec3(block.e1)), glm::dot(q, glm::dvec3(block.e2)));
    };
    Edge edge{flat(corners[i]), flat(corners[(i + 1) % 4]), i % 2 == 0 ? width : height};
    const double turn = cross(edge.start, edge.end);
    if (std::abs(turn) < 1e-9) continue;  // seen from the axis it is a point
    if (turn < 0) std::swap(edge.start, edge.end);
    runs[turn > 0 ? 0 : 1].push_back(edge);
    length[turn > 0 ? 0 : 1] += edge.pixels;
  }
  const std::size_t chosen = length[0] >= length[1] ? 0 : 1;
  std::vector<Edge>& run = runs[chosen];
  block.edgeCount = 0;
  std::sort(run.begin(), run.end(), [](const Edge& a, const Edge& b) { return azimuth(a.start) < azimuth(b.start); });
  std::vector<std::pair<Edge, double>> cut;  // an edge that crosses azimuth pi is two: its far part starts at -pi
  for (const Edge& edge : run) {
    const double from = azimuth(edge.start), to = azimuth(edge.end);
    if (to >= from) {
      cut.emplace_back(edge, from);
      continue;
    }
    const double share = edge.start.y / (edge.start.y - edge.end.y);
    const glm::dvec2 middle = edge.start + (edge.end - edge.start) * share;
    cut.emplace_back(Edge{edge.start, middle, edge.pixels * share}, from);
    cut.emplace_back(Edge{middle, edge.end, edge.pixels * (1 - share)}, -kPi);
  }
  std::sort(cut.begin(), cut.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  for (std::size_t i = 0; i < cut.size(); ++i) {
    const bool last = i + 1 == cut.size();
    const double end = last ? (block.fullCircle != 0 ? kPi : azimuth(cut[i].first.end)) : cut[i + 1].second;
    append(block, cut[i].first, cut[i].second, end);
  }
  double start = 0;
  for (std::uint32_t i = 0; i < block.edgeCount; ++i) {
    BorderEdge& edge = block.edges[i];
    const double count = edge.sliceCount / length[chosen] * input.slices;
    edge.sliceStart = static_cast<float>(start);
    edge.sliceCount = static_cast<float>(count);
    start += count;
  }
}

}  // namespace

std::optional<ConeSector> coneSector(const glm::dvec3& towards, const glm::dvec3& coneAxis, double sinOuter) {
  const glm::dvec3 across = coneAxis - towards * glm::dot(coneAxis, towards);
  const double sine = glm::length(across);
  // Within rounding of the axis nearly half of all azimuths are reached: all of them are as good.
  if (sine <= sinOuter * 1.0001) return std::nullopt;
  return ConeSector{across / sine, std::asin(sinOuter / sine)};
}

namespace {

/// Cuts the azimuths of the view, about e1, to a sector around e1. Both are narrower than pi; where they meet at both
/// ends, or not at all, the sector stays whole.
void cutToSector(double halfWidth, double& phiMin, double& phiMax) {
  const double low = std::max(phiMin, -halfWidth), high = std::min(phiMax, halfWidth);
  const bool across = phiMax > 2 * kPi - halfWidth || phiMin < -2 * kPi + halfWidth;
  const bool meet = high > low && !across;
  phiMin = meet ? low : -halfWidth;
  phiMax = meet ? high : halfWidth;
}

}  // namespace

RectificationBlock epipolarBlock(const RectificationInput& input) {
  RectificationBlock block{};
  const glm::dvec3 axis(input.towards);
  const auto corners = cornerDirections(input.rays);
  const auto planes = sidePlanes(corners);

  // e1 points along the middle of the view, so that azimuths of a partial circle never wrap.
  const glm::dvec3 forward(input.rays.forward);
  glm::dvec3 e1 = forward - axis * glm::dot(axis, forward);
  if (glm::length(e1) < 1e-6) e1 = glm::cross(axis, std::abs(axis.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
  // Nothing lies outside a spot light's cone: slices are spent on its azimuths alone, with e1 along their middle.
  std::optional<ConeSector> sector;
  if (input.sinOuter > 0 && input.spacing == SliceSpacing::kAzimuth)
    sector = coneSector(axis, glm::dvec3(input.coneAxis), input.sinOuter);
  const glm::dvec3 middleOfView = glm::normalize(e1);
  fillFrame(input, sector ? sector->middle : middleOfView, block);

  double phiMin = -kPi, phiMax = kPi;
  block.fullCircle = inFrustum(planes, axis) || inFrustum(planes, -axis) ? 1 : 0;
  if (block.fullCircle == 0) {
    phiMin = kPi;
    phiMax = -kPi;
    const glm::dvec3 acrossView = glm::cross(axis, middleOfView);
    const double turned =
        azimuth({glm::dot(middleOfView, glm::dvec3(block.e1)), glm::dot(middleOfView, glm::dvec3(block.e2))});
    for (const glm::dvec3& q : corners) {
      const double phi = turned + std::atan2(glm::dot(q, acrossView), glm::dot(q, middleOfView));
      phiMin = std::min(phiMin, phi);
      phiMax = std::max(phiMax, phi);
    }
  }
  if (sector) {
    cutToSector(sector->halfWidth, phiMin, phiMax);
    block.fullCircle = 0;
  }
  block.slicing = kSlicesByAzimuth;
  block.sliceLow = static_cast<float>(phiMin);
  block.sliceStep = static_cast<float>(std::max(phiMax - phiMin, 1e-6) / input.slices);
  if (input.spacing == SliceSpacing::kBorder && phiMax - phiMin > 1e-6) {
    spaceByBorder(input, block);
    if (block.edgeCount > 0) block.slicing = kSlicesByBorder;
  }

  fillDepths(input, block);
  block.nearLit = 1;
  return block;
}

}  // namespace volumetrics
