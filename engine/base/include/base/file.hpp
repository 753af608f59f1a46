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
/// one. The folder must exist. On failure nothing is left behind.
Result<void> writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> bytes);
Result<void> writeTextAtomically(const std::filesystem::path& path, std::string_view text);

/// Folder of the running executable (where shaders/, plugins/ and levels/ lie), without a trailing slash.
std::filesystem::path executableFolder();

/// $XDG_CACHE_HOME/tyndall or ~/.cache/tyndall, created when missing; empty if neither can be made.
std::filesystem::path cacheFolder();

/// The candidate nearest to `text` by edit distance, or "" if none is near (more than a third of its letters differ).
std::string nearestName(std::string_view text, std::span<const std::string> candidates);

}  // namespace tyndall
