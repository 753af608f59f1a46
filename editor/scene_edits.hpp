// What the hand changed of a level, as differences from its file.
#pragma once

#include <map>
#include <optional>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace tyndall::editor {

/// What can be edited of a light. Units are the scene's.
struct LightEdit {
  glm::vec3 color{1};
  float intensity = 1;                           ///< lux, or candela for a spot or point light
  std::optional<float> range;                    ///< metres; nothing: infinite
  float innerConeAngle = 0, outerConeAngle = 0;  ///< radians
  bool operator==(const LightEdit&) const = default;
};

/// Where a node stands in its parent's space, metres.
struct NodeEdit {
  glm::vec3 translation{0};
  glm::quat rotation{1, 0, 0, 0};
  glm::vec3 scale{1};
  std::optional<glm::mat4> matrix;  ///< of a node that the file gave one: the others are then not used
  glm::vec3 position() const { return matrix ? glm::vec3((*matrix)[3]) : translation; }
  void setPosition(const glm::vec3& p) { matrix ? void((*matrix)[3] = glm::vec4(p, 1)) : void(translation = p); }
  bool operator==(const NodeEdit&) const = default;
};

/// The numbers of a material; textures multiply them.
struct MaterialEdit {
  glm::vec4 baseColor{1};
  float metallic = 1, roughness = 1, alphaCutoff = 0.5f;
  glm::vec3 emissive{0};
  bool operator==(const MaterialEdit&) const = default;
};

/// Only what differs from the file.
struct SceneEdits {
  std::map<int, LightEdit> lights;  ///< by the light's node
  std::map<int, NodeEdit> nodes;
  std::map<int, MaterialEdit> materials;
  bool empty() const { return lights.empty() && nodes.empty() && materials.empty(); }
  bool operator==(const SceneEdits&) const = default;
};

}  // namespace tyndall::editor
