#include "gizmo.hpp"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/trigonometric.hpp>

#include "level_fields.hpp"

namespace tyndall::editor {
namespace {

// Points: length of an arrow, radius of a ring, length of a light's direction; how near the mouse takes a knob, a ring.
constexpr float kArrow = 48, kRing = 38, kAimLength = 76, kGrab = 8, kGrabRing = 5;
constexpr int kRingParts = 48;
constexpr float kLeastPull = 4;  // points that a handle must span: one that points at the eye leads nowhere
constexpr float kSunMetres = 5;  // before the eye: a sun is nowhere, so its handle is put where it is seen
constexpr ImU32 kAimColour = IM_COL32(255, 204, 89, 255), kShade = IM_COL32(0, 0, 0, 160);

ImVec2 toImGui(const glm::vec2& v) { return {v.x, v.y}; }
ImU32 axisColour(int i) { return IM_COL32(i == 0 ? 240 : 70, i == 1 ? 220 : 70, i == 2 ? 255 : 70, 255); }

}  // namespace

std::optional<glm::vec2> onScreen(const PictureView& view, const glm::vec3& point) {
  const glm::vec3 p = glm::vec3(glm::affineInverse(view.camera.worldFromView) * glm::vec4(point, 1));
  if (p.z > -0.01f) return std::nullopt;  // within a centimetre of the eye, or behind it
  const float slope = std::tan(view.camera.camera.yfov / 2), aspect = view.size.x / view.size.y;
  const glm::vec2 ndc{p.x / (-p.z * slope * aspect), -p.y / (-p.z * slope)};
  return view.low + (ndc * 0.5f + 0.5f) * view.size;
}

glm::vec3 directionThrough(const PictureView& view, const glm::vec2& place) {
  const float slope = std::tan(view.camera.camera.yfov / 2), aspect = view.size.x / view.size.y;
  const glm::vec2 ndc = (place - view.low) / view.size * 2.0f - 1.0f;
  return glm::mat3(view.camera.worldFromView) * glm::vec3(ndc.x * slope * aspect, -ndc.y * slope, -1);
}

struct Gizmo::Scope {
  ImDrawList& list;
  const PictureView& view;
  Workspace& workspace;
  const scene::Scene& scene;
  int node;
  const scene::Light* light;  ///< null: none
  glm::mat4 worldFromParent{1};
  glm::vec3 pivot{0};         ///< where the handles are: world
  glm::vec3 direction{0};     ///< of the light, world, unit
  float metresPerPoint = 0;   ///< at the pivot, across the view
  glm::vec2 at{0}, mouse{0};  ///< points: the pivot; the mouse
  bool pressed = false;
};

bool Gizmo::draw(ImDrawList& list, app::Session& session, const PictureView& view, int node, Workspace& workspace) {
  const scene::Scene& scene = session.level()->scene;
  const auto worldFromNode = session.level()->worldFromNode(workspace.seconds);
  const scene::Node& it = scene.nodes[static_cast<std::size_t>(node)];
  const ImGuiIO& io = ImGui::GetIO();
  Scope scope{list, view, workspace, scene, node, nullptr};
  if (it.light != scene::kNone) scope.light = &scene.lights[static_cast<std::size_t>(it.light)];
  const bool sun = scope.light && scope.light->kind == scene::LightKind::kDirectional;
  const glm::mat4& eye = view.camera.worldFromView;
  scope.worldFromParent = worldFromParent(scene, worldFromNode, node);
  scope.pivot = sun ? glm::vec3(eye[3] - eye[2] * kSunMetres) : pivotOf(scene, worldFromNode, node);
  // A node that is scaled to nothing looks nowhere.
  if (const glm::vec3 backward(worldFromNode[static_cast<std::size_t>(node)][2]); glm::length(backward) > 0)
    scope.direction = -glm::normalize(backward);
  scope.mouse = {io.MousePos.x, io.MousePos.y};
  scope.pressed = view.hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Left) || (drag_ && drag_->node != node)) drag_.reset();
  if (const auto at = onScreen(view, scope.pivot)) {
    const float depth = -(glm::affineInverse(eye) * glm::vec4(scope.pivot, 1)).z;
    scope.at = *at;
    scope.metresPerPoint = 2 * depth * std::tan(view.camera.camera.yfov / 2) / view.size.y;
    const bool still = !isAnimated(scene, node, scene::AnimationTarget::kTranslation);
    const bool steady = !isAnimated(scene, node, scene::AnimationTarget::kRotation);
    if (scope.light && scope.light->kind != scene::LightKind::kPoint && scope.direction != glm::vec3(0)) {
      if (scope.light->kind == scene::LightKind::kSpot) cone(scope);
      if (steady) aim(scope);
    }
    // A light without an image is the same whichever way it is turned about its own direction.
    if (still && steady && !sun && (!scope.light || scope.light->cookie)) rings(scope);
    if (still && !sun) arrows(scope);
  }
  if (drag_) pull(session, view, scope.mouse, workspace);
  return drag_.has_value();
}

