// What is kept of a session that cannot go on: its settings as a preset and, where the level was edited, the level.
#pragma once

#include <filesystem>
#include <string>

#include "params/params.hpp"
#include "scene/scene.hpp"

namespace tyndall::editor {

/// Writes recovered-N.json and, unless `edited` is null, recovered-N.glb into `folder`, N one more than the greatest in
/// use. Gives the files' names as one phrase. Needs neither window nor device.
Result<std::string> writeRecovery(const std::filesystem::path& folder, const params::Table& table,
                                  const scene::Scene* edited);

/// What a user is told of such files in `folder`, one line; "" where there are none.
std::string recoveryNote(const std::filesystem::path& folder);

}  // namespace tyndall::editor
