#include "status_panel.hpp"

#include <map>

namespace tyndall::editor {
namespace {

void timeRow(const char* name, const char* owner, double milliseconds) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(name);
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(owner);
  ImGui::TableNextColumn();
  ImGui::Text("%8.2f", milliseconds);
}

}  // namespace

void drawPassTimes(const app::Session& session) {
  const ImGuiTableFlags flags = ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY;
  if (!ImGui::BeginTable("passes", 3, flags, ImGui::GetContentRegionAvail())) return;
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn("Pass", ImGuiTableColumnFlags_WidthStretch);
  // Widths by what is usual: columns that fit themselves lag a frame behind and jump.
  ImGui::TableSetupColumn("Owner", ImGuiTableColumnFlags_WidthFixed, ImGui::CalcTextSize("volumetrics").x);
  ImGui::TableSetupColumn("      ms", ImGuiTableColumnFlags_WidthFixed, ImGui::CalcTextSize("00000.00").x);
  ImGui::TableHeadersRow();
  double total = 0;
  std::map<std::string, double> byOwner;
  for (const render::PassTime& pass : session.lastPassTimes()) {
    if (pass.owner == "editor") continue;  // the copy that the window shows is no part of the frame
    total += pass.milliseconds;
    byOwner[pass.owner] += pass.milliseconds;
  }
  ImGui::PushStyleColor(ImGuiCol_Text, kChangedColor);
  timeRow("total", "", total);
  ImGui::PopStyleColor();
  if (byOwner.size() > 1)
    for (const auto& [owner, milliseconds] : byOwner) timeRow("  of it", owner.c_str(), milliseconds);
  for (const render::PassTime& pass : session.lastPassTimes())
    if (pass.owner != "editor") timeRow(pass.name.c_str(), pass.owner.c_str(), pass.milliseconds);
  ImGui::EndTable();
}

void drawStatus(app::Session& session, const Workspace& workspace, std::uint32_t width, std::uint32_t height) {
  const auto& failure = session.effect().failure();
  if (failure) ImGui::TextColored(kErrorColor, "%s", failure->message.c_str());
  else if (session.effect().background() != host::PluginEffect::Background::kIdle)
    ImGui::TextUnformatted("building what the new settings need; the picture is of those before");
  else if (workspace.messageIsError) ImGui::TextColored(kErrorColor, "%s", workspace.message.c_str());
  else if (!workspace.message.empty()) ImGui::TextUnformatted(workspace.message.c_str());
  else
    ImGui::Text("%u x %u on %s   WASD QE fly, right drag looks, Shift faster, wheel speed, F file's camera, Ctrl+Q quits", width, height,
                session.device().info().name.c_str());
  if (ImGui::IsItemHovered() && (failure || !workspace.message.empty()))
    ImGui::SetTooltip("%s", failure ? failure->message.c_str() : workspace.message.c_str());
}

}  // namespace tyndall::editor
