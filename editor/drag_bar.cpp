#include "drag_bar.hpp"

#include <algorithm>
#include <cmath>

namespace tyndall::editor {
namespace {

constexpr float kGrip = 5;  // how thick a bar is, points

}  // namespace

bool dragBar(const char* name, Edge edge, float now, float least, float most, float& kept, Workspace& workspace) {
  const bool left = edge == Edge::kLeft;
  const ImVec2 room = ImGui::GetContentRegionAvail(), low = ImGui::GetCursorScreenPos();
  const ImVec2 size{std::max(left ? kGrip : room.x, 1.0f), std::max(left ? room.y : kGrip, 1.0f)};
  ImGui::InvisibleButton(name, size);
  workspace.place(name);
  float* const before = ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID(name));
  const bool held = ImGui::IsItemActive();
  if (ImGui::IsItemActivated()) *before = now;
  if (held || ImGui::IsItemHovered())
    ImGui::SetMouseCursor(left ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    kept = 0;
  } else if (held && ImGui::IsMouseDragging(ImGuiMouseButton_Left)) {
    const ImVec2 moved = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left);
    kept = std::max(std::min(*before - (left ? moved.x : moved.y), most), least);
  }
  const ImU32 colour = ImGui::GetColorU32(held                     ? ImGuiCol_SeparatorActive
                                          : ImGui::IsItemHovered() ? ImGuiCol_SeparatorHovered
                                                                   : ImGuiCol_Separator);
  const float middle = std::floor(kGrip / 2);
  if (left)
    ImGui::GetWindowDrawList()->AddLine({low.x + middle, low.y}, {low.x + middle, low.y + size.y}, colour);
  else
    ImGui::GetWindowDrawList()->AddLine({low.x, low.y + middle}, {low.x + size.x, low.y + middle}, colour);
  return held;
}

}  // namespace tyndall::editor
