// Commands of the menu and their keys: one table makes the menu's texts, the keyboard and the F1 overlay.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "window.hpp"

namespace tyndall::editor {

enum class Command {
  kOpenLevel,
  kLoadPreset,
  kSavePreset,
  kComparePreset,
  kCapture,
  kQuit,
  kUndo,
  kRedo,
  kHistory,
  kResetAll,
  kSearch,
  kResetCamera,
  kPanels,
  kLargerText,
  kSmallerText,
  kNormalText,
  kResetLayout,
  kHelp
};

struct Shortcut {
  Command command;
  const char* name;  ///< in the menu; also the widget's name in the state file
  const char* keys;  ///< as shown; null: none
  const char* does;  ///< one line for the overlay
  int key = 0;       ///< GLFW_KEY_*
  bool control = false, shift = false;
};

std::span<const Shortcut> shortcuts();
const Shortcut& shortcutOf(Command command);

class Shortcuts {
 public:
  /// Commands whose keys went down since the last call. While a text is typed only those with Ctrl that no text field
  /// uses itself.
  std::vector<Command> pressed(const Window& window, bool typing);

 private:
  std::map<int, bool> down_;
};

}  // namespace tyndall::editor
