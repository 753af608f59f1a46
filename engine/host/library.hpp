// A shared library loaded from a copy of its own: the only place that knows dlopen.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "base/result.hpp"

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
  /// mapped code nor is mistaken for the loaded one. Errors: missing, unreadable, not a whole shared library,
  /// unresolved symbols.
  static Result<std::unique_ptr<Library>> open(const std::filesystem::path& original);
  ~Library();
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

  void* symbol(const char* name) const;  ///< null if there is none
  const FileIdentity& identity() const { return identity_; }

 private:
  Library() = default;
  void* handle_ = nullptr;
  std::filesystem::path folder_;  ///< private temporary folder that holds the copy
  FileIdentity identity_;
};

}  // namespace tyndall::host
