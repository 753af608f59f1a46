// What a running session shows, as the files and the call of `tyndall render`.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/pose.hpp"
#include "app/session.hpp"

namespace tyndall::app {

struct Capture {
  std::string level;  ///< a sample's name or a path
  std::uint32_t camera = 0;
  std::optional<Pose> pose;
  std::pair<std::uint32_t, std::uint32_t> size{1280, 720};
  double seconds = 0;
  std::string debugView;                                 ///< "" = the picture
  std::filesystem::path pluginFolder;                    ///< as it was asked for
  std::filesystem::path picture, scatter, depth, stats;  ///< "" = not asked for
  std::filesystem::path viewExr;                         ///< numbers of the debug view; "" = not asked for
};

/// Renders with the session's level and settings just as `tyndall render` does, warm-up included, and writes all files
/// or none. The session goes on as after a cut.
Result<void> capture(Session& session, const Capture& capture);

/// The call that writes the same files, as words: device and every setting that is not the default are named.
std::vector<std::string> captureWords(Session& session, const Capture& capture);
/// Words as a line for a POSIX shell.
std::string shellLine(const std::vector<std::string>& words);

}  // namespace tyndall::app
