// The files of one `tyndall render`.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "app/outputs.hpp"
#include "options.hpp"
#include "render_run.hpp"

namespace tyndall::app {

/// Registers what the options ask for; nothing that the call reads may be replaced.
Result<void> addRenderFiles(Outputs& outputs, const RenderOptions& options, const std::filesystem::path& level);
/// All of them or none; none as well if `tell` fails, which is to say what was written.
Result<void> writeRenderFiles(Outputs& outputs, const RenderRun& run, const std::string& stats,
                              const std::function<Result<void>()>& tell = {});

}  // namespace tyndall::app
