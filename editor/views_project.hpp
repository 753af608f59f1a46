// World points on the picture.
#pragma once

#include <optional>
#include <utility>

#include <glm/glm.hpp>

namespace tyndall::editor {

/// The part of a world segment that lies before the camera, as pixels of a picture of `size`: x right, y down, pixel
/// centres at half integers. It may reach beyond the picture. Nothing: all of it lies behind.
inline std::optional<std::pair<glm::vec2, glm::vec2>> projectSegment(const glm::mat4& clipFromWorld,
                                                                     const glm::vec3& from, const glm::vec3& to,
                                                                     const glm::vec2& size) {
  // In double: a light ray may be kilometres long, and what is cut off it must not move the rest.
  glm::dvec4 a = glm::dmat4(clipFromWorld) * glm::dvec4(glm::dvec3(from), 1),
             b = glm::dmat4(clipFromWorld) * glm::dvec4(glm::dvec3(to), 1);
  constexpr double kNearest = 1e-3;  // m along the optical axis
  if (a.w < kNearest && b.w < kNearest) return std::nullopt;
  if (a.w < kNearest)
    a = b + (a - b) * ((b.w - kNearest) / (b.w - a.w));
  else if (b.w < kNearest)
    b = a + (b - a) * ((a.w - kNearest) / (a.w - b.w));
  const auto pixel = [&](const glm::dvec4& p) {
    return glm::vec2((glm::dvec2(p) / p.w * 0.5 + 0.5) * glm::dvec2(size));
  };
  return std::pair(pixel(a), pixel(b));
}

/// A world point as a pixel; nothing behind the camera.
inline std::optional<glm::vec2> projectedPoint(const glm::mat4& clipFromWorld, const glm::vec3& point,
                                               const glm::vec2& size) {
  const auto seen = projectSegment(clipFromWorld, point, point, size);
  return seen ? std::optional(seen->first) : std::nullopt;
}

}  // namespace tyndall::editor
