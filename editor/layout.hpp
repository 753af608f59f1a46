// Sizes of the window's parts and of its text, as the user has dragged and chosen them.
#pragma once

namespace tyndall::editor {

/// Of sizes, 0 means automatic: by the window's.
struct Layout {
  bool panels = true;   ///< else the picture has the window to itself
  float side = 0;       ///< width of the panels, points
  float figures = 0;    ///< height of times, memory and level below the parameters, points
  float fields = 0;     ///< height of what is selected below the level's tree, points
  float textScale = 0;  ///< of the text's size; automatic: as the display asks for
  bool operator==(const Layout&) const = default;

  /// Of a part that lies behind a bar: `automatic` until it was dragged, and always within the room there is.
  static float sizeOf(float kept, float automatic, float least, float most);
  /// Text scales that can be chosen: the next one up or down.
  static float largerText(float scale);
  static float smallerText(float scale);
};

/// Whether every number is one that the editor can have written.
bool isSound(const Layout& layout);

}  // namespace tyndall::editor
