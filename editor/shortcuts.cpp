#include "shortcuts.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace tyndall::editor {
namespace {

constexpr Shortcut kShortcuts[] = {
    {Command::kOpenLevel, "Open level ...", "Ctrl+O", "opens a .gltf or .glb file", GLFW_KEY_O, true},
    {Command::kLoadPreset, "Load preset ...", "Ctrl+L", "parameter values from a file", GLFW_KEY_L, true},
    {Command::kSavePreset, "Save preset ...", "Ctrl+S", "writes the values that differ from their defaults", GLFW_KEY_S,
     true},
    {Command::kComparePreset, "Compare with preset ...", "Ctrl+D", "a table of the values that differ from a file's",
     GLFW_KEY_D, true},
    {Command::kCapture, "Capture ...", "Ctrl+P",
     "picture, radiance, depth, numbers of a view, figures, and the command that makes them again", GLFW_KEY_P, true},
    {Command::kQuit, "Quit", "Ctrl+Q", "ends the editor", GLFW_KEY_Q, true},
    {Command::kUndo, "Undo", "Ctrl+Z", "takes the last edit back", GLFW_KEY_Z, true},
    {Command::kRedo, "Redo", "Ctrl+Shift+Z", "makes it again; also Ctrl+Y", GLFW_KEY_Z, true, true},
    {Command::kRedo, nullptr, nullptr, nullptr, GLFW_KEY_Y, true},
    {Command::kHistory, "History", "Ctrl+H", "every edit; click one to go there", GLFW_KEY_H, true},
    {Command::kResetAll, "Reset all parameters", "Ctrl+R", "every parameter gets its default", GLFW_KEY_R, true},
    {Command::kSearch, "Search parameters", "Ctrl+F", "by name, id or help text", GLFW_KEY_F, true},
    {Command::kResetCamera, "The file's camera", "F", "which the view follows until it is flown", GLFW_KEY_F},
    {Command::kPanels, "Panels", "F10", "hides and shows the panels", GLFW_KEY_F10},
    {Command::kLargerText, "Larger text", "Ctrl++", "of the whole window", GLFW_KEY_EQUAL, true},
    {Command::kLargerText, nullptr, nullptr, nullptr, GLFW_KEY_EQUAL, true, true},
    {Command::kLargerText, nullptr, nullptr, nullptr, GLFW_KEY_KP_ADD, true},
    {Command::kSmallerText, "Smaller text", "Ctrl+-", "of the whole window", GLFW_KEY_MINUS, true},
    {Command::kSmallerText, nullptr, nullptr, nullptr, GLFW_KEY_KP_SUBTRACT, true},
    {Command::kNormalText, "Normal text", "Ctrl+0", "as large as the display asks for", GLFW_KEY_0, true},
    {Command::kResetLayout, "Reset layout", nullptr, nullptr},
    {Command::kHelp, "Keys", "F1", "this list", GLFW_KEY_F1},
};

}  // namespace

std::span<const Shortcut> shortcuts() { return kShortcuts; }

const Shortcut& shortcutOf(Command command) {
  const Shortcut* found = kShortcuts;
  while (found->command != command) ++found;
  return *found;
}

std::vector<Command> Shortcuts::pressed(const Window& window, bool typing) {
  const bool control = window.keyDown(GLFW_KEY_LEFT_CONTROL) || window.keyDown(GLFW_KEY_RIGHT_CONTROL);
  const bool shift = window.keyDown(GLFW_KEY_LEFT_SHIFT) || window.keyDown(GLFW_KEY_RIGHT_SHIFT);
  std::map<int, bool> now;
  // A tap is remembered until asked for: each key is asked for once in every frame, but those that fly (which the
  // flight asks for) only with Ctrl.
  for (const Shortcut& shortcut : kShortcuts) {
    const bool flies = shortcut.key == GLFW_KEY_S || shortcut.key == GLFW_KEY_D || shortcut.key == GLFW_KEY_Q;
    if (shortcut.key != 0 && (control || !flies) && !now.contains(shortcut.key))
      now[shortcut.key] = window.keyDown(shortcut.key);
  }
  std::vector<Command> commands;
  for (const Shortcut& shortcut : kShortcuts) {
    if (shortcut.key == 0 || !now[shortcut.key] || down_[shortcut.key] || shortcut.control != control ||
        shortcut.shift != (shift && shortcut.control))
      continue;
    const bool ofTheField = shortcut.key == GLFW_KEY_Z || shortcut.key == GLFW_KEY_Y;  // a field undoes its own typing
    if (typing && (ofTheField || !shortcut.control) && shortcut.key != GLFW_KEY_F1) continue;
    commands.push_back(shortcut.command);
  }
  down_ = std::move(now);
  return commands;
}

}  // namespace tyndall::editor
