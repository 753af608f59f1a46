// What every research panel is given in a frame.
#pragma once

#include <map>
#include <string>

#include "imgui_renderer.hpp"
#include "laboratory.hpp"
#include "workspace.hpp"

namespace tyndall::editor {

struct ResearchContext {
  app::Session& session;
  Workspace& workspace;
  ImGuiRenderer& renderer;
  Shot shot;             ///< what the viewport shows or is about to
  bool settled = false;  ///< it has been the same for a moment: background work is worth its while
  std::map<std::string, render::ViewRole> roles;  ///< of every debug view that the present layout has
  std::function<Laboratory*()> laboratory;        ///< opens it at its first use; null: it cannot be, which was told

  /// Name of the view with a role, or "".
  std::string viewOf(render::ViewRole role) const {
    for (const auto& [name, has] : roles)
      if (has == role) return name;
    return "";
  }
};

}  // namespace tyndall::editor