void Gizmo::take(Scope& scope, const Handle& handle) {
  drag_ = Drag{handle,          scope.node, nodeAt(scope.scene, scope.node), {}, scope.worldFromParent, scope.pivot,
               scope.direction, scope.mouse};
  if (scope.light) drag_->light = lightAt(scope.scene, scope.node);
}

void Gizmo::offer(Scope& scope, const Handle& handle, const std::string& name, ImU32 colour) {
  scope.list.AddCircleFilled(toImGui(handle.at), 6, kShade);
  scope.list.AddCircleFilled(toImGui(handle.at), 5, colour);
  scope.workspace.widgets[name] = {handle.at.x - 4, handle.at.y - 4, 8, 8};
  if (scope.pressed && !drag_ && glm::distance(handle.at, scope.mouse) < kGrab) take(scope, handle);
}

void Gizmo::arrows(Scope& scope) {
  const float metres = kArrow * scope.metresPerPoint;
  for (int i = 0; i < 3; ++i) {
    Handle handle;
    handle.axis[i] = 1;
    const auto end = onScreen(scope.view, scope.pivot + handle.axis * metres);
    if (!end || glm::distance(*end, scope.at) < kLeastPull) continue;
    handle.at = *end, handle.perUnit = (*end - scope.at) / metres;
    scope.list.AddLine(toImGui(scope.at), toImGui(*end), axisColour(i), 2);
    offer(scope, handle, std::string("handle ") + "xyz"[i], axisColour(i));
  }
}

void Gizmo::rings(Scope& scope) {
  const float radius = kRing * scope.metresPerPoint, part = glm::two_pi<float>() / kRingParts;
  for (int i = 0; i < 3; ++i) {
    // The ring's points by the angle about the axis, so that a turn by an angle takes a point along by that angle.
    glm::vec3 axis(0), first(0), second(0);
    axis[i] = 1, first[(i + 1) % 3] = 1, second[(i + 2) % 3] = 1;
    const auto point = [&](float angle) {
      return onScreen(scope.view, scope.pivot + radius * (std::cos(angle) * first + std::sin(angle) * second));
    };
    const auto handleAt = [&](float angle) -> std::optional<Handle> {
      const auto here = point(angle), before = point(angle - part), after = point(angle + part);
      if (!here || !before || !after || glm::distance(*before, *after) < kLeastPull / 2) return std::nullopt;
      return Handle{Kind::kTurn, axis, *here, (*after - *before) / (2 * part)};
    };
    float nearest = 0, distance = kGrabRing;
    for (int k = 0; k < kRingParts; ++k) {
      const auto from = point(static_cast<float>(k) * part), to = point(static_cast<float>(k + 1) * part);
      if (!from || !to) continue;
      scope.list.AddLine(toImGui(*from), toImGui(*to), axisColour(i), 1.5f);
      if (const float d = glm::distance(*from, scope.mouse); d < distance)
        distance = d, nearest = static_cast<float>(k) * part;
    }
    const auto knob = handleAt(glm::quarter_pi<float>());
    if (knob) offer(scope, *knob, std::string("turn ") + "xyz"[i], axisColour(i));
    if (scope.pressed && !drag_ && distance < kGrabRing)
      if (const auto handle = handleAt(nearest)) take(scope, *handle);
  }
}

