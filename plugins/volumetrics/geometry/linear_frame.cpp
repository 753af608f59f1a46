#include "geometry/linear_frame.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace volumetrics {
namespace {

/// A span nearer to 180 degrees than this leaves no frustum worth the name: its sides are 57 times as far as its
/// middle.
constexpr double kLargestSpan = std::numbers::pi * 178 / 180;
/// auto: longest column and widest slice, in even ones. At a width of 1.4 the maps were equally exact (min_max on hall
/// and forest), at 2 the projective one was worse by a tenth to a half, at 10 by half to double.
constexpr double kLongestColumn = 4, kWidestSlice = 1.4;
/// How far below these limits a projective map takes over wholly. Found by turning cameras on two levels: 0.3 and 0.06
/// at least are six degrees.
constexpr double kColumnFade = 0.35, kSliceFade = 0.07;

/// linear: condition below which the projective map has no share, and above which it has all; the same for the share
/// of the longest column, the other way round. Found by turning a camera until the sun comes on the screen: with one
/// map the error rises from 0.07 (share 0.7) to 0.1 (0.85), 0.16 (0.9) and 0.8 (0.97), with four it is below 0.01 until
/// the condition is 0.01, where depths and slices give way. The bounds lie well before that, and some degrees apart.
constexpr double kLeastCondition = 0.04, kGoodCondition = 0.1;
constexpr double kMostInOneColumn = 0.9, kGoodInOneColumn = 0.75;

/// Direction in the middle of the two projected corners that span the largest angle; none if that is too large.
std::optional<glm::dvec2> bisectrix(const std::array<glm::dvec2, 4>& corners) {
  double largest = -1;
  glm::dvec2 middle{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      const double a = glm::length(corners[i]), b = glm::length(corners[j]);
      if (a < 1e-6 || b < 1e-6) return std::nullopt;  // a corner looks along the light
      const double angle = std::acos(std::clamp(glm::dot(corners[i], corners[j]) / (a * b), -1.0, 1.0));
      if (angle <= largest) continue;
      largest = angle;
      middle = corners[i] / a + corners[j] / b;
    }
  if (largest > kLargestSpan) return std::nullopt;
  return glm::normalize(middle);
}

/// Border of the split that starts at `start` if its last column, of `columns`, is to be `length` long. Columns are
/// uniform in 1/x, so that column is b (b - a) / (columns a + b - a) long in a split from a to b.
double splitEnd(double start, double length, double columns) {
  const double sum = start + length;
  return 0.5 * (sum + std::sqrt(sum * sum + 4 * length * start * (columns - 1)));
}

/// Clip coordinates as functions of (x, y, height) along (e1, e2, towards) from the eye, all linear, then of world
/// positions.
glm::mat4 clipMatrix(const RectificationInput& input, const RectificationBlock& block, double nearInverse,
                     double farInverse) {
  const double span = block.sliceStep * static_cast<double>(block.slices);
  // x: the tangent y/x from sliceLow to sliceLow + span; y: 1/x from nearInverse to farInverse; z: depth; w: x.
  const std::array<glm::dvec3, 4> rows = {
      glm::dvec3(-2.0 * block.sliceLow / span - 1, 2 / span, 0),
      glm::dvec3(2 * nearInverse / (nearInverse - farInverse) - 1, 0, 0),
      glm::dvec3(-static_cast<double>(block.rasterLow) * block.rasterScale, 0, -static_cast<double>(block.rasterScale)),
      glm::dvec3(1, 0, 0)};
  const double constants[4] = {0, -2 / (nearInverse - farInverse), 0, 0};
  const glm::dvec3 e1(block.e1), e2(block.e2), axis(input.towards), eye(input.rays.eye);
  glm::mat4 clip;
  for (int r = 0; r < 4; ++r) {
    const glm::dvec3 row = rows[static_cast<std::size_t>(r)].x * e1 + rows[static_cast<std::size_t>(r)].y * e2 +
                           rows[static_cast<std::size_t>(r)].z * axis;
    for (int c = 0; c < 3; ++c) clip[c][r] = static_cast<float>(row[c]);
    clip[3][r] = static_cast<float>(constants[r] - glm::dot(row, eye));
  }
  return clip;
}

}  // namespace

std::array<double, kMaxSplits + 1> splitBorders(double first, double last, std::uint32_t splits, double columns) {
  std::array<double, kMaxSplits + 1> borders{first};
  const auto reach = [&](double length) {
    double border = first;
    for (std::uint32_t i = 0; i < splits; ++i) borders[i + 1] = border = splitEnd(border, length, columns);
    return border;
  };
  double low = 0, high = last * (last - first) / (columns * first + last - first);  // a single split needs the latter
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (reach(middle) < last ? low : high) = middle;
  }
  reach(high);
  borders[splits] = last;
  return borders;
}

