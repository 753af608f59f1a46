// Level, camera, time, debug view, reloading: the upper part of the side panel.
#pragma once

#include "app/session.hpp"
#include "fly_camera.hpp"
#include "workspace.hpp"

namespace tyndall::editor {

void drawControls(const app::Session& session, const FlyCamera& camera, Workspace& workspace);

}  // namespace tyndall::editor
