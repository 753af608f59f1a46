#include "parameter_widget.hpp"

#include <cmath>
#include <cstdint>
#include <string>

#include <imgui.h>

namespace tyndall::editor {
namespace {

using params::Parameter;

bool isBuilt(const Parameter& parameter, std::size_t choice) {
  return parameter.built.empty() || parameter.built.at(choice);
}

std::optional<double> checkbox(const Parameter& parameter, double value) {
  bool on = value != 0;
  const bool other = isBuilt(parameter, on ? 0 : 1);
  if (!other) ImGui::BeginDisabled();
  const bool clicked = ImGui::Checkbox("##value", &on);
  if (!other) ImGui::EndDisabled();
  return clicked ? std::optional<double>(on ? 1 : 0) : std::nullopt;
}

std::optional<double> combo(const Parameter& parameter, double value, Workspace& workspace) {
  std::optional<double> chosen;
  if (!ImGui::BeginCombo("##value", params::toText(parameter, value).c_str(), ImGuiComboFlags_HeightLarge))
    return chosen;
  for (std::size_t i = 0; i < parameter.choices.size(); ++i) {
    const bool built = isBuilt(parameter, i), current = static_cast<double>(i) == value;
    const std::string label = parameter.choices[i] + (built ? "" : "  (not built yet)");
    if (ImGui::Selectable(label.c_str(), current, built ? 0 : ImGuiSelectableFlags_Disabled))
      chosen = static_cast<double>(i);
    workspace.place(parameter.id + "=" + parameter.choices[i]);
    if (current) ImGui::SetItemDefaultFocus();
  }
  ImGui::EndCombo();
  return chosen;
}

std::optional<double> slider(const Parameter& parameter, double value) {
  const ImGuiSliderFlags flags = parameter.logarithmic ? ImGuiSliderFlags_Logarithmic : 0;
  if (parameter.type == params::Type::kInt) {
    auto whole = static_cast<std::int64_t>(std::llround(value));
    const auto low = static_cast<std::int64_t>(parameter.builtMin),
               high = static_cast<std::int64_t>(parameter.builtMax);
    if (ImGui::SliderScalar("##value", ImGuiDataType_S64, &whole, &low, &high, nullptr, flags))
      return static_cast<double>(whole);
    return std::nullopt;
  }
  if (ImGui::SliderScalar("##value", ImGuiDataType_Double, &value, &parameter.builtMin, &parameter.builtMax, "%.4g",
                          flags))
    return value;
  return std::nullopt;
}

}  // namespace

std::optional<double> parameterWidget(const Parameter& parameter, double value, Workspace& workspace) {
  switch (parameter.type) {
    case params::Type::kBool: return checkbox(parameter, value);
    case params::Type::kEnum: return combo(parameter, value, workspace);
    case params::Type::kInt:
    case params::Type::kFloat: return slider(parameter, value);
  }
  return std::nullopt;
}

void parameterTooltip(const Parameter& parameter, bool isRead) {
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * 28);
  ImGui::TextUnformatted(parameter.doc.c_str());
  ImGui::Separator();
  ImGui::TextUnformatted(parameter.id.c_str());
  const std::string unit = parameter.unit.empty() ? "" : " " + parameter.unit;
  ImGui::Text("default %s%s", params::toText(parameter, parameter.defaultValue).c_str(), unit.c_str());
  if (parameter.type == params::Type::kInt || parameter.type == params::Type::kFloat) {
    ImGui::Text("%s to %s%s", params::toText(parameter, parameter.min).c_str(),
                params::toText(parameter, parameter.max).c_str(), unit.c_str());
    if (parameter.builtMin > parameter.min || parameter.builtMax < parameter.max)
      ImGui::Text("built so far: %s to %s", params::toText(parameter, parameter.builtMin).c_str(),
                  params::toText(parameter, parameter.builtMax).c_str());
  }
  if (!isRead) ImGui::TextUnformatted("Not read by the technique chosen.");
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

}  // namespace tyndall::editor
