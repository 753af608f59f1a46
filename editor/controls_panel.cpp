#include "controls_panel.hpp"

namespace tyndall::editor {
namespace {

void cameraLine(const FlyCamera& camera, Workspace& workspace) {
  ImGui::AlignTextToFramePadding();
  if (camera.flown())
    ImGui::Text("flown by hand, %.3g m/s", static_cast<double>(camera.speed()));
  else
    ImGui::TextUnformatted("the file's camera");
  ImGui::SameLine();
  ImGui::BeginDisabled(!camera.flown());
  if (ImGui::Button("reset (F)")) workspace.cameraReset = true;
  ImGui::EndDisabled();
  workspace.place("camera reset");
}

void timeLine(const app::Level& level, Workspace& workspace) {
  if (level.scene.animations.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, kDimColor);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("nothing is animated");
    ImGui::PopStyleColor();
    return;
  }
  if (ImGui::Button(workspace.playing ? "pause" : "play")) workspace.playing = !workspace.playing;
  workspace.place("play");
  ImGui::SameLine();
  if (ImGui::Button("to 0")) workspace.seconds = 0, workspace.changed = true;
  workspace.place("time 0");
  ImGui::SameLine();
  ImGui::Text("%.2f s", workspace.seconds);
}

void viewCombo(const app::Session& session, Workspace& workspace) {
  ImGui::SetNextItemWidth(-1);
  const bool open =
      ImGui::BeginCombo("##view", workspace.debugView.empty() ? "the picture" : workspace.debugView.c_str());
  workspace.place("debug view");
  if (!open) return;
  const auto choose = [&](const std::string& name, const char* label, const std::string& doc) {
    if (ImGui::Selectable(label, workspace.debugView == name)) workspace.debugView = name, workspace.changed = true;
    if (ImGui::IsItemVisible()) workspace.place("show " + name);
    if (!doc.empty() && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", doc.c_str());
  };
  choose("", "the picture", "");
  for (const render::DebugViewInfo& view : session.debugViews()) choose(view.name, view.name.c_str(), view.doc);
  ImGui::EndCombo();
}

}  // namespace

void drawControls(const app::Session& session, const FlyCamera& camera, Workspace& workspace) {
  const app::Level& level = *session.level();
  if (ImGui::BeginTable("controls", 2, ImGuiTableFlags_SizingFixedFit)) {
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed);
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
    const auto line = [](const char* name) {
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      ImGui::AlignTextToFramePadding();
      ImGui::TextUnformatted(name);
      ImGui::TableNextColumn();
    };
    line("Level");
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(level.name.c_str());
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", level.path.c_str());
    line("Camera");
    cameraLine(camera, workspace);
    line("Time");
    timeLine(level, workspace);
    line("View");
    viewCombo(session, workspace);
    line("Reload");
    if (ImGui::Button("plugin")) workspace.reloadPlugin = true;
    workspace.place("reload plugin");
    if (ImGui::IsItemHovered())
      ImGui::SetTooltip("Loads the plugin again, values are kept. A rebuilt one is noticed by itself.");
    ImGui::SameLine();
    if (ImGui::Button("shaders")) workspace.reloadShaders = true;
    workspace.place("reload shaders");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Compiles changed shaders again. Changes are noticed by themselves.");
    line("Render");
    if (ImGui::Checkbox("without pause", &workspace.continuous)) workspace.changed = true;
    workspace.place("continuous");
    if (ImGui::IsItemHovered())
      ImGui::SetTooltip("Also when nothing has changed: times are then of the running state.");
    ImGui::EndTable();
  }
}

}  // namespace tyndall::editor
