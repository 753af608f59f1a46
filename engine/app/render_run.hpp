// Warm-up and timed frames of one `tyndall render`.
#pragma once

#include <string>
#include <vector>

#include "app/readback.hpp"
#include "app/session.hpp"
#include "app/view_readback.hpp"
#include "options.hpp"

namespace tyndall::app {

struct RenderRun {
  std::vector<render::PassTime> passes;  ///< of the median frame, without the copies to the host
  std::uint64_t effectBytes = 0, transientBytes = 0, deviceBytes = 0;
  std::uint32_t validationMessages = 0;
  Readback readback;   ///< of the last frame
  ViewReadback views;  ///< the debug view's numbers, where options.viewExr asks for them
};

/// Renders the warm-up and then options.frames frames of the session's level.
Result<RenderRun> renderFrames(Session& session, const RenderOptions& options, const scene::CameraView& camera);

}  // namespace tyndall::app
