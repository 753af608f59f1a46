// Which boxes a projection can see.
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.hpp"

namespace tyndall::render {

/// Box of a transformed box.
scene::Bounds transformBounds(const scene::Bounds& box, const glm::mat4& m);

enum class DepthPlanes {
  kBoth,    ///< a camera: nothing outside of clip depth [0, 1]
  kClamped  ///< a shadow map: depth clamp keeps what is before or behind, only w > 0 counts
};
/// False only if the box is wholly outside one plane of the clip volume.
bool mayBeSeen(const scene::Bounds& box, const glm::mat4& clipFromWorld, DepthPlanes depth);

}  // namespace tyndall::render
