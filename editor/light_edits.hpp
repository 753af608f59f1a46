// Lights changed by hand, as differences from the level's file.
#pragma once

#include <map>
#include <optional>

#include <glm/glm.hpp>

namespace tyndall::editor {

/// What can be edited of a light. Units are the scene's.
struct LightEdit {
  glm::vec3 color{1};
  float intensity = 1;                           ///< lux, or candela for a spot or point light
  std::optional<float> range;                    ///< metres; nothing: infinite
  float innerConeAngle = 0, outerConeAngle = 0;  ///< radians
  glm::vec3 translation{0};                      ///< of the light's node, in its parent's space, metres
  bool operator==(const LightEdit&) const = default;
};

/// By the light's node; only lights that differ from the file.
using LightEdits = std::map<int, LightEdit>;

}  // namespace tyndall::editor
