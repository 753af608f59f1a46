#include "culling.hpp"

#include <limits>

namespace tyndall::render {

scene::Bounds transformBounds(const scene::Bounds& box, const glm::mat4& m) {
  if (box.empty()) return box;
  // Arvo 1990, Transforming Axis-Aligned Bounding Boxes (Graphics Gems).
  scene::Bounds result{glm::vec3(m[3]), glm::vec3(m[3])};
  for (int column = 0; column < 3; ++column) {
    const glm::vec3 a = glm::vec3(m[column]) * box.min[column], b = glm::vec3(m[column]) * box.max[column];
    result.min += glm::min(a, b);
    result.max += glm::max(a, b);
  }
  return result;
}

bool mayBeSeen(const scene::Bounds& box, const glm::mat4& clipFromWorld, DepthPlanes depth) {
  if (box.empty()) return false;
  // Planes as combinations of the matrix's rows (Gribb and Hartmann 2001, Fast Extraction of Viewing Frustum Planes).
  const glm::mat4 rows = glm::transpose(clipFromWorld);
  const glm::vec4 planes[7] = {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1],
                               rows[3],           rows[2],           rows[3] - rows[2]};
  const int count = depth == DepthPlanes::kBoth ? 7 : 5;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 normal(planes[i]);
    const glm::vec3 farthest(normal.x >= 0 ? box.max.x : box.min.x, normal.y >= 0 ? box.max.y : box.min.y,
                             normal.z >= 0 ? box.max.z : box.min.z);
    if (glm::dot(normal, farthest) + planes[i].w < 0) return false;
  }
  return true;
}

}  // namespace tyndall::render
