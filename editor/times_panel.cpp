#include "times_panel.hpp"

#include <algorithm>
#include <cmath>

namespace tyndall::editor {
namespace {

constexpr double kMinBudget = 0.05, kMaxBudget = 1000;  // ms
constexpr float kGraphHeight = 64;                      // points, of normal text

/// Neighbouring passes get hues far apart (the golden ratio's steps); the engine's are paler.
ImU32 colourOf(std::size_t place, bool engine) {
  const float hue = std::fmod(static_cast<float>(place) * 0.618034f, 1.0f);
  return ImColor::HSV(hue, engine ? 0.25f : 0.65f, engine ? 0.55f : 0.85f);
}

void timeRow(const PassHistory::Line& line, ImU32 colour) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  if (!line.ran) ImGui::PushStyleColor(ImGuiCol_Text, kDimColor);
  if (colour) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float side = ImGui::GetTextLineHeight() * 0.6f;
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y + side * 0.4f}, {at.x + side, at.y + side * 1.4f}, colour);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + side + 3);
  }
  ImGui::TextUnformatted(line.name == "  of it" ? line.owner.c_str() : line.name.c_str());
  if (ImGui::IsItemHovered() && !line.owner.empty()) ImGui::SetTooltip("%s: %s", line.owner.c_str(), line.name.c_str());
  for (const double value : {line.current, line.median, line.worst}) {
    ImGui::TableNextColumn();
    ImGui::Text("%7.2f", value);
  }
  if (!line.ran) ImGui::PopStyleColor();
}

}  // namespace

void TimesPanel::graph(double budgetMs, float height) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = std::max(ImGui::GetContentRegionAvail().x, 1.0f);
  ImGui::InvisibleButton("graph", {width, height});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, {low.x + width, low.y + height}, IM_COL32(18, 19, 22, 255));
  const double top = 1.1 * std::max(history_.total().worst, budgetMs);
  const auto yOf = [&](double ms) { return low.y + height * static_cast<float>(1 - ms / top); };
  const float step = width / static_cast<float>(PassHistory::kFrames);
  float x = low.x + width - step * static_cast<float>(history_.frames().size());  // the newest at the right
  for (const PassHistory::Frame& frame : history_.frames()) {
    double sum = 0;
    for (std::size_t place = 0; place < history_.order().size(); ++place) {
      const auto found = frame.find(history_.order()[place]);
      if (found == frame.end()) continue;
      list.AddRectFilled({x, yOf(sum + found->second)}, {x + step, yOf(sum)},
                         colourOf(place, found->first.first == "engine"));
      sum += found->second;
    }
    x += step;
  }
  const bool over = history_.total().current > budgetMs;
  list.AddLine({low.x, yOf(budgetMs)}, {low.x + width, yOf(budgetMs)},
               over ? IM_COL32(255, 115, 102, 255) : IM_COL32(130, 220, 130, 255));
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip("the last %zu of %zu frames; the line is the budget", history_.frames().size(),
                      PassHistory::kFrames);
}

void TimesPanel::table() {
  const ImGuiTableFlags flags = ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY;
  if (!ImGui::BeginTable("passes", 4, flags, ImGui::GetContentRegionAvail())) return;
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn("Pass", ImGuiTableColumnFlags_WidthStretch);
  // Widths by what is usual: columns that fit themselves lag a frame behind and jump.
  for (const char* title : {"  now ms", " median", "  worst"})
    ImGui::TableSetupColumn(title, ImGuiTableColumnFlags_WidthFixed, ImGui::CalcTextSize("00000.00").x);
  ImGui::TableHeadersRow();
  ImGui::PushStyleColor(ImGuiCol_Text, kChangedColor);
  timeRow(history_.total(), 0);
  ImGui::PopStyleColor();
  for (const PassHistory::Line& line : history_.owners()) timeRow(line, 0);
  const std::vector<PassHistory::Line> lines = history_.lines();
  for (std::size_t place = 0; place < lines.size(); ++place)
    timeRow(lines[place], colourOf(place, lines[place].owner == "engine"));
  ImGui::EndTable();
}

void TimesPanel::take(const app::Session& session) {
  if (session.finishedFrames() == taken_) return;
  taken_ = session.finishedFrames();
  history_.add(session.lastPassTimes());
}

void TimesPanel::draw(double& budgetMs, Workspace& workspace) {
  if (history_.frames().empty()) return;
  ImGui::SetNextItemWidth(scaled(90));
  ImGui::DragScalar("budget", ImGuiDataType_Double, &budgetMs, 0.1f, &kMinBudget, &kMaxBudget, "%.2f ms",
                    ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
  workspace.place("budget");
  ImGui::SameLine();
  if (ImGui::SmallButton("clear")) {
    history_.clear();
    return;
  }
  workspace.place("clear times");
  const PassHistory::Line total = history_.total();
  ImGui::SameLine();
  if (total.current > budgetMs)
    ImGui::TextColored(kErrorColor, "%.2f ms over", total.current - budgetMs);
  else
    ImGui::Text("%.2f ms left", budgetMs - total.current);
  graph(budgetMs, scaled(kGraphHeight));
  workspace.place("times graph");
  table();
}

}  // namespace tyndall::editor
