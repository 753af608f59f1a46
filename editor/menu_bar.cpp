#include "menu_bar.hpp"

#include "app/level.hpp"

namespace tyndall::editor {
namespace {

void item(Command command, bool enabled, bool ticked, MenuChoice& choice, Workspace& workspace) {
  const Shortcut& shortcut = shortcutOf(command);
  if (ImGui::MenuItem(shortcut.name, shortcut.keys, ticked, enabled)) choice.commands.push_back(command);
  workspace.place(shortcut.name);
}

void levelItem(const std::string& name, MenuChoice& choice, Workspace& workspace) {
  if (ImGui::MenuItem(name.c_str())) choice.level = name;
  workspace.place("level " + name);
}

bool menu(const char* name, Workspace& workspace) {
  const bool open = ImGui::BeginMenu(name);
  workspace.place(std::string("menu ") + name);
  return open;
}

}  // namespace

MenuChoice MenuBar::draw(const History& history, const Settings& settings, Workspace& workspace) {
  MenuChoice choice;
  if (!ImGui::BeginMainMenuBar()) return choice;
  height_ = ImGui::GetWindowSize().y;
  const auto add = [&](Command command, bool enabled = true, bool ticked = false) {
    item(command, enabled, ticked, choice, workspace);
  };
  if (menu("File", workspace)) {
    add(Command::kOpenLevel);
    if (ImGui::BeginMenu("Samples")) {
      for (const std::string& name : app::sampleLevels()) levelItem(name, choice, workspace);
      ImGui::EndMenu();
    }
    if (ImGui::BeginMenu("Recent levels", !settings.recentLevels.empty())) {
      for (const std::string& name : settings.recentLevels) levelItem(name, choice, workspace);
      ImGui::EndMenu();
    }
    workspace.place("Recent levels");
    ImGui::Separator();
    for (Command command : {Command::kLoadPreset, Command::kSavePreset, Command::kComparePreset}) add(command);
    ImGui::Separator();
    add(Command::kCapture);
    ImGui::Separator();
    add(Command::kQuit);
    ImGui::EndMenu();
  }
  if (menu("Edit", workspace)) {
    add(Command::kUndo, history.canUndo());
    add(Command::kRedo, history.canRedo());
    for (Command command : {Command::kHistory, Command::kResetAll, Command::kSearch, Command::kResetCamera})
      add(command);
    ImGui::EndMenu();
  }
  if (menu("View", workspace)) {
    add(Command::kPanels, true, settings.layout.panels);
    for (Command command : {Command::kLargerText, Command::kSmallerText, Command::kNormalText, Command::kResetLayout})
      add(command);
    ImGui::EndMenu();
  }
  if (menu("Help", workspace)) {
    add(Command::kHelp);
    ImGui::EndMenu();
  }
  ImGui::EndMainMenuBar();
  return choice;
}

std::optional<std::size_t> drawHistory(const History& history, bool& open, Workspace& workspace) {
  std::optional<std::size_t> chosen;
  if (!open) return chosen;
  ImGui::SetNextWindowSize({scaled(260), scaled(240)}, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowPos({40, 60}, ImGuiCond_FirstUseEver);
  if (ImGui::Begin("History", &open, ImGuiWindowFlags_NoSavedSettings)) {
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(history.steps().size()));
    while (clipper.Step())
      for (int line = clipper.DisplayStart; line < clipper.DisplayEnd; ++line) {
        const auto i = static_cast<std::size_t>(line);
        ImGui::PushID(line);
        const bool undone = i > history.present();
        if (undone) ImGui::PushStyleColor(ImGuiCol_Text, kDimColor);
        if (ImGui::Selectable(history.steps()[i].label.c_str(), i == history.present())) chosen = i;
        workspace.place("history " + std::to_string(i));
        if (undone) ImGui::PopStyleColor();
        ImGui::PopID();
      }
  }
  ImGui::End();
  return chosen;
}

}  // namespace tyndall::editor
