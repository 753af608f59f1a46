// GPU times as a stacked graph and a table.
#pragma once

#include "app/session.hpp"
#include "pass_history.hpp"
#include "workspace.hpp"

namespace tyndall::editor {

class TimesPanel {
 public:
  /// Notes the times of the newest finished frame; in every frame, whether the panel is seen or not.
  void take(const app::Session& session);
  /// Another level: its medians and worst times are its own.
  void restart() { history_.clear(); }
  /// Fills the rest of the current ImGui window. `budgetMs` is the line in the graph; the user can drag it.
  void draw(double& budgetMs, Workspace& workspace);

 private:
  void graph(double budgetMs, float height);
  void table();

  PassHistory history_;
  std::uint64_t taken_ = 0;  ///< finished frames of the session seen so far
};

}  // namespace tyndall::editor
