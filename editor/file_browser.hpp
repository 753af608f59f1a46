// A window to choose a file in: folders, files of some extensions, a line for the name.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "workspace.hpp"

namespace tyndall::editor {

class FileBrowser {
 public:
  enum class Mode { kOpen, kSave };
  /// `extensions` with their dots, lower case; the first is added to a saved name that lacks it.
  /// `named`: what a typed name stands for that is no file here (a preset's or a sample level's); nullopt: nothing.
  using Named = std::function<std::optional<std::filesystem::path>(const std::string&)>;
  void open(std::string title, Mode mode, std::vector<std::string> extensions, const std::filesystem::path& folder,
            Named named = {});
  /// The file chosen, once. Escape or the cross closes the window.
  std::optional<std::filesystem::path> draw(Workspace& workspace);
  bool isOpen() const { return open_; }

 private:
  struct Entry {
    std::string name;
    bool folder = false;
  };
  void read();  ///< the folder's entries; what cannot be read is said in problem_
  void go(const std::filesystem::path& folder);
  std::optional<std::filesystem::path> accept();

  std::string title_, problem_;
  Named named_;
  Mode mode_ = Mode::kOpen;
  std::vector<std::string> extensions_;
  std::filesystem::path folder_;
  std::vector<Entry> entries_;
  std::array<char, 512> name_{};
  bool open_ = false, appearing_ = false, replace_ = false;  ///< replace_: the name is taken, and it was said
};

}  // namespace tyndall::editor
