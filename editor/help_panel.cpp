#include "help_panel.hpp"

#include "shortcuts.hpp"

namespace tyndall::editor {
namespace {

struct Gesture {
  const char *hand, *does;
};
constexpr Gesture kGestures[] = {{"right drag", "looks around"},
                                 {"middle drag", "orbits round what is selected, or the level's middle"},
                                 {"Shift", "flies four times as fast"},
                                 {"wheel", "speed"},
                                 {"Ctrl+click", "on a slider: type a value"},
                                 {"double click", "on a name: default value"}};

void row(const std::string& keys, const char* name, const char* does) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextColored(kChangedColor, "%s", keys.c_str());
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(name);
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(does);
}

/// All keys of the command, as shown.
std::string keysOf(Command command) {
  std::string keys;
  for (const Shortcut& shortcut : shortcuts())
    if (shortcut.command == command && shortcut.keys) keys += (keys.empty() ? "" : ", ") + std::string(shortcut.keys);
  return keys;
}

}  // namespace

void drawHelp(bool& open, Workspace& workspace) {
  if (!open) return;
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {size.x, size.y});
  if (ImGui::Begin(
          "Keys", &open,
          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse) &&
      ImGui::BeginTable("keys", 3, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_RowBg)) {
    std::string listed;
    for (const FlightKey& key : flightKeys()) row(key.name, "", key.does), listed += std::string(key.name) + "; ";
    for (const Gesture& gesture : kGestures) row(gesture.hand, "", gesture.does);
    for (const Shortcut& shortcut : shortcuts()) {
      const std::string keys = keysOf(shortcut.command);
      if (!shortcut.name || keys.empty()) continue;
      row(keys, shortcut.name, shortcut.does);
      for (const Shortcut& each : shortcuts())
        if (each.command == shortcut.command && each.keys) listed += std::string(each.keys) + "; ";
      workspace.facts[std::string("help ") + shortcut.name] = keys + ": " + shortcut.does;
    }
    workspace.facts["keys"] = listed;
    const ImVec2 low = ImGui::GetWindowPos(), extent = ImGui::GetWindowSize();
    workspace.widgets["keys"] = {low.x, low.y, extent.x, extent.y};
    ImGui::EndTable();
  }
  ImGui::End();
}

}  // namespace tyndall::editor
