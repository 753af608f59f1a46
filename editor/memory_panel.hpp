// Where memory goes, resource by resource; what was left out of the frame and why.
#pragma once

#include <imgui.h>

#include "app/memory.hpp"
#include "workspace.hpp"

namespace tyndall::editor {

class MemoryPanel {
 public:
  /// Each fills the rest of the current ImGui window.
  void draw(app::Session& session, Workspace& workspace);
  static void drawSkipped(app::Session& session, Workspace& workspace);

 private:
  void table(std::vector<app::ResourceMemory> lines, Workspace& workspace);

  ImGuiTextFilter filter_;
};

}  // namespace tyndall::editor
