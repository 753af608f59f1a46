// GPU times as a stacked graph and a table; what was skipped and why; memory.
#pragma once

#include "app/session.hpp"
#include "pass_history.hpp"
#include "workspace.hpp"

namespace tyndall::editor {

class TimesPanel {
 public:
  /// Fills the rest of the current ImGui window. `budgetMs` is the line in the graph; the user can drag it.
  void draw(const app::Session& session, double& budgetMs, Workspace& workspace);
  /// Lines of what the last frame left out, and where memory goes.
  void drawSkipped(app::Session& session, Workspace& workspace);

 private:
  void graph(double budgetMs, float height);
  void table();

  PassHistory history_;
  std::uint64_t taken_ = 0;  ///< finished frames of the session seen so far
};

}  // namespace tyndall::editor
