#include "lights_panel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/gtc/matrix_inverse.hpp>
#include <glm/trigonometric.hpp>

namespace tyndall::editor {
namespace {

constexpr float kMaxIntensity = 1e7f, kMaxMetres = 1e5f;
constexpr float kMaxCone = 89.9f, kConeGap = 0.1f;  // degrees: the inner cone is smaller than the outer
constexpr float kHandle = 48, kGrab = 8;            // points: length of a handle; how near the mouse takes it

const char* kindName(scene::LightKind kind) {
  switch (kind) {
    case scene::LightKind::kDirectional: return "sun";
    case scene::LightKind::kSpot: return "spot";
    case scene::LightKind::kPoint: return "point";
  }
  return "";
}

bool number(const char* name, float& value, float speed, float low, float high, const char* format,
            Workspace& workspace, ImGuiSliderFlags flags = 0) {
  ImGui::SetNextItemWidth(-90);
  const bool changed = ImGui::DragFloat(name, &value, speed, low, high, format, flags | ImGuiSliderFlags_AlwaysClamp);
  workspace.place(std::string("light ") + name);
  return changed;
}

/// A world point in points of the window; nothing behind the camera.
std::optional<glm::vec2> onScreen(const LightsPanel::Viewport& viewport, const glm::vec3& point) {
  const glm::vec3 p = glm::vec3(glm::affineInverse(viewport.camera.worldFromView) * glm::vec4(point, 1));
  if (p.z > -0.01f) return std::nullopt;  // within a centimetre of the eye, or behind it
  const float slope = std::tan(viewport.camera.camera.yfov / 2), aspect = viewport.size.x / viewport.size.y;
  const glm::vec2 ndc{p.x / (-p.z * slope * aspect), -p.y / (-p.z * slope)};
  return viewport.low + (ndc * 0.5f + 0.5f) * viewport.size;
}

ImVec2 toImGui(const glm::vec2& v) { return {v.x, v.y}; }

}  // namespace

void LightsPanel::reset(scene::Scene& scene) {
  separateLights(scene);
  file_ = lightsOf(scene);
  selected_.reset();
  drag_.reset();
}

void LightsPanel::edited(app::Session& session, const LightEdit& edit, Workspace& workspace) {
  setLight(session.editScene(), *selected_, edit);
  workspace.changed = true;
}

void LightsPanel::draw(app::Session& session, Workspace& workspace) {
  shown_ = true;
  const scene::Scene& scene = session.level()->scene;
  if (file_.empty()) return ImGui::TextWrapped("The file has no light; the sun that it gets instead cannot be edited.");
  const LightEdits changed = changedLights(scene, file_);
  ImGui::BeginChild("lights",
                    {0, std::min(ImGui::GetContentRegionAvail().y * 0.4f,
                                 ImGui::GetTextLineHeightWithSpacing() * static_cast<float>(file_.size() + 1))});
  for (const auto& [node, unused] : file_) {
    const scene::Node& at = scene.nodes[static_cast<std::size_t>(node)];
    const scene::Light& light = scene.lights[static_cast<std::size_t>(at.light)];
    const std::string name = !light.name.empty() ? light.name : !at.name.empty() ? at.name : "light";
    const bool isChanged = changed.contains(node);
    if (isChanged) ImGui::PushStyleColor(ImGuiCol_Text, kChangedColor);
    const std::string label = name + "  (" + kindName(light.kind) + ")##" + std::to_string(node);
    if (ImGui::Selectable(label.c_str(), selected_ == node)) selected_ = node;
    if (isChanged) ImGui::PopStyleColor();
    workspace.place("light at " + std::to_string(node));
  }
  ImGui::EndChild();
  ImGui::Separator();
  if (selected_)
    fields(session, workspace);
  else
    ImGui::TextColored(kDimColor, "select one here or in the picture");
}

void LightsPanel::fields(app::Session& session, Workspace& workspace) {
  const scene::Scene& scene = session.level()->scene;
  const scene::Node& node = scene.nodes[static_cast<std::size_t>(*selected_)];
  const scene::Light& light = scene.lights[static_cast<std::size_t>(node.light)];
  LightEdit edit = lightsOf(scene).at(*selected_);
  workspace.facts["light.intensity"] = std::to_string(edit.intensity);
  workspace.facts["light.translation"] = std::to_string(edit.translation.x) + " " + std::to_string(edit.translation.y) +
                                         " " + std::to_string(edit.translation.z);
  ImGui::BeginChild("fields");
  const bool sun = light.kind == scene::LightKind::kDirectional;
  bool changed = false;
  ImGui::SetNextItemWidth(-90);
  if (ImGui::ColorEdit3("colour", &edit.color.x, ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR)) {
    edit.color = glm::max(edit.color, glm::vec3(0));
    changed = true;
  }
  workspace.place("light colour");
  changed |= number(sun ? "lux" : "candela", edit.intensity, std::max(edit.intensity, 0.01f) * 0.01f, 0, kMaxIntensity,
                    "%.4g", workspace);
  if (!sun) {
    bool limited = edit.range.has_value();
    if (ImGui::Checkbox("range ends", &limited))
      edit.range = limited ? std::optional(10.0f) : std::nullopt, changed = true;
    workspace.place("light range ends");
    if (edit.range) changed |= number("range", *edit.range, 0.05f, 0.01f, kMaxMetres, "%.3g m", workspace);
  }
  if (light.kind == scene::LightKind::kSpot) {
    float outer = glm::degrees(edit.outerConeAngle), inner = glm::degrees(edit.innerConeAngle);
    if (number("outer cone", outer, 0.2f, 1, kMaxCone, "%.2f deg", workspace))
      edit.outerConeAngle = glm::radians(outer), changed = true;
    if (number("inner cone", inner, 0.2f, 0, std::max(outer - kConeGap, 0.0f), "%.2f deg", workspace))
      edit.innerConeAngle = glm::radians(inner), changed = true;
    if (changed && edit.innerConeAngle >= edit.outerConeAngle)
      edit.innerConeAngle = std::max(edit.outerConeAngle - glm::radians(kConeGap), 0.0f);
  }
  if (isMoved(scene, *selected_)) {
    ImGui::TextColored(kDimColor, "an animation places it");
  } else {
    ImGui::SetNextItemWidth(-90);
    changed |= ImGui::DragFloat3("position", &edit.translation.x, 0.02f, -kMaxMetres, kMaxMetres, "%.2f",
                                 ImGuiSliderFlags_AlwaysClamp);
    workspace.place("light position");
  }
  if (edit != file_.at(*selected_)) {
    if (ImGui::Button("as in the file")) edit = file_.at(*selected_), changed = true;
    workspace.place("light reset");
  }
  ImGui::EndChild();
  if (changed) edited(session, edit, workspace);
}

void LightsPanel::drawOver(ImDrawList& list, app::Session& session, const Viewport& viewport, Workspace& workspace) {
  if (!std::exchange(shown_, false)) {
    drag_.reset();
    return;
  }
  const scene::Scene& scene = session.level()->scene;
  const auto worldFromNode = session.level()->worldFromNode(workspace.seconds);
  const ImGuiIO& io = ImGui::GetIO();
  const glm::vec2 mouse{io.MousePos.x, io.MousePos.y};
  const bool pressed = viewport.hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) drag_.reset();
  std::optional<int> nearest;
  float nearestDistance = kGrab;
  for (const auto& [node, unused] : file_) {
    const scene::Light& light =
        scene.lights[static_cast<std::size_t>(scene.nodes[static_cast<std::size_t>(node)].light)];
    if (light.kind == scene::LightKind::kDirectional) continue;  // a sun is nowhere
    const auto at = onScreen(viewport, glm::vec3(worldFromNode[static_cast<std::size_t>(node)][3]));
    if (!at) continue;
    list.AddCircle(toImGui(*at), 6, node == selected_ ? IM_COL32(255, 204, 89, 255) : IM_COL32(255, 255, 255, 160), 16,
                   2);
    if (const float distance = glm::distance(*at, mouse); distance < nearestDistance)
      nearest = node, nearestDistance = distance;
  }
  if (selected_ && !isMoved(scene, *selected_)) {
    const glm::vec3 place(worldFromNode[static_cast<std::size_t>(*selected_)][3]);
    const scene::LightKind kind =
        scene.lights[static_cast<std::size_t>(scene.nodes[static_cast<std::size_t>(*selected_)].light)].kind;
    const auto at = onScreen(viewport, place);
    if (at && kind != scene::LightKind::kDirectional) {
      // A handle is a part of the axis that spans about as many points wherever the light is.
      const float depth = -(glm::affineInverse(viewport.camera.worldFromView) * glm::vec4(place, 1)).z;
      const float metres = kHandle * 2 * depth * std::tan(viewport.camera.camera.yfov / 2) / viewport.size.y;
      for (int i = 0; i < 3; ++i) {
        glm::vec3 axis{0};
        axis[i] = 1;
        const auto end = onScreen(viewport, place + axis * metres);
        if (!end) continue;
        const ImU32 colour = IM_COL32(i == 0 ? 240 : 70, i == 1 ? 220 : 70, i == 2 ? 255 : 70, 255);
        list.AddLine(toImGui(*at), toImGui(*end), colour, 2);
        list.AddCircleFilled(toImGui(*end), 5, colour);
        workspace.widgets[std::string("handle ") + "xyz"[i]] = {end->x - 4, end->y - 4, 8, 8};
        const glm::vec2 perMetre = (*end - *at) / metres;
        if (pressed && glm::distance(*end, mouse) < kGrab &&
            glm::length(perMetre) * metres > 4) {  // one that points at the eye leads nowhere
          drag_ = Drag{axis, lightsOf(scene).at(*selected_).translation, mouse, perMetre};
          nearest.reset();
        }
      }
    }
  }
  if (pressed && nearest && !drag_) selected_ = nearest;
  if (drag_ && selected_) {
    const float along = glm::dot(mouse - drag_->mouse, drag_->perMetre) / glm::dot(drag_->perMetre, drag_->perMetre);
    LightEdit edit = lightsOf(scene).at(*selected_);
    const glm::vec3 moved = glm::clamp(
        drag_->translation + localStep(scene, worldFromNode, *selected_, drag_->axis * along), -kMaxMetres, kMaxMetres);
    if (moved != edit.translation) {
      edit.translation = moved;
      edited(session, edit, workspace);
    }
  }
}

}  // namespace tyndall::editor
