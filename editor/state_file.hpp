// The editor's state as JSON, for scripts and tests that watch or steer the window (--print-state).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "app/session.hpp"
#include "fly_camera.hpp"
#include "history.hpp"
#include "workspace.hpp"

namespace tyndall::editor {

class StateFile {
 public:
  /// `path` empty: nothing is written.
  explicit StateFile(std::filesystem::path path) : path_(std::move(path)) {}

  struct Snapshot {
    app::Session& session;
    const Workspace& workspace;
    const FlyCamera& camera;
    const History& history;
    scene::CameraView view;
    std::uint32_t cameraIndex = 0;           ///< of the file's
    std::uint32_t frames = 0, pictures = 0;  ///< windows shown; pictures rendered for them
  };
  /// Writes the file, all or nothing, when something in it differs from the last call.
  Result<void> update(const Snapshot& now);

 private:
  std::filesystem::path path_;
  std::string written_;
};

}  // namespace tyndall::editor
