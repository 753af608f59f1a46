// What a frame draws: every primitive of every node, sorted.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "scene/scene.hpp"
#include "scene_resources.hpp"
#include "shared/surface.h"

namespace tyndall::render {

/// Which faces a draw shows; mirrored transforms turn triangles over.
enum class Facing : std::uint8_t { kFront, kFrontMirrored, kBoth };

struct Draw {
  DrawRange range;
  std::uint32_t instance = 0;
  Facing facing = Facing::kFront;
  bool mask = false;
  bool casts = true;           ///< shadows
  std::uint32_t textures = 0;  ///< shared::k...Map bits
  scene::Bounds bounds;        ///< world
  float distance = 0;  ///< opaque: to the nearest point of the bounds; blended: to their centre; metres from the eye
};

struct DrawList {
  std::vector<shared::InstanceBlock> instances;
  std::vector<Draw> solid;    ///< opaque and alpha-tested, by pipeline, then front to back
  std::vector<Draw> blended;  ///< back to front; these cast no shadows
  scene::Bounds casters;      ///< of what casts shadows, world
};

DrawList buildDrawList(const scene::Scene& scene, const SceneResources& resources,
                       const std::vector<glm::mat4>& worldFromNode, const glm::vec3& eye);

}  // namespace tyndall::render
