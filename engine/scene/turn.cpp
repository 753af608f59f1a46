#include "turn.hpp"

#include <algorithm>
#include <cmath>

namespace tyndall::scene {
namespace {

/// Two columns whose sine is smaller than this have one direction: that is what rounding of floats leaves of a zero.
constexpr double kLeastSine = 1e-6;

std::optional<glm::dvec3> unit(const glm::dvec3& v) {
  const double length = glm::length(v);
  if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
  return v / length;
}

/// Unit vector at right angles to both; nothing if they have one direction or one is zero.
std::optional<glm::dvec3> perpendicular(const std::optional<glm::dvec3>& a, const std::optional<glm::dvec3>& b) {
  if (!a || !b) return std::nullopt;
  const glm::dvec3 across = glm::cross(*a, *b);
  return glm::length(across) < kLeastSine ? std::nullopt : unit(across);
}

}  // namespace

glm::mat3 turnOf(const glm::quat& rotation, const glm::vec3& scale) {
  glm::mat3 turn = glm::mat3_cast(rotation);
  for (int axis = 0; axis < 3; ++axis)
    if (scale[axis] < 0) turn[axis] = -turn[axis];
  return turn;
}

std::optional<glm::mat3> turnOf(const glm::mat3& matrix) {
  // In double: the squares of columns as small as a float can hold are above 0 there.
  const glm::dmat3 m(matrix);
  const std::optional<glm::dvec3> x = unit(m[0]), y = unit(m[1]);
  std::optional<glm::dvec3> z = unit(m[2]);
  if (!z) z = perpendicular(x, y);
  if (!z) return std::nullopt;
  // Right of up and backward, or of the first column where up is lost, or anywhere: then nothing tells the roll.
  std::optional<glm::dvec3> right = perpendicular(y, z);
  if (!right && x && glm::length(glm::cross(*x, *z)) >= kLeastSine) right = unit(*x - *z * glm::dot(*x, *z));
  if (!right) right = perpendicular(std::abs(z->y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0), z);
  const glm::dvec3 up = glm::cross(*z, *right);
  const bool mirrored = x && y && glm::dot(glm::cross(*x, *y), *z) < 0;
  return glm::mat3(glm::dmat3(mirrored ? -*right : *right, up, *z));
}

}  // namespace tyndall::scene
