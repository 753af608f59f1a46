// Handles over the picture: arrows that move a node, rings that turn it, and for lights their direction and cone.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/session.hpp"
#include "node_motion.hpp"
#include "workspace.hpp"

namespace tyndall::editor {

/// What the viewport shows, and where on the screen.
struct PictureView {
  scene::CameraView camera;
  glm::vec2 low{0}, size{0};  ///< points
  bool hovered = false;
};
/// A world point in points of the window; nothing behind the camera.
std::optional<glm::vec2> onScreen(const PictureView& view, const glm::vec3& point);
/// From the eye through a place of the window, in points; world, of some length.
glm::vec3 directionThrough(const PictureView& view, const glm::vec2& place);

class Gizmo {
 public:
  /// Nothing is held any more.
  void release() { drag_.reset(); }
  /// Handles of a node. Edits are made in the session's scene, all of one drag from where it began. True: one is held.
  bool draw(ImDrawList& list, app::Session& session, const PictureView& view, int node, Workspace& workspace);

 private:
  enum class Kind { kMove, kTurn, kCone, kAim };
  /// What a drag changes along a line on the screen.
  struct Handle {
    Kind kind = Kind::kMove;
    glm::vec3 axis{0};     ///< world: of kMove and kTurn
    glm::vec2 at{0};       ///< points: where the mouse takes it
    glm::vec2 perUnit{0};  ///< points that a metre (kMove) or a radian spans; not used by kAim
  };
  /// Everything is as it was when the handle was pressed.
  struct Drag {
    Handle handle;
    int node = scene::kNone;
    NodeEdit place;
    LightEdit light;
    glm::mat4 worldFromParent{1};
    glm::vec3 pivot{0}, direction{0};
    glm::vec2 mouse{0};
  };
  struct Scope;  ///< what drawing and picking share in a frame

  void arrows(Scope& scope);
  void rings(Scope& scope);
  void aim(Scope& scope);
  void cone(Scope& scope);
  /// Shows a knob at the handle and takes it when it was pressed.
  void offer(Scope& scope, const Handle& handle, const std::string& name, ImU32 colour);
  void take(Scope& scope, const Handle& handle);
  void pull(app::Session& session, const PictureView& view, const glm::vec2& mouse, Workspace& workspace);

  std::optional<Drag> drag_;
};

}  // namespace tyndall::editor
