// The level's lights: a list, fields of the one selected, handles in the picture.
#pragma once

#include <optional>

#include "app/session.hpp"
#include "light_scene.hpp"
#include "workspace.hpp"

namespace tyndall::editor {

class LightsPanel {
 public:
  /// A level was opened: its lights are the file's.
  void reset(scene::Scene& scene);
  /// List and fields, into the current ImGui window. Edits are made in the session's scene.
  void draw(app::Session& session, Workspace& workspace);

  struct Viewport {
    scene::CameraView camera;
    glm::vec2 low{0}, size{0};  ///< points
    bool hovered = false;
  };
  /// Marks and handles over the picture.
  void drawOver(ImDrawList& list, app::Session& session, const Viewport& viewport, Workspace& workspace);

  const LightEdits& file() const { return file_; }
  bool dragging() const { return drag_.has_value(); }

 private:
  void fields(app::Session& session, Workspace& workspace);
  void edited(app::Session& session, const LightEdit& edit, Workspace& workspace);

  /// A handle that is held. Everything is as it was when it was pressed.
  struct Drag {
    glm::vec3 axis{0};  ///< world
    glm::vec3 translation{0};
    glm::vec2 mouse{0}, perMetre{0};  ///< points; points that a metre along the axis spans
  };
  LightEdits file_;
  std::optional<int> selected_;  ///< node
  bool shown_ = false;           ///< the list was drawn in this frame: marks are there
  std::optional<Drag> drag_;
};

}  // namespace tyndall::editor
