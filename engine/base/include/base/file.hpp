// Whole-file reads and all-or-nothing writes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace tyndall {

/// Reads a regular file of at most `maxBytes`. Errors name the path: missing, a folder, unreadable, too large.
Result<std::vector<std::byte>> readFile(const std::filesystem::path& path, std::uint64_t maxBytes = 1ull << 31);
Result<std::string> readText(const std::filesystem::path& path, std::uint64_t maxBytes = 1ull << 26);

/// Writes to a temporary file beside `path` and renames it over `path`: a reader sees the old file or the whole new
/// one, with the old one's permissions. A symbolic link is followed, not replaced; what is no regular file is refused.
/// The folder must exist. On failure nothing is left behind.
Result<void> writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> bytes);
Result<void> writeTextAtomically(const std::filesystem::path& path, std::string_view text);

/// Folder of the running executable (where shaders/, plugins/ and levels/ lie), without a trailing slash.
std::filesystem::path executableFolder();

/// The first that can be made and written to of $XDG_CACHE_HOME/tyndall, ~/.cache/tyndall (of $HOME, else of the user's
/// entry in the system's list) and tyndall-UID in the folder for temporary files, where it is the user's alone. Empty,
/// with one warning, if there is none.
std::filesystem::path cacheFolder();

/// The candidate nearest to `text` by edit distance, or "" if none is near (more than a third of its letters differ).
std::string nearestName(std::string_view text, std::span<const std::string> candidates);

}  // namespace tyndall
