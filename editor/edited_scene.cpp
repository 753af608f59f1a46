#include "edited_scene.hpp"

#include <set>

namespace tyndall::editor {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// The edit of `index`, or what the file has.
template <class T>
const T& editOr(const std::map<int, T>& edits, int index, const T& file) {
  const auto edited = edits.find(index);
  return edited == edits.end() ? file : edited->second;
}

}  // namespace

void separateLights(scene::Scene& scene) {
  std::set<std::int32_t> taken;
  for (scene::Node& node : scene.nodes) {
    if (node.light == scene::kNone || taken.insert(node.light).second) continue;
    scene.lights.push_back(scene::Light(scene.lights[at(node.light)]));
    node.light = static_cast<std::int32_t>(scene.lights.size()) - 1;
    taken.insert(node.light);
  }
}

LightEdit lightAt(const scene::Scene& scene, int node) {
  const scene::Light& light = scene.lights[at(scene.nodes[at(node)].light)];
  return {light.color, light.intensity, light.range, light.innerConeAngle, light.outerConeAngle};
}

NodeEdit nodeAt(const scene::Scene& scene, int index) {
  const scene::Node& node = scene.nodes[at(index)];
  return {node.translation, node.rotation, node.scale, node.matrix};
}

MaterialEdit materialAt(const scene::Scene& scene, int index) {
  const scene::Material& m = scene.materials[at(index)];
  return {m.baseColor, m.metallic, m.roughness, m.alphaCutoff, m.emissive};
}

void setLight(scene::Scene& scene, int node, const LightEdit& edit) {
  scene::Light& light = scene.lights[at(scene.nodes[at(node)].light)];
  light.color = edit.color, light.intensity = edit.intensity, light.range = edit.range;
  light.innerConeAngle = edit.innerConeAngle, light.outerConeAngle = edit.outerConeAngle;
}

void setNode(scene::Scene& scene, int index, const NodeEdit& edit) {
  scene::Node& node = scene.nodes[at(index)];
  node.translation = edit.translation, node.rotation = edit.rotation, node.scale = edit.scale,
  node.matrix = edit.matrix;
}

void setMaterial(scene::Scene& scene, int index, const MaterialEdit& edit) {
  scene::Material& m = scene.materials[at(index)];
  m.baseColor = edit.baseColor, m.metallic = edit.metallic, m.roughness = edit.roughness;
  m.alphaCutoff = edit.alphaCutoff, m.emissive = edit.emissive;
}

SceneFile fileOf(const scene::Scene& scene) {
  SceneFile file;
  for (int i = 0; i < static_cast<int>(scene.nodes.size()); ++i) {
    file.nodes.push_back(nodeAt(scene, i));
    if (scene.nodes[at(i)].light != scene::kNone) file.lights[i] = lightAt(scene, i);
  }
  for (int i = 0; i < static_cast<int>(scene.materials.size()); ++i) file.materials.push_back(materialAt(scene, i));
  return file;
}

SceneEdits editsOf(const scene::Scene& scene, const SceneFile& file) {
  SceneEdits edits;
  for (const auto& [node, light] : file.lights)
    if (const LightEdit now = lightAt(scene, node); now != light) edits.lights[node] = now;
  for (int i = 0; i < static_cast<int>(file.nodes.size()); ++i)
    if (const NodeEdit now = nodeAt(scene, i); now != file.nodes[at(i)]) edits.nodes[i] = now;
  for (int i = 0; i < static_cast<int>(file.materials.size()); ++i)
    if (const MaterialEdit now = materialAt(scene, i); now != file.materials[at(i)]) edits.materials[i] = now;
  return edits;
}

void applyEdits(scene::Scene& scene, const SceneFile& file, const SceneEdits& edits) {
  for (const auto& [node, light] : file.lights) setLight(scene, node, editOr(edits.lights, node, light));
  for (int i = 0; i < static_cast<int>(file.nodes.size()); ++i)
    setNode(scene, i, editOr(edits.nodes, i, file.nodes[at(i)]));
  for (int i = 0; i < static_cast<int>(file.materials.size()); ++i)
    setMaterial(scene, i, editOr(edits.materials, i, file.materials[at(i)]));
}

}  // namespace tyndall::editor
