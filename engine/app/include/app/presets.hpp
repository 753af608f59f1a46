// Presets by name.
#pragma once

#include <filesystem>

#include "base/result.hpp"

namespace tyndall::app {

/// Folder of the presets that come with the program: presets/ beside it.
std::filesystem::path presetFolder();

/// The path itself, or, without a slash and without .json, a preset that comes with the program (presets/ beside it).
/// An unknown name is a bad call that lists them.
Result<std::filesystem::path> findPreset(const std::filesystem::path& asked);

}  // namespace tyndall::app
