// The part of a window that shows an image: zoom by the wheel, pan by dragging, fit, 1:1.
#pragma once

#include <optional>
#include <string>

#include <imgui.h>

#include "views_texture.hpp"
#include "views_transform.hpp"
#include "workspace.hpp"

namespace tyndall::editor {

inline ImVec2 toIm(glm::vec2 v) { return {v.x, v.y}; }
inline glm::vec2 toGlm(ImVec2 v) { return {v.x, v.y}; }

class ViewCanvas {
 public:
  /// Buttons "fit" and "1:1", on the current line. `name` leads the names of the widgets' places.
  void buttons(Workspace& workspace, const std::string& name);

  struct Seen {
    ImDrawList* list = nullptr;         ///< clipped to the canvas until end()
    glm::vec2 low{0}, size{0};          ///< of the canvas, points of the screen
    std::optional<glm::ivec2> hovered;  ///< texel under the mouse
    bool clicked = false;               ///< pressed and let go without a drag
    glm::vec2 pointOf(glm::vec2 texel) const { return low + transform->pointOf(texel); }
    const ViewTransform* transform = nullptr;
  };
  /// Takes `size` points of the current window; an image of other dimensions than the last is fitted. Draws `texture`
  /// unless it is empty.
  Seen begin(Workspace& workspace, const std::string& name, ImVec2 size, glm::uvec2 image, const ViewTexture& texture);
  void end(const Seen& seen) { seen.list->PopClipRect(); }
  const ViewTransform& transform() const { return transform_; }
  /// While true, dragging with the left button does not pan: something in the canvas takes it.
  bool dragTaken = false;

 private:
  enum class Wanted { kNothing, kFit, kOneToOne };
  ViewTransform transform_;
  glm::uvec2 image_{0};
  Wanted wanted_ = Wanted::kFit;
  float dragged_ = 0;  ///< points since the button went down
};

}  // namespace tyndall::editor
