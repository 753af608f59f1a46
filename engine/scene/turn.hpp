// How a transform turns things, without their size.
#pragma once

#include <optional>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace tyndall::scene {

/// The rotation, mirrored where a scale is negative. A scale of 0 counts as positive.
glm::mat3 turnOf(const glm::quat& rotation, const glm::vec3& scale);

/// The same of a matrix: backward stays where the third column points, or, where that is zero, at right angles to the
/// other two (not mirrored); up is turned as little as that allows. Nothing where neither tells a direction.
std::optional<glm::mat3> turnOf(const glm::mat3& matrix);

}  // namespace tyndall::scene
