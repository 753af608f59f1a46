#include "settings_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "base/json_shape.hpp"

namespace tyndall::editor {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t kRecent = 10;

std::string textOf(const Settings& s) {
  Json json;
  json["recent_levels"] = s.recentLevels;
  json["level_folder"] = s.levelFolder, json["preset_folder"] = s.presetFolder,
  json["capture_folder"] = s.captureFolder;
  json["capture"] = {{"picture", s.capturePicture},
                     {"scatter", s.captureScatter},
                     {"depth", s.captureDepth},
                     {"stats", s.captureStats},
                     {"view", s.captureView}};
  json["budget_ms"] = s.budgetMs;
  json["layout"] = {{"panels", s.layout.panels},
                    {"side", s.layout.side},
                    {"figures", s.layout.figures},
                    {"fields", s.layout.fields},
                    {"text_scale", s.layout.textScale}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// Throws Json::exception at what has another type than it should.
Settings settingsFrom(const Json& json) {
  Settings s;
  if (json.contains("recent_levels")) s.recentLevels = json["recent_levels"].get<std::vector<std::string>>();
  if (s.recentLevels.size() > kRecent) s.recentLevels.resize(kRecent);
  s.levelFolder = json.value("level_folder", s.levelFolder),
  s.presetFolder = json.value("preset_folder", s.presetFolder);
  s.captureFolder = json.value("capture_folder", s.captureFolder);
  const Json capture = json.value("capture", Json::object());
  s.capturePicture = capture.value("picture", s.capturePicture),
  s.captureScatter = capture.value("scatter", s.captureScatter);
  s.captureDepth = capture.value("depth", s.captureDepth), s.captureStats = capture.value("stats", s.captureStats);
  s.captureView = capture.value("view", s.captureView);
  s.budgetMs = json.value("budget_ms", s.budgetMs);
  const Json layout = json.value("layout", Json::object());
  s.layout.panels = layout.value("panels", s.layout.panels);
  s.layout.side = layout.value("side", s.layout.side);
  s.layout.figures = layout.value("figures", s.layout.figures);
  s.layout.fields = layout.value("fields", s.layout.fields);
  s.layout.textScale = layout.value("text_scale", s.layout.textScale);
  return s;
}

}  // namespace

void Settings::opened(const std::string& level) {
  std::erase(recentLevels, level);
  recentLevels.insert(recentLevels.begin(), level);
  if (recentLevels.size() > kRecent) recentLevels.resize(kRecent);
}

fs::path settingsPath() {
  const auto named = [](const char* name) -> fs::path {
    const char* value = std::getenv(name);
    return value ? value : "";
  };
  if (const fs::path config = named("XDG_CONFIG_HOME"); config.is_absolute()) return config / "tyndall" / "editor.json";
  if (const fs::path home = named("HOME"); !home.empty()) return home / ".config" / "tyndall" / "editor.json";
  return {};
}

Settings SettingsFile::read(std::string& problem) {
  written_ = {};
  std::error_code unknown;
  if (path_.empty() || !fs::exists(path_, unknown)) return {};
  std::string reason;
  if (auto text = readText(path_, 1u << 20); !text) {
    problem = text.error().message;  // unreadable, which renaming does not mend
    path_.clear();                   // nor is it written over
    return {};
  } else if (reason = jsonShapeProblem(*text); reason.empty()) {
    try {
      const Settings settings = settingsFrom(Json::parse(*text));
      const bool budget = std::isfinite(settings.budgetMs) && settings.budgetMs > 0;
      if (budget && isSound(settings.layout)) return written_ = settings;
      reason = budget ? "layout: sizes must be 0 or more, text_scale 0 or from 0.75 to 3" : "budget_ms must be above 0";
    } catch (const Json::exception& error) {
      reason = error.what();
    }
  }
  const fs::path aside = path_.string() + ".broken";
  fs::rename(path_, aside, unknown);
  problem = path_.string() + ": is not what the editor wrote (" + reason + "); " +
            (unknown ? "it cannot be renamed: " + unknown.message() : "it is now " + aside.string());
  if (unknown) path_.clear();
  return {};
}

fs::path SettingsFile::folder() const {
  std::error_code unknown;  // without a working folder the name stays relative, and writing there says what is wrong
  const fs::path whole = fs::absolute(path_, unknown);
  return path_.empty() ? path_ : (unknown ? path_ : whole).parent_path();
}

Result<void> SettingsFile::write(const Settings& settings) {
  if (path_.empty() || settings == written_) return {};
  written_ = settings;  // also when it cannot be written: it is said once, not in each frame
  std::error_code failure;
  if (path_.has_parent_path()) fs::create_directories(path_.parent_path(), failure);
  if (failure) return failed(path_.parent_path().string() + ": cannot be made: " + failure.message());
  return writeTextAtomically(path_, textOf(settings));
}

}  // namespace tyndall::editor
