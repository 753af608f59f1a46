#include "light_scene.hpp"

#include <algorithm>
#include <set>

namespace tyndall::editor {

void separateLights(scene::Scene& scene) {
  std::set<std::int32_t> taken;
  for (scene::Node& node : scene.nodes) {
    if (node.light == scene::kNone || taken.insert(node.light).second) continue;
    scene.lights.push_back(scene::Light(scene.lights[static_cast<std::size_t>(node.light)]));
    node.light = static_cast<std::int32_t>(scene.lights.size()) - 1;
    taken.insert(node.light);
  }
}

LightEdits lightsOf(const scene::Scene& scene) {
  LightEdits lights;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const scene::Node& node = scene.nodes[i];
    if (node.light == scene::kNone) continue;
    const scene::Light& light = scene.lights[static_cast<std::size_t>(node.light)];
    lights[static_cast<int>(i)] = {light.color,          light.intensity,
                                   light.range,          light.innerConeAngle,
                                   light.outerConeAngle, node.matrix ? glm::vec3((*node.matrix)[3]) : node.translation};
  }
  return lights;
}

LightEdits changedLights(const scene::Scene& scene, const LightEdits& file) {
  LightEdits lights = lightsOf(scene);
  std::erase_if(lights, [&](const auto& entry) { return file.at(entry.first) == entry.second; });
  return lights;
}

void applyLights(scene::Scene& scene, const LightEdits& file, const LightEdits& edits) {
  for (const auto& [node, light] : file) {
    const auto edited = edits.find(node);
    setLight(scene, node, edited == edits.end() ? light : edited->second);
  }
}

void setLight(scene::Scene& scene, int index, const LightEdit& edit) {
  scene::Node& node = scene.nodes[static_cast<std::size_t>(index)];
  scene::Light& light = scene.lights[static_cast<std::size_t>(node.light)];
  light.color = edit.color, light.intensity = edit.intensity, light.range = edit.range;
  light.innerConeAngle = edit.innerConeAngle, light.outerConeAngle = edit.outerConeAngle;
  if (node.matrix)
    (*node.matrix)[3] = glm::vec4(edit.translation, 1);
  else
    node.translation = edit.translation;
}

bool isMoved(const scene::Scene& scene, int node) {
  for (const scene::Animation& animation : scene.animations)
    for (const scene::AnimationChannel& channel : animation.channels)
      if (channel.node == node && channel.target == scene::AnimationTarget::kTranslation) return true;
  return false;
}

glm::vec3 localStep(const scene::Scene& scene, const std::vector<glm::mat4>& worldFromNode, int node,
                    const glm::vec3& step) {
  const std::int32_t parent = scene.nodes[static_cast<std::size_t>(node)].parent;
  if (parent == scene::kNone) return step;
  const glm::mat3 worldFromParent(worldFromNode[static_cast<std::size_t>(parent)]);
  if (glm::determinant(worldFromParent) == 0) return glm::vec3(0);  // a flat parent: nothing leads there
  return glm::inverse(worldFromParent) * step;
}

}  // namespace tyndall::editor
