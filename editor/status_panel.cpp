#include "status_panel.hpp"

#include "app/haze.hpp"

namespace tyndall::editor {
void drawStatus(app::Session& session, Workspace& workspace, std::uint32_t width, std::uint32_t height) {
  const auto& failure = session.effect().failure();
  if (failure)
    ImGui::TextColored(kErrorColor, "%s", failure->message.c_str());
  else if (session.background() != host::PluginEffect::Background::kIdle)
    ImGui::TextUnformatted("building what the new settings need; the picture is of those before");
  else if (workspace.messageIsError)
    ImGui::TextColored(kErrorColor, "%s", workspace.message.c_str());
  else if (!workspace.message.empty())
    ImGui::TextUnformatted(workspace.message.c_str());
  else if (const auto haze = app::hidingHaze(session)) {
    if (ImGui::SmallButton("show the level")) {
      if (auto set = session.table().set("medium.sigma_t", haze->sigma_t); !set)
        workspace.tell(set.error().message, true);
      workspace.changed = true;
    }
    workspace.place("show the level");
    ImGui::SameLine();
    ImGui::TextUnformatted(haze->line.c_str());
  } else
    ImGui::Text(
        "%u x %u on %s   WASD QE fly, right drag looks, Shift faster, wheel speed, F file's camera, Ctrl+Q quits",
        width, height, session.device().info().name.c_str());
  if (ImGui::IsItemHovered() && (failure || !workspace.message.empty()))
    ImGui::SetTooltip("%s", failure ? failure->message.c_str() : workspace.message.c_str());
}

}  // namespace tyndall::editor
