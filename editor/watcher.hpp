// Notices rebuilt plugins and changed shaders, about once a second.
#pragma once

#include <chrono>
#include <filesystem>

#include "app/session.hpp"
#include "workspace.hpp"

namespace tyndall::editor {

class Watcher {
 public:
  /// Reloads what has changed and what the workspace asks for; says so in its message. What is broken stays as it was.
  void check(app::Session& session, Workspace& workspace);

 private:
  void reloadPlugin(app::Session& session, Workspace& workspace);
  void reloadShaders(app::Session& session, Workspace& workspace, bool asked);

  std::chrono::steady_clock::time_point next_{};
  std::filesystem::file_time_type
      tried_{};  ///< of the plugin's file at the last automatic attempt: a broken one is tried once
};

}  // namespace tyndall::editor
