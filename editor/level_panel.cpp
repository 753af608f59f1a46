#include "level_panel.hpp"

#include <algorithm>
#include <utility>

#include "drag_bar.hpp"
#include "layout.hpp"
#include "level_fields.hpp"
#include "picking.hpp"

namespace tyndall::editor {
namespace {

constexpr float kPick = 8;   // points: how near the mouse selects a light's mark
constexpr float kStill = 3;  // points: a press that goes further is a drag, and selects nothing

const char* kindName(scene::LightKind kind) {
  switch (kind) {
    case scene::LightKind::kDirectional: return "sun";
    case scene::LightKind::kSpot: return "spot";
    case scene::LightKind::kPoint: return "point";
  }
  return "";
}

std::size_t at(int index) { return static_cast<std::size_t>(index); }

std::string nodeLabel(const scene::Scene& scene, int index) {
  const scene::Node& node = scene.nodes[at(index)];
  std::string name = node.name.empty() ? "node " + std::to_string(index) : node.name;
  if (node.mesh != scene::kNone) name += "  (mesh)";
  if (node.light != scene::kNone) name += "  (light)";
  if (node.camera != scene::kNone) name += "  (camera)";
  return name;
}

const char* alphaName(scene::AlphaMode mode) {
  return mode == scene::AlphaMode::kMask ? "  (cut out)" : mode == scene::AlphaMode::kBlend ? "  (blended)" : "";
}

bool section(const char* name, std::size_t count, bool open, Workspace& workspace) {
  const std::string title = name + ("  (" + std::to_string(count) + ")###") + name;
  const bool shown = ImGui::CollapsingHeader(title.c_str(), open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
  if (ImGui::IsItemVisible()) workspace.place(std::string("section ") + name);
  return shown;
}

}  // namespace

void LevelPanel::reset(scene::Scene& scene) {
  separateLights(scene);
  file_ = fileOf(scene);
  edits_ = {};
  children_.assign(scene.nodes.size(), {});
  roots_.clear();
  for (int i = 0; i < static_cast<int>(scene.nodes.size()); ++i) {
    const std::int32_t parent = scene.nodes[at(i)].parent;
    (parent == scene::kNone ? roots_ : children_[at(parent)]).push_back(i);
  }
  selected_.reset();
  pressedAt_.reset();
  gizmo_.release();
}

void LevelPanel::draw(app::Session& session, std::optional<std::uint32_t> camera, float& fieldsHeight,
                      Workspace& workspace) {
  shown_ = true;
  edits_ = editsOf(session.level()->scene, file_);
  workspace.facts["level.selected"] = !selected_ ? "nothing"
                                      : selected_->kind == Kind::kMaterial
                                          ? "material " + std::to_string(selected_->index)
                                          : "node " + std::to_string(selected_->index);
  workspace.facts["level.edits"] = std::to_string(edits_.lights.size() + edits_.nodes.size() + edits_.materials.size());
  const float height = ImGui::GetContentRegionAvail().y, least = scaled(30),
              most = std::max(height - scaled(40), least);
  const float fieldsNow = Layout::sizeOf(fieldsHeight, height / 2, least, most);
  ImGui::BeginChild("tree", {0, selected_ ? std::max(height - fieldsNow, 1.0f) : height});
  tree(session, camera, workspace);
  ImGui::EndChild();
  if (!selected_) return;
  dragBar("fields edge", Edge::kTop, fieldsNow, least, most, fieldsHeight, workspace);
  ImGui::BeginChild("fields");
  fields(session, workspace);
  ImGui::EndChild();
}

bool LevelPanel::isEdited(const Selection& what) const {
  if (what.kind == Kind::kMaterial) return edits_.materials.contains(what.index);
  return edits_.nodes.contains(what.index) || (what.kind == Kind::kLight && edits_.lights.contains(what.index));
}

void LevelPanel::entry(const std::string& label, const Selection& what, const std::string& place,
                       Workspace& workspace) {
  const bool edited = isEdited(what);
  if (edited) ImGui::PushStyleColor(ImGuiCol_Text, kChangedColor);
  if (ImGui::Selectable((label + "##" + place).c_str(), selected_ == what)) selected_ = what;
  if (edited) ImGui::PopStyleColor();
  if (ImGui::IsItemVisible()) workspace.place(place);
}

void LevelPanel::tree(app::Session& session, std::optional<std::uint32_t> camera, Workspace& workspace) {
  const app::Level& level = *session.level();
  const scene::Scene& scene = level.scene;
  const auto cameras = level.cameras(workspace.seconds);
  if (section("Cameras", cameras.size(), true, workspace))
    for (std::uint32_t i = 0; i < cameras.size(); ++i) {
      const std::string name = cameras[i].name.empty() ? "camera" : cameras[i].name;
      const std::string place = "camera " + std::to_string(i);
      if (ImGui::Selectable((std::to_string(i) + "  " + name + "##" + place).c_str(), camera == i))
        workspace.cameraWanted = i;
      if (ImGui::IsItemHovered()) ImGui::SetTooltip("Looks through it");
      if (ImGui::IsItemVisible()) workspace.place(place);
    }
  if (section("Lights", file_.lights.size(), true, workspace)) {
    if (file_.lights.empty()) ImGui::TextColored(kDimColor, "none: the sun that it gets instead cannot be edited");
    for (const auto& [node, unused] : file_.lights) {
      const scene::Light& light = scene.lights[at(scene.nodes[at(node)].light)];
      const std::string& own = scene.nodes[at(node)].name;
      const std::string name = !light.name.empty() ? light.name : !own.empty() ? own : "light";
      entry(name + "  (" + kindName(light.kind) + ")", {Kind::kLight, node}, "light at " + std::to_string(node),
            workspace);
    }
  }
  if (section("Materials", scene.materials.size(), false, workspace))
    for (int i = 0; i < static_cast<int>(scene.materials.size()); ++i) {
      const scene::Material& material = scene.materials[at(i)];
      entry((material.name.empty() ? "material " + std::to_string(i) : material.name) + alphaName(material.alphaMode),
            {Kind::kMaterial, i}, "material " + std::to_string(i), workspace);
    }
  if (section("Nodes", scene.nodes.size(), false, workspace))
    for (const int root : roots_) nodeTree(scene, root, workspace);
}

void LevelPanel::nodeTree(const scene::Scene& scene, int node, Workspace& workspace) {
  const std::string place = "node " + std::to_string(node);
  const Selection what{scene.nodes[at(node)].light != scene::kNone ? Kind::kLight : Kind::kNode, node};
  if (children_[at(node)].empty()) return entry(nodeLabel(scene, node), what, place, workspace);
  const bool edited = isEdited(what);
  if (edited) ImGui::PushStyleColor(ImGuiCol_Text, kChangedColor);
  const ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_OpenOnArrow | ImGuiTreeNodeFlags_SpanAvailWidth |
                                   (selected_ == what ? ImGuiTreeNodeFlags_Selected : 0);
  const bool open = ImGui::TreeNodeEx((nodeLabel(scene, node) + "##" + place).c_str(), flags);
  if (ImGui::IsItemClicked() && !ImGui::IsItemToggledOpen()) selected_ = what;
  if (edited) ImGui::PopStyleColor();
  if (ImGui::IsItemVisible()) workspace.place(place);
  if (!open) return;
  for (const int child : children_[at(node)]) nodeTree(scene, child, workspace);
  ImGui::TreePop();
}

void LevelPanel::fields(app::Session& session, Workspace& workspace) {
  const scene::Scene& scene = session.level()->scene;
  const int index = selected_->index;
  if (selected_->kind == Kind::kMaterial) {
    MaterialEdit edit = materialAt(scene, index);
    bool changed = materialFields(scene.materials[at(index)], edit, workspace);
    changed |= resetButton(file_.materials[at(index)], edit, workspace, "material reset");
    if (changed) setMaterial(session.editScene(), index, edit), workspace.changed = true;
    return;
  }
  const auto worldFromNode = session.level()->worldFromNode(workspace.seconds);
  NodeEdit place = nodeAt(scene, index);
  if (selected_->kind == Kind::kLight) {
    LightEdit edit = lightAt(scene, index);
    bool changed = lightFields(scene.lights[at(scene.nodes[at(index)].light)], edit, workspace);
    changed |= resetButton(file_.lights.at(index), edit, workspace, "light reset");
    if (changed) setLight(session.editScene(), index, edit), workspace.changed = true;
  }
  bool moved = placeFields(scene, worldFromNode, index, place, workspace);
  moved |= resetButton(file_.nodes[at(index)], place, workspace, "place reset");
  if (moved) setNode(session.editScene(), index, place), workspace.changed = true;
}

glm::vec3 LevelPanel::pivot(const app::Level& level, double seconds) const {
  const auto worldFromNode = level.worldFromNode(seconds);
  if (selected_ && selected_->kind != Kind::kMaterial) {
    const std::int32_t light = level.scene.nodes[at(selected_->index)].light;
    const bool sun = light != scene::kNone && level.scene.lights[at(light)].kind == scene::LightKind::kDirectional;
    if (!sun) return pivotOf(level.scene, worldFromNode, selected_->index);
  }
  const scene::Bounds bounds = scene::worldBounds(level.scene, worldFromNode);
  return bounds.empty() ? glm::vec3(0) : 0.5f * (bounds.min + bounds.max);
}

void LevelPanel::drawOver(ImDrawList& list, app::Session& session, const PictureView& view, Workspace& workspace) {
  if (!std::exchange(shown_, false)) return pressedAt_.reset(), gizmo_.release();
  const bool pressed = view.hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
  bool held = false;
  if (selected_ && selected_->kind != Kind::kMaterial)
    held = gizmo_.draw(list, session, view, selected_->index, workspace);
  else
    gizmo_.release();
  const scene::Scene& scene = session.level()->scene;
  const auto worldFromNode = session.level()->worldFromNode(workspace.seconds);
  const ImVec2 at2 = ImGui::GetIO().MousePos;
  std::optional<int> nearest;
  float nearestDistance = kPick;
  for (const auto& [node, unused] : file_.lights) {
    if (scene.lights[at(scene.nodes[at(node)].light)].kind == scene::LightKind::kDirectional) continue;
    const auto place = onScreen(view, glm::vec3(worldFromNode[at(node)][3]));
    if (!place) continue;
    const bool mine = selected_ == Selection{Kind::kLight, node};
    list.AddCircle({place->x, place->y}, 6, mine ? IM_COL32(255, 204, 89, 255) : IM_COL32(255, 255, 255, 160), 16, 2);
    if (const float distance = glm::distance(*place, glm::vec2(at2.x, at2.y)); distance < nearestDistance)
      nearest = node, nearestDistance = distance;
  }
  const glm::vec2 mouse(at2.x, at2.y);
  if (pressed) pressedAt_ = held || nearest ? std::nullopt : std::optional(mouse);
  if (pressed && nearest && !held) selected_ = Selection{Kind::kLight, *nearest};
  if (pressedAt_ && glm::distance(*pressedAt_, mouse) > kStill) pressedAt_.reset();
  if (!pressedAt_ || !ImGui::IsMouseReleased(ImGuiMouseButton_Left)) return;
  pressedAt_.reset();
  const glm::vec3 eye(view.camera.worldFromView[3]);
  if (const auto node = nodeUnder(scene, worldFromNode, eye, directionThrough(view, mouse)))
    selected_ = Selection{scene.nodes[at(*node)].light != scene::kNone ? Kind::kLight : Kind::kNode, *node};
  else
    selected_.reset();  // the sky
}

}  // namespace tyndall::editor
