// Moving and turning nodes in the world, whatever their parents are.
#pragma once

#include "edited_scene.hpp"

namespace tyndall::editor {

/// How far from its parent's origin a node can be moved, metres.
inline constexpr float kMaxMetres = 1e5f;

/// Whether an animation sets this of the node: it is then not for the hand to change.
bool isAnimated(const scene::Scene& scene, int node, scene::AnimationTarget target);

glm::mat4 worldFromParent(const scene::Scene& scene, const std::vector<glm::mat4>& worldFromNode, int node);
/// Where the node's handles are: the middle of its mesh, or its origin. World.
glm::vec3 pivotOf(const scene::Scene& scene, const std::vector<glm::mat4>& worldFromNode, int node);

/// The node moved by `step` in the world. A parent that is flat leads nowhere: it then stays.
NodeEdit moved(const NodeEdit& node, const glm::mat4& worldFromParent, const glm::vec3& step);
/// The node turned in the world about `pivot`. Exact but where a sheared parent would shear it: its rotation is then
/// the nearest one.
NodeEdit turned(const NodeEdit& node, const glm::mat4& worldFromParent, const glm::vec3& pivot,
                const glm::quat& rotation);

/// The shortest turn from one unit vector to another.
glm::quat turnBetween(const glm::vec3& from, const glm::vec3& to);

/// A direction as a compass has it, radians: azimuth from -Z towards +X; height above the horizon, positive upwards.
struct Heading {
  float azimuth = 0, height = 0;
};
Heading headingOf(const glm::vec3& direction);
glm::vec3 directionOf(const Heading& heading);

}  // namespace tyndall::editor
