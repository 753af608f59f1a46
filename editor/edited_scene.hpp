// Edits read from a scene and put into it.
#pragma once

#include <vector>

#include "scene/scene.hpp"
#include "scene_edits.hpp"

namespace tyndall::editor {

/// All that can be edited of a level, as its file has it.
struct SceneFile {
  std::map<int, LightEdit> lights;  ///< by the light's node
  std::vector<NodeEdit> nodes;
  std::vector<MaterialEdit> materials;
};
SceneFile fileOf(const scene::Scene& scene);

/// Gives each node that shares a light with another a copy of its own, so that they can be edited apart.
void separateLights(scene::Scene& scene);

LightEdit lightAt(const scene::Scene& scene, int node);
NodeEdit nodeAt(const scene::Scene& scene, int node);
MaterialEdit materialAt(const scene::Scene& scene, int material);
void setLight(scene::Scene& scene, int node, const LightEdit& edit);
void setNode(scene::Scene& scene, int node, const NodeEdit& edit);
void setMaterial(scene::Scene& scene, int material, const MaterialEdit& edit);

/// What differs from the file.
SceneEdits editsOf(const scene::Scene& scene, const SceneFile& file);
/// Everything as in the file, but for the edits.
void applyEdits(scene::Scene& scene, const SceneFile& file, const SceneEdits& edits);

}  // namespace tyndall::editor
