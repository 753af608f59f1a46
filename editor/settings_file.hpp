// What the editor remembers between runs: $XDG_CONFIG_HOME/tyndall/editor.json, else ~/.config/tyndall/editor.json.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "layout.hpp"

namespace tyndall::editor {

struct Settings {
  std::vector<std::string> recentLevels;  ///< samples' names and absolute paths, the newest first, at most ten
  std::string levelFolder, presetFolder, captureFolder;
  bool capturePicture = true, captureScatter = false, captureDepth = false, captureStats = true;
  bool captureView = false;
  double budgetMs = 16;  ///< the line in the graph of GPU times
  Layout layout;
  bool operator==(const Settings&) const = default;

  void opened(const std::string& level);
};

/// Of this user; "" when neither variable is set.
std::filesystem::path settingsPath();

class SettingsFile {
 public:
  explicit SettingsFile(std::filesystem::path path) : path_(std::move(path)) {}
  /// Defaults when there is no file. One that is broken is renamed to "<name>.broken", and `problem` says so.
  Settings read(std::string& problem);
  /// All or nothing, and only when something differs from the last call.
  Result<void> write(const Settings& settings);
  /// Where what is kept lies; "" where nothing is kept.
  std::filesystem::path folder() const;

 private:
  std::filesystem::path path_;
  Settings written_;
};

}  // namespace tyndall::editor
