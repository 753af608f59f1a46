#include "memory_panel.hpp"

#include <algorithm>
#include <iterator>

namespace tyndall::editor {
namespace {

constexpr double kMiB = 1024.0 * 1024;

enum Column : ImGuiID { kBytes, kName, kLives, kWhat };

std::string livesText(const app::ResourceMemory& line) {
  if (line.firstPass.empty()) return "kept";
  return line.firstPass == line.lastPass ? line.firstPass : line.firstPass + " ... " + line.lastPass;
}

bool before(const app::ResourceMemory& a, const app::ResourceMemory& b, ImGuiID column) {
  switch (column) {
    case kBytes: return a.bytes < b.bytes;
    case kName: return a.name < b.name;
    case kLives: return livesText(a) < livesText(b);
    default: return a.what < b.what;
  }
}

void summary(const char* what, std::uint64_t bytes) {
  ImGui::Text("%9.2f MiB  %s", static_cast<double>(bytes) / kMiB, what);
}

}  // namespace

void MemoryPanel::table(std::vector<app::ResourceMemory> lines, Workspace& workspace) {
  const ImGuiTableFlags flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY | ImGuiTableFlags_Sortable |
                                ImGuiTableFlags_Resizable | ImGuiTableFlags_SizingStretchProp;
  if (!ImGui::BeginTable("resources", 4, flags, ImGui::GetContentRegionAvail())) return;
  const float number = ImGui::CalcTextSize("00000.000").x;
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn(
      "MiB",
      ImGuiTableColumnFlags_WidthFixed | ImGuiTableColumnFlags_DefaultSort | ImGuiTableColumnFlags_PreferSortDescending,
      number, kBytes);
  ImGui::TableSetupColumn("resource", ImGuiTableColumnFlags_WidthStretch, 3, kName);
  ImGui::TableSetupColumn("used by", ImGuiTableColumnFlags_WidthStretch, 3, kLives);
  ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch, 4, kWhat);
  ImGui::TableHeadersRow();
  if (const ImGuiTableSortSpecs* order = ImGui::TableGetSortSpecs(); order && order->SpecsCount > 0) {
    const ImGuiTableColumnSortSpecs& by = order->Specs[0];
    std::stable_sort(lines.begin(), lines.end(), [&by](const auto& a, const auto& b) {
      return by.SortDirection == ImGuiSortDirection_Descending ? before(b, a, by.ColumnUserID)
                                                               : before(a, b, by.ColumnUserID);
    });
  }
  for (const app::ResourceMemory& line : lines) {
    const std::string lives = livesText(line);
    if (!filter_.PassFilter((line.name + ' ' + line.owner + ' ' + lives + ' ' + line.what).c_str())) continue;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::Text("%9.3f", static_cast<double>(line.bytes) / kMiB);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(line.name.c_str());
    if (ImGui::IsItemVisible()) workspace.place("memory of " + line.name);
    if (ImGui::IsItemHovered())
      ImGui::SetTooltip("%s%s%s\n%s\n%s", line.owner.c_str(), line.owner.empty() ? "" : ": ", line.name.c_str(),
                        line.what.c_str(), lives.c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(lives.c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(line.what.c_str());
  }
  ImGui::EndTable();
}

void MemoryPanel::draw(app::Session& session, Workspace& workspace) {
  summary("of the device: all that is kept", session.device().allocatedBytes());
  summary("of it shared in turn by a frame's passing images and buffers", session.statistics().transientBytes);
  summary("they would take, each on its own", session.statistics().transientBytesUnshared);
  summary("of these the effect's", session.effect().memoryBytes());
  const std::vector<std::uint64_t> lights = session.effect().lightMemoryBytes();
  for (std::size_t i = 0; i < lights.size(); ++i)
    summary(("of that used for light " + std::to_string(i)).c_str(), lights[i]);
  ImGui::SetNextItemWidth(-1);
  if (ImGui::InputTextWithHint("##memory filter", "filter: name, pass, format", filter_.InputBuf,
                               sizeof filter_.InputBuf))
    filter_.Build();
  workspace.place("memory filter");
  std::vector<app::ResourceMemory> lines = app::passingMemory(session), kept = app::keptMemory(session.device());
  workspace.facts["memory.resources"] = std::to_string(lines.size() + kept.size());
  std::move(kept.begin(), kept.end(), std::back_inserter(lines));
  table(std::move(lines), workspace);
}

void MemoryPanel::drawSkipped(app::Session& session, Workspace& workspace) {
  ImGui::BeginChild("skipped");
  ImGui::TextColored(kChangedColor, "Skipped by the effect");
  std::size_t shown = 0;
  for (const auto& [reason, count] : session.effect().counters()) {
    if (count == 0) continue;
    ImGui::Text("%9llu  %s", static_cast<unsigned long long>(count), reason.c_str());
    ++shown;
  }
  workspace.facts["skipped.count"] = std::to_string(shown);
  if (shown == 0) ImGui::TextColored(kDimColor, "nothing");
  ImGui::TextColored(kChangedColor, "Left out by the renderer");
  const std::vector<std::string>& notes = session.renderer().notes();
  ImGui::PushTextWrapPos(0);
  for (const std::string& note : notes) ImGui::TextUnformatted(note.c_str());
  for (const std::string& note : session.level()->notes) ImGui::TextUnformatted(note.c_str());
  ImGui::PopTextWrapPos();
  if (notes.empty() && session.level()->notes.empty()) ImGui::TextColored(kDimColor, "nothing");
  ImGui::EndChild();
}

}  // namespace tyndall::editor
