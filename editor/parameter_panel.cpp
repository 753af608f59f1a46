#include "parameter_panel.hpp"

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

#include "parameter_widget.hpp"

namespace tyndall::editor {
namespace {

std::string groupOf(const std::string& id) { return id.substr(0, id.find('.')); }

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string titleOf(std::string group) {
  if (!group.empty()) group[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(group[0])));
  return group;
}

/// Groups in the order of the effect first, the engine's after it; any other comes last.
std::vector<std::string> groupsOf(const params::Table& table) {
  std::vector<std::string> groups;
  for (const char* known : {"volumetrics", "medium", "shadows", "view"})
    if (std::any_of(table.parameters().begin(), table.parameters().end(),
                    [&](const auto& p) { return groupOf(p.id) == known; }))
      groups.push_back(known);
  for (const params::Parameter& parameter : table.parameters())
    if (const std::string group = groupOf(parameter.id); std::find(groups.begin(), groups.end(), group) == groups.end())
      groups.push_back(group);
  return groups;
}

/// Whether a change of the parameter can change the picture now.
bool isRead(const app::Catalogue& catalogue, const params::Parameter& parameter) {
  const params::Table& table = catalogue.table();
  if (parameter.id == "shadows.precision") return catalogue.readsShadowMoments();
  if (parameter.owner == "engine") return true;
  const host::Plugin& plugin = catalogue.effectPlugin();
  if (parameter.owner != plugin.id()) return false;
  const std::string enabled = plugin.id() + ".enabled";
  if (parameter.id == enabled) return true;
  if (table.find(enabled) && table.value(enabled) == 0) return false;
  if (plugin.selector() < plugin.parameters().size() && plugin.parameters()[plugin.selector()].id == parameter.id)
    return true;
  const host::TechniqueInfo* technique = catalogue.technique();
  return technique &&
         std::find(technique->reads.begin(), technique->reads.end(), parameter.id) != technique->reads.end();
}

}  // namespace

bool ParameterPanel::found(const params::Parameter& parameter) const {
  const std::string sought = lower(sought_.data());
  return sought.empty() ||
         lower(parameter.id + "\n" + parameter.name + "\n" + parameter.doc).find(sought) != std::string::npos;
}

void ParameterPanel::header(app::Catalogue& catalogue, Workspace& workspace) {
  if (ImGui::SmallButton("reset all")) {
    catalogue.table().resetToDefaults();
    workspace.changed = true;
    workspace.tell("every parameter has its default value", false);
  }
  workspace.place("reset all");
  ImGui::SameLine();
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(4, 0));
  ImGui::Checkbox("changed", &changedOnly_);
  workspace.place("changed only");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Shows only values other than the default.");
  ImGui::SameLine();
  if (std::exchange(focusSearch_, false)) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##search", "search (Ctrl+F)", sought_.data(), sought_.size(),
                           ImGuiInputTextFlags_AutoSelectAll);
  workspace.place("search");
  ImGui::PopStyleVar();
}

void ParameterPanel::draw(app::Session& session, Workspace& workspace) {
  app::Catalogue& catalogue = session.catalogue();
  header(catalogue, workspace);
  const params::Table& table = catalogue.table();
  std::size_t shown = 0;
  for (const std::string& group : groupsOf(table)) {
    std::vector<const params::Parameter*> rows;
    std::size_t changed = 0;
    for (const params::Parameter& parameter : table.parameters()) {
      if (groupOf(parameter.id) != group) continue;
      changed += table.changed(parameter.id);
      if (found(parameter) && (!changedOnly_ || table.changed(parameter.id))) rows.push_back(&parameter);
    }
    if (rows.empty()) continue;
    shown += rows.size();
    const std::string title =
        titleOf(group) + (changed ? "  (" + std::to_string(changed) + " changed)" : "") + "###" + group;
    if (!ImGui::CollapsingHeader(title.c_str(), ImGuiTreeNodeFlags_DefaultOpen)) continue;
    if (!ImGui::BeginTable(group.c_str(), 3, ImGuiTableFlags_SizingStretchProp)) continue;
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch, 0.45f);
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch, 0.55f);
    ImGui::TableSetupColumn("reset", ImGuiTableColumnFlags_WidthFixed, ImGui::GetFrameHeight());
    for (const params::Parameter* parameter : rows) row(session, *parameter, workspace);
    ImGui::EndTable();
  }
  if (shown == 0)
    ImGui::TextColored(kDimColor, "%s", changedOnly_ ? "no changed parameter matches" : "no parameter matches");
}

void ParameterPanel::row(app::Session& session, const params::Parameter& parameter, Workspace& workspace) {
  const app::Catalogue& catalogue = session.catalogue();
  params::Table& table = session.table();
  const bool read = isRead(catalogue, parameter), changed = table.changed(parameter.id);
  ImGui::PushID(parameter.id.c_str());
  ImGui::TableNextRow();
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, read ? 1.0f : 0.45f);

  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  const std::string label = parameter.name + (parameter.unit.empty() ? "" : " (" + parameter.unit + ")");
  if (changed) ImGui::PushStyleColor(ImGuiCol_Text, kChangedColor);
  ImGui::TextUnformatted(label.c_str());
  if (changed) ImGui::PopStyleColor();
  const bool labelDoubleClicked = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  ImGui::PopStyleVar();
  parameterTooltip(parameter, read);

  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, read ? 1.0f : 0.45f);
  ImGui::TableNextColumn();
  ImGui::SetNextItemWidth(-1);
  const bool waits = pending_ && pending_->id == parameter.id;
  const auto value = parameterWidget(parameter, waits ? pending_->value : table.value(parameter.id), workspace);
  workspace.place(parameter.id);
  if (parameter.id == "view.auto_exposure") {
    ImGui::SameLine();
    static constexpr const char* kSources[] = {"measured", "the level's", "fixed"};
    ImGui::TextDisabled("%s, factor %.3g", kSources[static_cast<int>(session.exposureSource())],
                        session.exposureFactor());
  }
  const bool slides = parameter.type == params::Type::kInt || parameter.type == params::Type::kFloat;
  if (value && slides && parameter.structural)
    pending_ = Pending{parameter.id, *value};
  else if (value)
    set(table, parameter.id, *value, workspace);
  if (pending_ && pending_->id == parameter.id && !ImGui::IsItemActive())
    set(table, parameter.id, std::exchange(pending_, std::nullopt)->value, workspace);
  ImGui::PopStyleVar();
  if (!ImGui::IsItemActive()) parameterTooltip(parameter, read);

  ImGui::TableNextColumn();
  if (changed) {
    if (ImGui::ArrowButton("##reset", ImGuiDir_Left) || labelDoubleClicked) {
      table.reset(parameter.id);
      workspace.changed = true;
    }
    workspace.place("reset " + parameter.id);
    if (ImGui::IsItemHovered())
      ImGui::SetTooltip("back to %s", params::toText(parameter, parameter.defaultValue).c_str());
  }
  ImGui::PopID();
}

void ParameterPanel::set(params::Table& table, const std::string& id, double value, Workspace& workspace) {
  if (auto done = table.set(id, value); !done) {
    workspace.tell(done.error().message, true);
    return;
  }
  workspace.changed = true;
}

}  // namespace tyndall::editor
