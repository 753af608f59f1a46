// Where a built shader came from, and whether that has changed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tyndall::gpu {

/// The <name>.spv.json that the build writes beside a shader.
struct ShaderSource {
  std::filesystem::path source;
  std::string stage;
  std::vector<std::filesystem::path> includes;
};

/// None if the file is missing or is not what the build writes, or if the source is not on this machine.
std::optional<ShaderSource> readShaderSource(const std::filesystem::path& json);

/// The source and every file that it #includes, directly or not. (A textual look: an include within #if counts.)
std::vector<std::filesystem::path> sourceFiles(const ShaderSource& source);

/// Changes whenever one of the files is written, appears or goes.
std::uint64_t fingerprint(const std::vector<std::filesystem::path>& files);

/// Whether one of the files was written after `file`.
bool anyNewer(const std::vector<std::filesystem::path>& files, const std::filesystem::path& file);

}  // namespace tyndall::gpu
