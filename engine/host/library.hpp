// A shared library loaded from a copy of its own: the only place that knows dlopen.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "base/result.hpp"
#include "library_copy.hpp"

namespace tyndall::host {

/// What tells one build of a file from the next.
struct FileIdentity {
  std::uint64_t device = 0, inode = 0, size = 0;
  std::int64_t modifiedNs = 0;
  bool operator==(const FileIdentity&) const = default;
};
Result<FileIdentity> fileIdentity(const std::filesystem::path& path);

class Library {
 public:
  /// Copies `original` under a name of its own and loads the copy, so that a rebuilt original neither changes the
  /// mapped code nor is mistaken for the loaded one. The copy is in memory; where the system gives none that can be
  /// run, in the folder for temporary files, in the cache folder, and at last, with a warning, the original itself is
  /// loaded. Nothing stays on disk once this has returned. Errors: missing, unreadable, not a whole shared library,
  /// unresolved symbols.
  static Result<std::unique_ptr<Library>> open(const std::filesystem::path& original);
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

  void* symbol(const char* name) const;  ///< null if there is none
  const FileIdentity& identity() const { return identity_; }
  /// The file itself is mapped: another build of it cannot be loaded beside it.
  bool inPlace() const { return copy_->inPlace; }

 private:
  Library() = default;
  std::optional<LoadedCopy> copy_;
  FileIdentity identity_;
};

}  // namespace tyndall::host
