// Where a plugin's copy is loaded from.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <variant>

namespace tyndall::host {

/// A library that dlopen has mapped, under a name that no other has while it is loaded.
struct LoadedCopy {
  LoadedCopy() = default;
  ~LoadedCopy();
  LoadedCopy(const LoadedCopy&) = delete;
  LoadedCopy& operator=(const LoadedCopy&) = delete;
  LoadedCopy(LoadedCopy&& other) noexcept
      : handle(std::exchange(other.handle, nullptr)), file(std::exchange(other.file, -1)), inPlace(other.inPlace) {}

  void* handle = nullptr;
  int file = -1;         ///< the nameless file that it was loaded from, kept open: its number is the library's name
  bool inPlace = false;  ///< the original itself is mapped
};

/// Why there is no copy.
struct NoCopy {
  std::string reason;
  bool place = true;  ///< the place gives none (full, noexec); else the library itself is at fault
};

/// A copy in memory alone.
std::variant<LoadedCopy, NoCopy> loadFromMemory(const std::filesystem::path& original,
                                                std::span<const std::byte> bytes);
/// A copy on the file system of `folder`, in a file without a name there, which is gone with its last user.
std::variant<LoadedCopy, NoCopy> loadFromFolder(const std::filesystem::path& folder,
                                                const std::filesystem::path& original,
                                                std::span<const std::byte> bytes);
/// The file itself: a rebuilt one changes the mapped code, and cannot be loaded beside this one.
std::variant<LoadedCopy, NoCopy> loadInPlace(const std::filesystem::path& original);

}  // namespace tyndall::host
