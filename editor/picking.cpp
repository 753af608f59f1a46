#include "picking.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/gtc/matrix_inverse.hpp>

namespace tyndall::editor {
namespace {

struct Ray {
  glm::vec3 origin, direction;
};

/// Kay and Kajiya 1986: the ray's stretch between the box's planes, as far as it lies before `most`.
bool hitsBox(const Ray& ray, const scene::Bounds& box, float most) {
  float near = 0, far = most;
  for (int axis = 0; axis < 3; ++axis) {
    if (ray.direction[axis] == 0) {
      if (ray.origin[axis] < box.min[axis] || ray.origin[axis] > box.max[axis]) return false;
      continue;
    }
    float a = (box.min[axis] - ray.origin[axis]) / ray.direction[axis],
          b = (box.max[axis] - ray.origin[axis]) / ray.direction[axis];
    if (a > b) std::swap(a, b);
    near = std::max(near, a), far = std::min(far, b);
  }
  // A flat box is met in one point, which rounding may turn over.
  return near <= far * (1 + 1e-5f);
}

/// Möller and Trumbore 1997, "Fast, minimum storage ray/triangle intersection": the parameter along the ray, both
/// sides.
std::optional<float> triangleHit(const Ray& ray, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const glm::vec3 ab = b - a, ac = c - a, p = glm::cross(ray.direction, ac);
  const float determinant = glm::dot(ab, p);
  if (determinant == 0) return std::nullopt;
  const glm::vec3 from = ray.origin - a, q = glm::cross(from, ab);
  const float u = glm::dot(from, p) / determinant, v = glm::dot(ray.direction, q) / determinant;
  if (!(u >= 0 && v >= 0 && u + v <= 1)) return std::nullopt;
  const float t = glm::dot(ac, q) / determinant;
  if (!(t > 0)) return std::nullopt;
  return t;
}

}  // namespace

std::optional<int> nodeUnder(const scene::Scene& scene, const std::vector<glm::mat4>& worldFromNode,
                             const glm::vec3& origin, const glm::vec3& direction) {
  std::optional<int> found;
  // An affine map keeps the parameter along the ray, so that hits of different nodes compare.
  float nearest = std::numeric_limits<float>::max();
  for (std::size_t node = 0; node < scene.nodes.size(); ++node) {
    if (scene.nodes[node].mesh == scene::kNone) continue;
    const glm::mat4& world = worldFromNode[node];
    if (!(std::abs(glm::determinant(glm::mat3(world))) > 0)) continue;  // scaled to nothing
    const glm::mat4 local = glm::affineInverse(world);
    const Ray ray{glm::vec3(local * glm::vec4(origin, 1)), glm::mat3(local) * direction};
    for (const scene::Primitive& primitive :
         scene.meshes[static_cast<std::size_t>(scene.nodes[node].mesh)].primitives) {
      if (primitive.bounds.empty() || !hitsBox(ray, primitive.bounds, nearest)) continue;
      for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
        const auto hit = triangleHit(ray, primitive.vertices[primitive.indices[i]].position,
                                     primitive.vertices[primitive.indices[i + 1]].position,
                                     primitive.vertices[primitive.indices[i + 2]].position);
        if (hit && *hit < nearest) nearest = *hit, found = static_cast<int>(node);
      }
    }
  }
  return found;
}

}  // namespace tyndall::editor
