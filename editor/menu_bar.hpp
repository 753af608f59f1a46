// The menu along the window's upper edge, the list of edits and the F1 overlay.
#pragma once

#include <string>
#include <vector>

#include "history.hpp"
#include "settings_file.hpp"
#include "shortcuts.hpp"
#include "workspace.hpp"

namespace tyndall::editor {

struct MenuChoice {
  std::vector<Command> commands;
  std::string level;  ///< of the recent ones, or a sample's name; "" = none was chosen
};

class MenuBar {
 public:
  /// Draws the bar; its height in points is left in height().
  MenuChoice draw(const History& history, const Settings& settings, Workspace& workspace);
  float height() const { return height_; }

 private:
  float height_ = 20;
};

/// A window with every step; the one clicked, if any.
std::optional<std::size_t> drawHistory(const History& history, bool& open, Workspace& workspace);

}  // namespace tyndall::editor
