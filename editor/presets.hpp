// Preset files: load, save, and what differs from one.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "params/params.hpp"

namespace tyndall::editor {

/// What the file names is set, and nothing else: a preset for speed leaves the fog alone. All or nothing.
Result<void> loadPreset(params::Table& table, const std::filesystem::path& file);
/// Writes every value, so that loading it brings back the same state. All or nothing.
Result<void> savePreset(const params::Table& table, const std::filesystem::path& file);

struct Difference {
  std::string id, here, there;
};
/// Values of the table beside those that a file names, where they differ.
Result<std::vector<Difference>> comparePreset(const params::Table& table, const std::filesystem::path& file);

}  // namespace tyndall::editor
