#include "watcher.hpp"

#include <system_error>
#include <utility>

#include "base/log.hpp"

namespace tyndall::editor {

void Watcher::check(app::Session& session, Workspace& workspace) {
  if (std::exchange(workspace.reloadPlugin, false)) reloadPlugin(session, workspace);
  if (std::exchange(workspace.reloadShaders, false)) reloadShaders(session, workspace, true);
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return;
  next_ = now + std::chrono::seconds(1);
  if (session.pluginChanged()) {
    std::error_code missing;  // in the middle of a build the file may be gone; it comes back with another time
    const auto written = std::filesystem::last_write_time(session.catalogue().effectPlugin().path(), missing);
    if (!missing && written != tried_) {
      tried_ = written;
      reloadPlugin(session, workspace);
    }
  }
  reloadShaders(session, workspace, false);
}

void Watcher::reloadPlugin(app::Session& session, Workspace& workspace) {
  if (auto done = session.reloadPlugin(); !done) {
    workspace.tell("plugin not reloaded, the old one stays: " + done.error().message, true);
    log::warning(workspace.message);
    return;
  }
  workspace.changed = true;
  workspace.tell("plugin reloaded: " + session.catalogue().effectPlugin().name() + " " +
                     session.catalogue().effectPlugin().version(),
                 false);
}

void Watcher::reloadShaders(app::Session& session, Workspace& workspace, bool asked) {
  const std::vector<std::string> lines = session.reloadShaders();
  if (lines.empty()) {
    if (asked) workspace.tell("no shader has changed", false);
    return;
  }
  // "<name>: reloaded", or the reason why the last good code stays.
  bool broken = false;
  std::string text;
  for (const std::string& line : lines) {
    const bool isBroken = !line.ends_with(": reloaded");
    if (isBroken) log::warning(line);
    broken = broken || isBroken;
    text += (text.empty() ? "" : "   ") + line;
  }
  workspace.changed = true;
  workspace.tell(text, broken);
}

}  // namespace tyndall::editor
