// The capture window: which files, where, and the command that makes them again.
#pragma once

#include <array>
#include <filesystem>
#include <initializer_list>
#include <string>

#include "app/capture.hpp"
#include "settings_file.hpp"
#include "workspace.hpp"

namespace tyndall::editor {

class CapturePanel {
 public:
  bool open = false;
  bool picture = true, scatter = false, depth = false, stats = true;
  bool view = false;                ///< the numbers of the debug view that is shown, if one is
  std::array<char, 1024> folder{};  ///< "" = the working folder

  void restore(const Settings& settings);
  void keep(Settings& settings) const;
  /// True: the button was pressed.
  bool draw(Workspace& workspace);
  /// Captures what `shot` says; the files get the first free number in the folder, the clipboard gets the command.
  /// Where the level was edited, it is written beside them, as the command must find it so.
  Result<void> take(app::Session& session, app::Capture shot, bool levelEdited);
  /// Path of `base` with an extension in the folder chosen.
  std::filesystem::path fileOf(const std::string& base, const char* extension) const;
  std::string freeBase(const std::string& level) const;
  /// `stem` with the first number that no file of the extensions has.
  std::string freeName(const std::string& stem, std::initializer_list<const char*> extensions) const;
  const std::string& command() const { return command_; }

 private:
  std::string command_, base_;
};

}  // namespace tyndall::editor
