// The editor's command line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/catalogue.hpp"
#include "base/result.hpp"

namespace tyndall::editor {

struct Options {
  std::string level;  ///< "" = the hall, else the first sample level
  std::uint32_t camera = 0;
  std::pair<std::uint32_t, std::uint32_t> size{1280, 720};  ///< of the window
  std::vector<std::string> assignments;                     ///< "id=value"
  std::filesystem::path preset, pluginFolder;
  std::uint32_t frames = 0;  ///< 0: until the window is closed
  double seconds = 0;
  std::filesystem::path screenshot, state;  ///< "" = not asked for
  std::filesystem::path settings;           ///< what is remembered between runs; "" = the user's own file
  std::string device;
  std::uint32_t stress = 0;  ///< steps of random use; 0: none, a user's
  std::uint32_t seed = 1;    ///< of the random use
  bool validate = false, help = false;
};

Result<Options> readOptions(int argc, const char* const* argv);
const char* helpText();

/// Loads the plugins, then the preset, then the assignments in their order.
Result<std::unique_ptr<app::Catalogue>> loadCatalogue(const Options& options);

}  // namespace tyndall::editor
