#include "views_walk.hpp"

#include <algorithm>
#include <bit>
#include <cstdio>
#include <string>

namespace tyndall::editor {
namespace {

using render::ViewRole;

constexpr float kCountScale = 65535;            // counts are stored over it
constexpr std::size_t kMostTexels = 32u << 20;  // of all levels together: half a gigabyte while they are read

/// The levels' views in their order.
std::vector<std::string> levelViews(const ResearchContext& context, bool* across = nullptr) {
  std::vector<std::string> names;
  for (const render::DebugViewInfo& view : context.session.debugViews())
    if (view.role == ViewRole::kWalkLevel || view.role == ViewRole::kWalkLevelAcross) {
      names.push_back(view.name);
      if (across) *across = view.role == ViewRole::kWalkLevelAcross;
    }
  return names;
}

bool tooLarge(glm::uvec2 rows, std::size_t levels) {
  return std::size_t{rows.x} * std::bit_ceil(std::max(rows.y, 1u)) * levels > kMostTexels;
}

}  // namespace

std::vector<app::ViewRequest> WalkView::requests(const ResearchContext& context, glm::uvec2 rows) const {
  std::vector<app::ViewRequest> list;
  if (!open || rows.x == 0 || !offered(context)) return list;
  const std::vector<std::string> levels = levelViews(context);
  if (tooLarge(rows, levels.size())) return list;
  list.push_back({context.viewOf(ViewRole::kWalkRanks)});
  for (const std::string& name : levels) list.push_back({name});
  return list;
}

void WalkView::take(const ResearchContext& context, const std::vector<app::ViewPicture>& pictures) {
  ranks_ = {};
  levels_.clear();
  const auto find = [&](const std::string& name) -> const app::ViewPicture* {
    for (const app::ViewPicture& picture : pictures)
      if (picture.name == name && picture.width > 0) return &picture;
    return nullptr;
  };
  const app::ViewPicture* ranks = find(context.viewOf(ViewRole::kWalkRanks));
  if (!ranks) return;
  for (const std::string& name : levelViews(context, &across_)) {
    const app::ViewPicture* picture = find(name);
    if (!picture || picture->channels < 2) return levels_.clear();
    Level& level = levels_.emplace_back();
    level.width = picture->width;
    level.texels.resize(std::size_t{picture->width} * picture->height);
    for (std::size_t i = 0; i < level.texels.size(); ++i)
      level.texels[i] = {picture->values[i * picture->channels] * kCountScale,
                         picture->values[i * picture->channels + 1]};
  }
  ranks_ = *ranks;
}

WalkRow WalkView::rowOf(std::uint32_t slice) const {
  WalkRow row;
  for (std::uint32_t bin = 0; bin < ranks_.height; ++bin) row.before.push_back(ranks_.at(slice, bin, 0) * kCountScale);
  for (const Level& level : levels_) {
    const std::size_t height = level.texels.size() / level.width, count = across_ ? level.width : height;
    std::vector<WalkRow::Texel>& texels = row.levels.emplace_back(count);
    for (std::size_t p = 0; p < count; ++p)
      texels[p] = across_ ? level.texels[slice * level.width + p] : level.texels[p * level.width + slice];
  }
  return row;
}

void WalkView::draw(ResearchContext& context, glm::uvec2 rows, const std::optional<glm::vec3>& end) {
  if (!open) return;
  ImGui::SetNextWindowSize({scaled(640), scaled(270)}, ImGuiCond_FirstUseEver);
  // Above the row's own window, which is low in the corner.
  ImGui::SetNextWindowPos({6, std::max(ImGui::GetIO().DisplaySize.y - 560, 60.0f)}, ImGuiCond_FirstUseEver);
  if (ImGui::Begin("Walk in the map", &open, ImGuiWindowFlags_NoFocusOnAppearing)) {
    if (!offered(context))
      ImGui::TextUnformatted("The technique in use searches no sorted rows.");
    else if (tooLarge(rows, levelViews(context).size()))
      ImGui::TextWrapped("The maps of %u x %u are too large to be read as a whole: fewer columns or slices show it.",
                         rows.x, rows.y);
    else if (levels_.empty())
      ImGui::TextUnformatted("Waiting for the maps ...");
    else if (!end)
      ImGui::TextColored(kDimColor, "point at the picture to see its ray's search");
    else {
      const glm::uvec2 at(std::min(static_cast<std::uint32_t>(end->x * static_cast<float>(rows.x)), rows.x - 1),
                          std::min(static_cast<std::uint32_t>(end->y * static_cast<float>(rows.y)), rows.y));
      const Walk walk = walkOf(rowOf(std::min(at.x, ranks_.width - 1)), at.y, end->z);
      char fact[160];
      std::snprintf(fact, sizeof fact, "%u %u %.6g %u %u %.9g %zu", at.x, walk.elements, walk.rank, walk.blockers,
                    walk.left, walk.blocked, walk.steps.size());
      context.workspace.facts["walk"] = fact;
      ImGui::Text("slice %u: of the first %u columns, which blockers lie before depth %.5f, rank %.2f?", at.x,
                  walk.elements, static_cast<double>(end->z), walk.rank);
      table(walk);
      ImGui::TextColored(kChangedColor, "blocked: %u columns (%u not told apart), %.5f of the weight; lit: %.5f",
                         walk.blockers, walk.left, walk.blocked, 1 - walk.blocked);
    }
  }
  ImGui::End();
}

void WalkView::table(const Walk& walk) const {
  constexpr const char* kTitles[] = {"level", "ranks",      "columns", "first half",
                                     "share", "goes on in", "blocked", "undecided"};
  if (!ImGui::BeginTable("walk", 8, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit)) return;
  for (const char* title : kTitles) ImGui::TableSetupColumn(title);
  ImGui::TableHeadersRow();
  for (std::size_t i = 0; i < walk.steps.size(); ++i) {
    const WalkStep& step = walk.steps[i];
    ImGui::TableNextRow();
    ImGui::TableNextColumn(), ImGui::Text("%zu", i);
    ImGui::TableNextColumn(), ImGui::Text("%u ... %u", step.first, step.last - 1);
    ImGui::TableNextColumn(), ImGui::Text("%u", step.elements);
    ImGui::TableNextColumn(), ImGui::Text("%u", step.zeros);
    ImGui::TableNextColumn(), ImGui::Text("%.4f", static_cast<double>(step.share));
    ImGui::TableNextColumn(), ImGui::Text("%s", step.second ? "second" : "first");
    ImGui::TableNextColumn(), ImGui::Text("%.5f", step.blocked);
    ImGui::TableNextColumn(), ImGui::Text("%.5f", step.undecided);
  }
  ImGui::EndTable();
}

}  // namespace tyndall::editor
