// Fields of what is selected in the level, into the current ImGui window. True: the edit was changed.
#pragma once

#include "node_motion.hpp"
#include "workspace.hpp"

namespace tyndall::editor {

/// Sets the outer cone, radians, to 1 to 89.9 degrees; the inner one stays smaller.
void setOuterCone(LightEdit& light, float angle);

bool lightFields(const scene::Light& light, LightEdit& edit, Workspace& workspace);
bool materialFields(const scene::Material& material, MaterialEdit& edit, Workspace& workspace);
/// Position, and rotation about the node's own origin.
bool placeFields(const scene::Scene& scene, const std::vector<glm::mat4>& worldFromNode, int node, NodeEdit& edit,
                 Workspace& workspace);
/// "as in the file", where it is not.
template <class T>
bool resetButton(const T& file, T& edit, Workspace& workspace, const char* name) {
  if (edit == file) return false;
  const bool pressed = ImGui::Button((std::string("as in the file##") + name).c_str());
  workspace.place(name);
  if (pressed) edit = file;
  return pressed;
}

}  // namespace tyndall::editor
