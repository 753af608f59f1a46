// Edits of lights, read from a scene and put into it.
#pragma once

#include "light_edits.hpp"
#include "scene/scene.hpp"

namespace tyndall::editor {

/// Gives each node that shares a light with another a copy of its own, so that they can be edited apart.
void separateLights(scene::Scene& scene);
/// What can be edited of every light, by node.
LightEdits lightsOf(const scene::Scene& scene);
/// Those that differ from `file`.
LightEdits changedLights(const scene::Scene& scene, const LightEdits& file);
/// Every light as in the file, but for the edits.
void applyLights(scene::Scene& scene, const LightEdits& file, const LightEdits& edits);
void setLight(scene::Scene& scene, int node, const LightEdit& edit);

/// Whether an animation places the node: its translation is then not for the hand to change.
bool isMoved(const scene::Scene& scene, int node);
/// The step of the node's translation that moves it by `step` in the world.
glm::vec3 localStep(const scene::Scene& scene, const std::vector<glm::mat4>& worldFromNode, int node,
                    const glm::vec3& step);

}  // namespace tyndall::editor
