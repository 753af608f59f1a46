// A bar between two parts of the window.
#pragma once

#include "workspace.hpp"

namespace tyndall::editor {

enum class Edge { kLeft, kTop };  ///< of the part that follows

/// The bar before a part of the window, across the rest of the current window. It is dragged to resize that part; a
/// double click makes it automatic again. `now` is the part's present size, `kept` what it gets. True while it is
/// dragged.
bool dragBar(const char* name, Edge edge, float now, float least, float most, float& kept, Workspace& workspace);

}  // namespace tyndall::editor
