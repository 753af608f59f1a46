// Which node of a level a ray hits first.
#pragma once

#include <optional>
#include <vector>

#include "scene/scene.hpp"

namespace tyndall::editor {

/// The node whose mesh the ray from `origin` along `direction` (any length but 0) hits first, in the world; both sides
/// of triangles count, and what is cut out of a texture counts as solid. Every triangle of every mesh whose box is hit
/// is tried: meant for clicks.
std::optional<int> nodeUnder(const scene::Scene& scene, const std::vector<glm::mat4>& worldFromNode,
                             const glm::vec3& origin, const glm::vec3& direction);

}  // namespace tyndall::editor