std::optional<LinearFrame> linearFrame(const RectificationInput& input, std::uint32_t splits) {
  const glm::dvec3 axis(input.towards);
  const auto corners = cornerDirections(input.rays);
  const auto planes = sidePlanes(corners);
  if (inFrustum(planes, axis) || inFrustum(planes, -axis)) return std::nullopt;

  const glm::dvec3 any =
      glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  const glm::dvec3 other = glm::cross(axis, any);
  std::array<glm::dvec2, 4> flat;
  for (std::size_t i = 0; i < 4; ++i) flat[i] = {glm::dot(corners[i], any), glm::dot(corners[i], other)};
  const auto middle = bisectrix(flat);
  if (!middle) return std::nullopt;

  LinearFrame frame;
  RectificationBlock& block = frame.block;
  const glm::dvec3 e1 = glm::normalize(middle->x * any + middle->y * other);
  const Polygon region = fillFrame(input, e1, block);
  const glm::dvec3 e2(block.e2);
  double tanMin = 1e300, tanMax = -1e300, depthMin = 1e300, depthMax = -1e300, nearest = 1e300;
  for (const glm::dvec3& q : corners) {
    const double x = glm::dot(q, e1);
    if (x <= 1e-6) return std::nullopt;
    nearest = std::min(nearest, x * input.rays.znear);
    frame.condition = std::min(frame.condition, x / glm::length(q));
    tanMin = std::min(tanMin, glm::dot(q, e2) / x);
    tanMax = std::max(tanMax, glm::dot(q, e2) / x);
    depthMin = std::min(depthMin, -glm::dot(q, axis) / x);
    depthMax = std::max(depthMax, -glm::dot(q, axis) / x);
  }
  block.slicing = kSlicesByTangent;
  block.sliceLow = static_cast<float>(tanMin);
  block.sliceStep = static_cast<float>(std::max(tanMax - tanMin, 1e-6) / input.slices);
  frame.widestSlice = (tanMax - tanMin) / std::max(std::atan(tanMax) - std::atan(tanMin), 1e-6);
  const double guard = kDepthGuard * std::max(depthMax - depthMin, 1e-3);
  block.rasterLow = static_cast<float>(depthMin - guard);
  block.rasterScale = static_cast<float>(1 / (depthMax - depthMin + 2 * guard));
  fillDepths(input, block);

  double first = 1e300, last = 0;
  for (const glm::dvec2& corner : region) {
    first = std::min(first, corner.x);
    last = std::max(last, corner.x);
  }
  block.nearLit = first > nearest ? 1 : 0;
  first = std::max(first, nearest);
  if (region.empty() || last <= first * (1 + 1e-6)) {
    block.polygonCount = 0;  // nothing can be blocked
    block.nearLit = 1;
    last = first = nearest;
  }
  block.splits = splits;
  frame.evenColumn = (last - first) / (static_cast<double>(input.columns) * splits);
  const auto borders = splitBorders(first, last, splits, input.columns);
  for (std::uint32_t i = 0; i <= splits; ++i) block.inverse[i] = static_cast<float>(1 / borders[i]);
  if (block.polygonCount == 0) return frame;
  for (std::uint32_t i = 0; i < splits; ++i) {
    const double near = 1 / borders[i], far = 1 / borders[i + 1];
    frame.clipFromWorld[i] = clipMatrix(input, block, near, far);
    frame.longestColumn = std::max(frame.longestColumn, borders[i + 1] - 1 / (far + (near - far) / input.columns));
  }
  frame.longestShare = frame.longestColumn / (last - first);
  return frame;
}

double linearHold(const LinearFrame& frame) {
  const double condition = (frame.condition - kLeastCondition) / (kGoodCondition - kLeastCondition);
  const double columns = (kMostInOneColumn - frame.longestShare) / (kMostInOneColumn - kGoodInOneColumn);
  return std::clamp(std::min(condition, columns), 0.0, 1.0);
}

double linearShare(const LinearFrame& frame) {
  const double columns =
      frame.evenColumn > 0 ? (kLongestColumn - frame.longestColumn / frame.evenColumn) / kColumnFade : 1;
  const double even = std::clamp(std::min(columns, (kWidestSlice - frame.widestSlice) / kSliceFade), 0.0, 1.0);
  return std::min(even, linearHold(frame));
}

}  // namespace volumetrics
