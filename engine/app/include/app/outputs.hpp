// The files that one call writes: all of them or none.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/file_set.hpp"
#include "base/result.hpp"

namespace tyndall::app {

class Outputs {
 public:
  using Write = std::function<Result<void>(const std::filesystem::path&)>;

  /// Registers an output of `option` ("--out"). Checked at once, before any work: the path ends in `extension` (any
  /// case), the folder that it leads to exists and can be written to, it is no folder or special file itself and may be
  /// replaced, and neither another output nor an input leads to the same file. A symbolic link is followed, not
  /// replaced; one that leads to no file yet makes it.
  Result<void> add(const std::string& option, const std::filesystem::path& path, const std::string& extension);
  /// A file that the call reads, which no output may replace.
  void protect(const std::filesystem::path& path) { inputs_.push_back(path); }

  /// Writes the output of `option` beside its place under a temporary name. Nothing happens if it was not asked for.
  Result<void> write(const std::string& option, const Write& write);
  /// Puts every written file in place and has `tell` say so. If one cannot be put there, or `tell` fails, everything is
  /// as it was before: what was there comes back.
  Result<void> commit(const std::function<Result<void>()>& tell = {});

  std::vector<std::filesystem::path> paths() const;

 private:
  struct Output {
    std::string option;
    std::filesystem::path path;
    std::string subject() const { return option + " " + path.string(); }
  };
  std::vector<Output> outputs_;
  FileSet files_;
  std::vector<std::filesystem::path> inputs_;
};

}  // namespace tyndall::app
