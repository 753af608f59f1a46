#include "triangles.hpp"

namespace tyndall::levels {
namespace {

std::optional<float> hit(const Triangle& t, const glm::vec3& origin, const glm::vec3& direction) {
  const glm::vec3 p = glm::cross(direction, t.edge2);
  const float determinant = glm::dot(t.edge1, p);
  if (glm::abs(determinant) < 1e-12f) return std::nullopt;
  const glm::vec3 s = origin - t.corner;
  const float u = glm::dot(s, p) / determinant;
  if (u < 0 || u > 1) return std::nullopt;
  const glm::vec3 q = glm::cross(s, t.edge1);
  const float v = glm::dot(direction, q) / determinant;
  if (v < 0 || u + v > 1) return std::nullopt;
  const float distance = glm::dot(t.edge2, q) / determinant;
  if (distance <= 1e-4f) return std::nullopt;
  return distance;
}

}  // namespace

std::vector<Triangle> trianglesOf(const scene::Scene& scene, double seconds,
                                  const std::function<bool(const scene::Node&)>& wanted) {
  const std::vector<glm::mat4> world = scene::worldMatrices(scene, seconds);
  std::vector<Triangle> triangles;
  for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
    const scene::Node& node = scene.nodes[n];
    if (node.mesh == scene::kNone || (wanted && !wanted(node))) continue;
    for (const scene::Primitive& primitive : scene.meshes[node.mesh].primitives) {
      const bool blended = primitive.material != scene::kNone &&
                           scene.materials[primitive.material].alphaMode == scene::AlphaMode::kBlend;
      if (blended) continue;
      const auto at = [&](std::size_t i) {
        return glm::vec3(world[n] * glm::vec4(primitive.vertices[primitive.indices[i]].position, 1));
      };
      for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
        triangles.push_back({at(i), at(i + 1) - at(i), at(i + 2) - at(i)});
      }
    }
  }
  return triangles;
}

std::optional<float> nearest(const std::vector<Triangle>& triangles, const glm::vec3& origin,
                             const glm::vec3& direction) {
  std::optional<float> best;
  for (const Triangle& t : triangles) {
    const std::optional<float> distance = hit(t, origin, direction);
    if (distance && (!best || *distance < *best)) best = distance;
  }
  return best;
}

bool blocked(const std::vector<Triangle>& triangles, const glm::vec3& origin, const glm::vec3& direction) {
  for (const Triangle& t : triangles) {
    if (hit(t, origin, direction)) return true;
  }
  return false;
}

}  // namespace tyndall::levels
