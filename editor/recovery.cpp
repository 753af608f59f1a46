#include "recovery.hpp"

#include <algorithm>
#include <cstdio>

#include "presets.hpp"
#include "scene/write_glb.hpp"

namespace tyndall::editor {
namespace {

namespace fs = std::filesystem;

fs::path nameOf(const fs::path& folder, int number, const char* extension) {
  return folder / ("recovered-" + std::to_string(number) + extension);
}

/// The greatest number in use; 0: none is.
int newestIn(const fs::path& folder) {
  int newest = 0;
  std::error_code unreadable;
  for (fs::directory_iterator at(folder, unreadable), end; !unreadable && at != end; at.increment(unreadable)) {
    int number = 0, length = 0;
    const std::string name = at->path().filename().string();
    if (std::sscanf(name.c_str(), "recovered-%9d.%n", &number, &length) == 1 && length > 0)
      newest = std::max(newest, number);
  }
  return newest;
}

}  // namespace

Result<std::string> writeRecovery(const fs::path& folder, const params::Table& table, const scene::Scene* edited) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) return failed(folder.string() + ": cannot be made: " + failure.message());
  const int number = newestIn(folder) + 1;
  const fs::path settings = nameOf(folder, number, ".json"), level = nameOf(folder, number, ".glb");
  if (auto saved = savePreset(table, settings); !saved) return saved.error();
  if (!edited) return settings.string();
  if (auto written = scene::writeGlb(*edited, level); !written)
    return Error{"only the settings are kept, in " + settings.string() + "; the level: " + written.error().message,
                 written.error().kind};
  return settings.string() + " and " + level.string();
}

std::string recoveryNote(const fs::path& folder) {
  const int newest = newestIn(folder);
  if (newest == 0) return "";
  std::error_code unknown;
  const fs::path settings = nameOf(folder, newest, ".json"), level = nameOf(folder, newest, ".glb");
  std::string line = "a session was cut off; delete what is kept of it once it is of no use:";
  if (fs::exists(settings, unknown)) line += " " + settings.string() + " (its settings, Ctrl+L)";
  if (fs::exists(level, unknown)) line += " " + level.string() + " (its level, Ctrl+O)";
  return line;
}

}  // namespace tyndall::editor
