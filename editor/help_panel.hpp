// The overlay of F1: what each key does, from the tables that the keys themselves are read from.
#pragma once

#include "workspace.hpp"

namespace tyndall::editor {

void drawHelp(bool& open, Workspace& workspace);

}  // namespace tyndall::editor
