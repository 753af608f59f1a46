#include "node_motion.hpp"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace tyndall::editor {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// The rotation in a matrix that may scale, shear and mirror.
glm::quat rotationOf(const glm::mat4& m) {
  const glm::vec3 x = glm::normalize(glm::vec3(m[0]));
  glm::vec3 y(m[1]);
  y = glm::normalize(y - glm::dot(x, y) * x);
  glm::mat3 axes(x, y, glm::cross(x, y));
  // Mirrored, the rotation turns the other two axes over as well: -1 commutes with what it is used for.
  if (glm::dot(axes[2], glm::vec3(m[2])) < 0) axes[2] = -axes[2], axes *= -1.0f;
  return glm::quat_cast(axes);
}

bool isFlat(const glm::mat4& m) { return !(std::abs(glm::determinant(glm::mat3(m))) > 0); }

}  // namespace

bool isAnimated(const scene::Scene& scene, int node, scene::AnimationTarget target) {
  for (const scene::Animation& animation : scene.animations)
    for (const scene::AnimationChannel& channel : animation.channels)
      if (channel.node == node && channel.target == target) return true;
  return false;
}

glm::mat4 worldFromParent(const scene::Scene& scene, const std::vector<glm::mat4>& worldFromNode, int node) {
  const std::int32_t parent = scene.nodes[at(node)].parent;
  return parent == scene::kNone ? glm::mat4(1) : worldFromNode[at(parent)];
}

glm::vec3 pivotOf(const scene::Scene& scene, const std::vector<glm::mat4>& worldFromNode, int node) {
  scene::Bounds bounds;
  if (const std::int32_t mesh = scene.nodes[at(node)].mesh; mesh != scene::kNone)
    for (const scene::Primitive& primitive : scene.meshes[at(mesh)].primitives) bounds.add(primitive.bounds);
  const glm::vec3 middle = bounds.empty() ? glm::vec3(0) : 0.5f * (bounds.min + bounds.max);
  return glm::vec3(worldFromNode[at(node)] * glm::vec4(middle, 1));
}

NodeEdit moved(const NodeEdit& node, const glm::mat4& worldFromParent, const glm::vec3& step) {
  if (isFlat(worldFromParent)) return node;
  NodeEdit result = node;
  const glm::vec3 local = glm::inverse(glm::mat3(worldFromParent)) * step;
  result.setPosition(glm::clamp(node.position() + local, -kMaxMetres, kMaxMetres));
  return result;
}

NodeEdit turned(const NodeEdit& node, const glm::mat4& worldFromParent, const glm::vec3& pivot,
                const glm::quat& rotation) {
  if (isFlat(worldFromParent)) return node;
  const glm::mat4 turn =
      glm::translate(glm::mat4(1), pivot) * glm::mat4_cast(rotation) * glm::translate(glm::mat4(1), -pivot);
  const glm::mat4 local = glm::inverse(worldFromParent) * turn * worldFromParent;
  NodeEdit result = node;
  if (node.matrix) {
    result.matrix = local * *node.matrix;
    (*result.matrix)[3].w = 1;
    return result;
  }
  result.translation = glm::clamp(glm::vec3(local * glm::vec4(node.translation, 1)), -kMaxMetres, kMaxMetres);
  const glm::quat parent = rotationOf(worldFromParent);
  result.rotation = glm::normalize(glm::conjugate(parent) * rotation * parent * node.rotation);
  return result;
}

glm::quat turnBetween(const glm::vec3& from, const glm::vec3& to) {
  const float cosine = glm::dot(from, to);
  if (cosine > -0.99999f) return glm::normalize(glm::quat(1 + cosine, glm::cross(from, to)));
  // Nearly opposite: half a turn about anything at a right angle, and the rest.
  const glm::vec3 other = std::abs(from.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  return turnBetween(-from, to) * glm::angleAxis(glm::pi<float>(), glm::normalize(glm::cross(from, other)));
}

Heading headingOf(const glm::vec3& d) { return {std::atan2(d.x, -d.z), std::asin(std::clamp(d.y, -1.0f, 1.0f))}; }

glm::vec3 directionOf(const Heading& heading) {
  const float level = std::cos(heading.height);
  return {level * std::sin(heading.azimuth), std::sin(heading.height), -level * std::cos(heading.azimuth)};
}

}  // namespace tyndall::editor
