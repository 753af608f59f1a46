#include "level_fields.hpp"

#include <algorithm>
#include <cmath>

#include <glm/trigonometric.hpp>

namespace tyndall::editor {
namespace {

constexpr float kMaxIntensity = 1e7f, kMaxEmissive = 1e5f;
constexpr float kMinCone = 0.01f, kMaxCone = 89.9f, kConeGap = 0;  // degrees
constexpr float kMinScale = 1e-3f, kMaxScale = 1e3f;               // of either sign: a mirrored node stays mirrored
constexpr float kMaxHeight = 89.9f;                                // degrees: straight up has no azimuth
constexpr float kRoom = 90;                                        // points that the names take

bool number(const char* name, const std::string& place, float& value, float speed, float low, float high,
            const char* format, Workspace& workspace) {
  ImGui::SetNextItemWidth(-scaled(kRoom));
  const bool changed = ImGui::DragFloat(name, &value, speed, low, high, format, ImGuiSliderFlags_AlwaysClamp);
  workspace.place(place);
  return changed;
}

bool colour(const char* name, const std::string& place, float* value, ImGuiColorEditFlags more, Workspace& workspace) {
  ImGui::SetNextItemWidth(-scaled(kRoom));
  const bool changed = ImGui::ColorEdit3(name, value, ImGuiColorEditFlags_Float | more);
  workspace.place(place);
  return changed;
}

void tell(Workspace& workspace, const char* name, std::initializer_list<float> values) {
  std::string text;
  for (const float value : values) text += (text.empty() ? "" : " ") + std::to_string(value);
  workspace.facts[name] = text;
}

/// The node's own scale along its axes; signs stay.
bool scaleField(const scene::Scene& scene, int node, NodeEdit& edit, Workspace& workspace) {
  tell(workspace, "node.scale", {edit.scale.x, edit.scale.y, edit.scale.z});
  if (isAnimated(scene, node, scene::AnimationTarget::kScale)) {
    ImGui::TextColored(kDimColor, "an animation scales it");
    return false;
  }
  glm::vec3 wanted = edit.scale;
  ImGui::SetNextItemWidth(-scaled(kRoom));
  const bool changed =
      ImGui::DragFloat3("scale", &wanted.x, 0.01f, -kMaxScale, kMaxScale, "%.3f", ImGuiSliderFlags_AlwaysClamp);
  workspace.place("node scale");
  if (!changed) return false;
  for (int axis = 0; axis < 3; ++axis)
    if (wanted[axis] != edit.scale[axis])
      edit.scale[axis] = std::copysign(std::clamp(std::abs(wanted[axis]), kMinScale, kMaxScale), edit.scale[axis]);
  return true;
}

}  // namespace

void setOuterCone(LightEdit& light, float angle) {
  light.outerConeAngle = std::clamp(angle, glm::radians(kMinCone), glm::radians(kMaxCone));
  light.innerConeAngle = std::min(light.innerConeAngle, std::max(light.outerConeAngle - glm::radians(kConeGap), 0.0f));
}

bool lightFields(const scene::Light& light, LightEdit& edit, Workspace& workspace) {
  workspace.facts["light.intensity"] = std::to_string(edit.intensity);
  workspace.facts["light.outer_cone"] = std::to_string(glm::degrees(edit.outerConeAngle));
  const bool sun = light.kind == scene::LightKind::kDirectional;
  bool changed = false;
  if (colour("colour", "light colour", &edit.color.x, ImGuiColorEditFlags_HDR, workspace))
    edit.color = glm::max(edit.color, glm::vec3(0)), changed = true;
  changed |= number(sun ? "lux" : "candela", std::string("light ") + (sun ? "lux" : "candela"), edit.intensity,
                    std::max(edit.intensity, 0.01f) * 0.01f, 0, kMaxIntensity, "%.4g", workspace);
  if (!sun) {
    bool limited = edit.range.has_value();
    if (ImGui::Checkbox("range ends", &limited))
      edit.range = limited ? std::optional(10.0f) : std::nullopt, changed = true;
    workspace.place("light range ends");
    if (edit.range)
      changed |= number("range", "light range", *edit.range, 0.05f, 0.01f, kMaxMetres, "%.3g m", workspace);
  }
  if (light.kind == scene::LightKind::kSpot) {
    float outer = glm::degrees(edit.outerConeAngle), inner = glm::degrees(edit.innerConeAngle);
    if (number("outer cone", "light outer cone", outer, 0.2f, kMinCone, kMaxCone, "%.2f deg", workspace))
      setOuterCone(edit, glm::radians(outer)), changed = true;
    if (number("inner cone", "light inner cone", inner, 0.2f, 0, std::max(outer - kConeGap, 0.0f), "%.2f deg",
               workspace))
      edit.innerConeAngle = glm::radians(inner), changed = true;
  }
  return changed;
}

bool materialFields(const scene::Material& material, MaterialEdit& edit, Workspace& workspace) {
  tell(workspace, "material.base_color", {edit.baseColor.r, edit.baseColor.g, edit.baseColor.b, edit.baseColor.a});
  tell(workspace, "material.roughness", {edit.roughness});
  // Alpha is read of blended and cut out surfaces alone.
  const bool alpha = material.alphaMode != scene::AlphaMode::kOpaque;
  bool changed = colour("colour", "material colour", &edit.baseColor.x, 0, workspace);
  if (changed) edit.baseColor = glm::clamp(edit.baseColor, 0.0f, 1.0f);
  if (alpha) changed |= number("alpha", "material alpha", edit.baseColor.a, 0.005f, 0, 1, "%.3f", workspace);
  if (material.alphaMode == scene::AlphaMode::kMask)
    changed |= number("cut at alpha", "material cutoff", edit.alphaCutoff, 0.005f, 0, 1, "%.3f", workspace);
  if (!material.unlit) {
    changed |= number("roughness", "material roughness", edit.roughness, 0.005f, 0, 1, "%.3f", workspace);
    changed |= number("metallic", "material metallic", edit.metallic, 0.005f, 0, 1, "%.3f", workspace);
    if (colour("emissive", "material emissive", &edit.emissive.x, ImGuiColorEditFlags_HDR, workspace))
      edit.emissive = glm::clamp(edit.emissive, 0.0f, kMaxEmissive), changed = true;
  }
  if (material.baseColorTexture.used()) ImGui::TextColored(kDimColor, "multiplied by its texture");
  return changed;
}

bool placeFields(const scene::Scene& scene, const std::vector<glm::mat4>& worldFromNode, int node, NodeEdit& edit,
                 Workspace& workspace) {
  const scene::Node& it = scene.nodes[static_cast<std::size_t>(node)];
  const bool isLight = it.light != scene::kNone;
  const std::string kind = isLight ? "light " : "node ";
  const glm::vec3 position = edit.position();
  const glm::quat& q = edit.rotation;
  const glm::vec3 backward(worldFromNode[static_cast<std::size_t>(node)][2]);
  // A node that is scaled to nothing looks nowhere.
  const bool looks = glm::length(backward) > 0;
  const glm::vec3 forward = looks ? -glm::normalize(backward) : glm::vec3(0);
  tell(workspace, isLight ? "light.translation" : "node.translation", {position.x, position.y, position.z});
  tell(workspace, isLight ? "light.direction" : "node.direction", {forward.x, forward.y, forward.z});
  if (!isLight) tell(workspace, "node.rotation", {q.x, q.y, q.z, q.w});
  bool changed = false;
  if (isAnimated(scene, node, scene::AnimationTarget::kTranslation)) {
    ImGui::TextColored(kDimColor, "an animation places it");
  } else {
    glm::vec3 wanted = position;
    ImGui::SetNextItemWidth(-scaled(kRoom));
    if (ImGui::DragFloat3("position", &wanted.x, 0.02f, -kMaxMetres, kMaxMetres, "%.2f", ImGuiSliderFlags_AlwaysClamp))
      edit.setPosition(wanted), changed = true;
    workspace.place(kind + "position");
  }
  if (!isLight && !edit.matrix) changed |= scaleField(scene, node, edit, workspace);
  if (isAnimated(scene, node, scene::AnimationTarget::kRotation)) {
    ImGui::TextColored(kDimColor, "an animation turns it");
    return changed;
  }
  if (!looks) return changed;
  if (isLight && scene.lights[static_cast<std::size_t>(it.light)].kind == scene::LightKind::kPoint &&
      !scene.lights[static_cast<std::size_t>(it.light)].cookie)
    return changed;  // the same whichever way it looks
  // Where -Z of the node looks: a light's direction. About that direction only the rings turn it.
  const Heading heading = headingOf(forward);
  float azimuth = glm::degrees(heading.azimuth), height = glm::degrees(heading.height);
  const bool turnedAside = number("azimuth", kind + "azimuth", azimuth, 0.25f, -180, 180, "%.2f deg", workspace);
  const bool turnedUp =
      number("height", kind + "height", height, 0.25f, -kMaxHeight, kMaxHeight, "%.2f deg", workspace);
  if (turnedAside || turnedUp) {
    const glm::vec3 to = directionOf({glm::radians(azimuth), glm::radians(height)});
    const glm::mat4 parent = worldFromParent(scene, worldFromNode, node);
    const glm::vec3 stays = edit.position();
    edit = turned(edit, parent, glm::vec3(parent * glm::vec4(stays, 1)), turnBetween(forward, to));
    edit.setPosition(stays);
    changed = true;
  }
  return changed;
}

}  // namespace tyndall::editor
