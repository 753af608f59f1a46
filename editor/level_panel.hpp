// The level as a tree: cameras, lights, nodes, materials; fields of the one selected, handles in the picture.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "edited_scene.hpp"
#include "gizmo.hpp"

namespace tyndall::editor {

class LevelPanel {
 public:
  /// A level was opened: it is as its file has it.
  void reset(scene::Scene& scene);
  /// Tree and fields, into the current ImGui window. Edits are made in the session's scene. `camera` is the one that is
  /// looked through, nothing while the view is flown; `fieldsHeight` is what the user has dragged (Layout::fields).
  void draw(app::Session& session, std::optional<std::uint32_t> camera, float& fieldsHeight, Workspace& workspace);
  /// Marks and handles over the picture.
  void drawOver(ImDrawList& list, app::Session& session, const PictureView& view, Workspace& workspace);

  const SceneFile& file() const { return file_; }
  /// What an orbit goes round: what is selected, or the middle of the level. World.
  glm::vec3 pivot(const app::Level& level, double seconds) const;

 private:
  enum class Kind { kLight, kNode, kMaterial };
  struct Selection {
    Kind kind;
    int index;  ///< of a light: its node
    bool operator==(const Selection&) const = default;
  };
  void tree(app::Session& session, std::optional<std::uint32_t> camera, Workspace& workspace);
  void nodeTree(const scene::Scene& scene, int node, Workspace& workspace);
  void entry(const std::string& label, const Selection& what, const std::string& place, Workspace& workspace);
  void fields(app::Session& session, Workspace& workspace);
  bool isEdited(const Selection& what) const;

  SceneFile file_;
  SceneEdits edits_;                        ///< of this frame
  std::vector<std::vector<int>> children_;  ///< by node
  std::vector<int> roots_;
  std::optional<Selection> selected_;
  std::optional<glm::vec2> pressedAt_;  ///< where the mouse was pressed on the picture and on nothing else
  bool shown_ = false;                  ///< the tree was drawn in this frame: marks are there
  Gizmo gizmo_;
};

}  // namespace tyndall::editor