void Gizmo::aim(Scope& scope) {
  const auto end = onScreen(scope.view, scope.pivot + scope.direction * (kAimLength * scope.metresPerPoint));
  if (!end) return;
  scope.list.AddLine(toImGui(scope.at), toImGui(*end), kShade, 4);
  scope.list.AddLine(toImGui(scope.at), toImGui(*end), kAimColour, 2);
  scope.list.AddCircle(toImGui(scope.at), 7, kAimColour, 16, 2);
  offer(scope, {Kind::kAim, {}, *end, {}}, "aim", kAimColour);
}

void Gizmo::cone(Scope& scope) {
  const float length = kAimLength * scope.metresPerPoint;
  // Across the direction, and as far across the view as can be.
  const glm::vec3 away = scope.pivot - glm::vec3(scope.view.camera.worldFromView[3]);
  glm::vec3 side = glm::cross(scope.direction, away);
  if (glm::length(side) < 1e-3f * glm::length(away)) side = glm::vec3(scope.view.camera.worldFromView[0]);
  side = glm::normalize(side - glm::dot(side, scope.direction) * scope.direction);
  const glm::vec3 other = glm::cross(scope.direction, side);
  const auto rim = [&](float angle, float around) {
    const glm::vec3 out = std::cos(around) * side + std::sin(around) * other;
    return onScreen(scope.view, scope.pivot + length * (std::cos(angle) * scope.direction + std::sin(angle) * out));
  };
  const float outer = scope.light->outerConeAngle, step = 0.02f, part = glm::two_pi<float>() / kRingParts;
  for (int k = 0; k < kRingParts; ++k) {
    const auto from = rim(outer, static_cast<float>(k) * part), to = rim(outer, static_cast<float>(k + 1) * part);
    if (from && to) scope.list.AddLine(toImGui(*from), toImGui(*to), kAimColour, 1);
    if (from && k % (kRingParts / 4) == 0) scope.list.AddLine(toImGui(scope.at), toImGui(*from), kAimColour, 1);
  }
  const auto here = rim(outer, 0), less = rim(outer - step, 0), more = rim(outer + step, 0);
  if (!here || !less || !more || glm::distance(*less, *more) < 2 * step * kLeastPull) return;
  offer(scope, {Kind::kCone, {}, *here, (*more - *less) / (2 * step)}, "cone", IM_COL32(255, 140, 60, 255));
}

void Gizmo::pull(app::Session& session, const PictureView& view, const glm::vec2& mouse, Workspace& workspace) {
  const Handle& handle = drag_->handle;
  const glm::vec2 way = mouse - drag_->mouse;
  const float along =
      handle.kind == Kind::kAim ? 0 : glm::dot(way, handle.perUnit) / glm::dot(handle.perUnit, handle.perUnit);
  NodeEdit place = drag_->place;
  LightEdit light = drag_->light;
  switch (handle.kind) {
    case Kind::kMove: place = moved(place, drag_->worldFromParent, handle.axis * along); break;
    case Kind::kTurn:
      place = turned(place, drag_->worldFromParent, drag_->pivot, glm::angleAxis(along, handle.axis));
      break;
    case Kind::kCone: setOuterCone(light, light.outerConeAngle + along); break;
    case Kind::kAim: {
      // Turned about the view's own axes, as a ball under the hand; its far side goes with the hand as the near one
      // does.
      const glm::mat4& eye = view.camera.worldFromView;
      const float side = glm::dot(drag_->direction, glm::vec3(eye[2])) < 0 ? -1.0f : 1.0f;
      const glm::quat turn = glm::angleAxis(side * way.x / kAimLength, glm::normalize(glm::vec3(eye[1]))) *
                             glm::angleAxis(side * way.y / kAimLength, glm::normalize(glm::vec3(eye[0])));
      // About its own place: a light's direction does not move it.
      const glm::vec3 origin = glm::vec3(drag_->worldFromParent * glm::vec4(place.position(), 1));
      const glm::vec3 position = place.position();
      place = turned(place, drag_->worldFromParent, origin, turn);
      place.setPosition(position);
      break;
    }
  }
  scene::Scene& scene = session.editScene();
  const bool lit = scene.nodes[static_cast<std::size_t>(drag_->node)].light != scene::kNone;
  if (place == nodeAt(scene, drag_->node) && (!lit || light == lightAt(scene, drag_->node))) return;
  setNode(scene, drag_->node, place);
  if (lit) setLight(scene, drag_->node, light);
  workspace.changed = true;
}

}  // namespace tyndall::editor
