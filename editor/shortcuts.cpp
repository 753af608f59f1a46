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
    {Command::kRedo, "Redo", "Ctrl+Shift+Z", "makes it again", GLFW_KEY_Z, true, true},
    {Command::kRedo, nullptr, "Ctrl+Y", nullptr, GLFW_KEY_Y, true},
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
    {Command::kCloseTop, "Close", "Esc", "what is on top: a menu, a dialog, a window; then lets go of what is dragged",
     GLFW_KEY_ESCAPE},
};

constexpr FlightKey kFlightKeys[] = {
    {GLFW_KEY_W, "W", {0, 0, 1}, "flies forward"}, {GLFW_KEY_A, "A", {-1, 0, 0}, "flies left"},
    {GLFW_KEY_S, "S", {0, 0, -1}, "flies back"},   {GLFW_KEY_D, "D", {1, 0, 0}, "flies right"},
    {GLFW_KEY_Q, "Q", {0, -1, 0}, "flies down"},   {GLFW_KEY_E, "E", {0, 1, 0}, "flies up"},
};

}  // namespace

std::span<const Shortcut> shortcuts() { return kShortcuts; }

const Shortcut& shortcutOf(Command command) {
  const Shortcut* found = kShortcuts;
  while (found->command != command) ++found;
  return *found;
}

std::span<const FlightKey> flightKeys() { return kFlightKeys; }

std::vector<Command> commandsOf(std::span<const KeyPress> presses, bool typing) {
  std::vector<Command> commands;
  for (const KeyPress& press : presses)
    for (const Shortcut& shortcut : kShortcuts) {
      if (shortcut.key != press.key || shortcut.control != press.control ||
          shortcut.shift != (press.shift && shortcut.control))
        continue;
      const bool ofTheField = shortcut.key == GLFW_KEY_Z || shortcut.key == GLFW_KEY_Y;  // it undoes its own typing
      if (typing && (ofTheField || !shortcut.control) && shortcut.key != GLFW_KEY_F1) continue;
      commands.push_back(shortcut.command);
    }
  return commands;
}

}  // namespace tyndall::editor
