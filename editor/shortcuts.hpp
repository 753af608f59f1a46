// Commands and their keys: one table makes the menu's texts, the keyboard and the F1 overlay.
#pragma once

#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "input_queue.hpp"

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
  kHelp,
  kCloseTop
};

struct Shortcut {
  Command command;
  const char* name;  ///< in the menu; also the widget's name in the state file; null: as the command's first row
  const char* keys;  ///< as shown; null: none, or those of a row before
  const char* does;  ///< one line for the overlay; null: as the command's first row
  int key = 0;       ///< GLFW_KEY_*
  bool control = false, shift = false;
};

std::span<const Shortcut> shortcuts();
const Shortcut& shortcutOf(Command command);

/// Commands of the keys that went down in a frame. While a text is typed only those with Ctrl that no text field uses
/// itself, and F1.
std::vector<Command> commandsOf(std::span<const KeyPress> presses, bool typing);

/// Keys that fly while they are held.
struct FlightKey {
  int key;           ///< GLFW_KEY_*, by its place on the keyboard
  const char* name;  ///< as shown
  glm::vec3 push;    ///< right, up (of the world), forward
  const char* does;
};
std::span<const FlightKey> flightKeys();

}  // namespace tyndall::editor
