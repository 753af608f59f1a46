// Files that are put in place together.
#pragma once

#include <deque>
#include <filesystem>
#include <string>

#include "base/process.hpp"
#include "base/result.hpp"

namespace tyndall {

/// Where a file of that name is written: the end of a chain of symbolic links, whether there is a file or not. Errors:
/// links in a circle.
Result<std::filesystem::path> followLinks(const std::filesystem::path& path);

class FileSet {
 public:
  /// The name of a temporary file in the folder where `path` leads, for the caller to write. `subject` names the file
  /// in errors ("--out a.png").
  Result<std::filesystem::path> stage(const std::filesystem::path& path, const std::string& subject);
  /// Puts all of them in place, or none: if one cannot be, what was there before the others is there again. A file
  /// keeps the permissions of the one that it replaces.
  Result<void> place();
  /// After place(): everything as it was before.
  Result<void> takeBack();
  /// Removes what was staged and not placed, and what was replaced.
  ~FileSet() = default;

 private:
  enum class State { kStaged, kMade, kExchanged, kMovedAside };
  struct Staged {
    Staged(std::string s, std::filesystem::path t)
        : subject(std::move(s)), target(std::move(t)), temporary(target.parent_path()), aside(target.parent_path()) {}
    std::string subject;
    std::filesystem::path target;
    TemporaryFile temporary;  ///< of the new file; when kExchanged, of the old one
    TemporaryFile aside;      ///< of the old file when kMovedAside
    State state = State::kStaged;
  };
  static int placeOne(Staged& file);
  static int takeBackOne(Staged& file);

  std::deque<Staged> files_;
};

}  // namespace tyndall
