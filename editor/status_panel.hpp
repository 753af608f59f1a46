// What was said last.
#pragma once

#include "app/session.hpp"
#include "workspace.hpp"

namespace tyndall::editor {

/// The line at the bottom: the newest message, else device and size of the picture.
void drawStatus(app::Session& session, Workspace& workspace, std::uint32_t width, std::uint32_t height);

}  // namespace tyndall::editor
