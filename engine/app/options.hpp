// What the command line asks for. CLI11 is used in options.cpp only.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/bench_options.hpp"
#include "app/pose.hpp"
#include "base/result.hpp"

namespace tyndall::app {

/// Settings of the parameter table: the preset first, then the assignments in their order (the later wins).
struct SettingsOptions {
  std::filesystem::path preset;
  std::vector<std::string> assignments;  ///< "id=value"
  std::filesystem::path pluginFolder;
};

struct RenderOptions {
  std::string level;
  std::uint32_t camera = 0;
  std::optional<Pose> pose;  ///< where the camera stands instead of where the file puts it
  std::pair<std::uint32_t, std::uint32_t> size{1280, 720};
  std::uint32_t frames = 1;
  double seconds = 0;
  SettingsOptions settings;
  std::string picture, scatter, depth, stats;  ///< output files; "" = not asked for
  std::string debugView, device;
  std::string viewExr;  ///< output file of the debug view's own numbers; needs debugView
  bool validate = false;
};

struct TruthOptions {
  std::string level;
  std::uint32_t camera = 0;
  std::optional<Pose> pose;  ///< where the camera stands instead of where the file puts it
  std::pair<std::uint32_t, std::uint32_t> size{1280, 720};
  std::uint32_t samples = 1024;
  double seconds = 0;
  SettingsOptions settings;
  std::string scatter, depth;
};

struct DescribeOptions {
  bool json = false;
  std::filesystem::path pluginFolder;
  std::string device;
};
struct LevelsOptions {};
struct EditOptions {
  std::vector<std::string> arguments;
};
/// Help or version: text for stdout, then exit status 0.
struct TextOptions {
  std::string text;
};

using Options = std::variant<RenderOptions, TruthOptions, DescribeOptions, LevelsOptions, EditOptions, BenchOptions,
                             TuneOptions, TextOptions>;

Result<Options> readOptions(int argc, const char* const* argv);

}  // namespace tyndall::app
