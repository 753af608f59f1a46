// Preset files: load, save, and what differs from one.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "params/params.hpp"

namespace tyndall::editor {

/// A preset as the editor applies it: what the file names is set, everything else gets its default, so that the same
/// file is always the same state. All or nothing.
Result<void> loadPreset(params::Table& table, const std::filesystem::path& file);
/// Writes the values that differ from their defaults, all or nothing.
Result<void> savePreset(const params::Table& table, const std::filesystem::path& file);

struct Difference {
  std::string id, here, there;
};
/// Values of the table beside those of a file (as loadPreset would set them), where they differ.
Result<std::vector<Difference>> comparePreset(const params::Table& table, const std::filesystem::path& file);

}  // namespace tyndall::editor
