// glTF 2.0 import (.gltf and .glb) by tinygltf, which appears in gltf.cpp only.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "scene/scene.hpp"

namespace tyndall::scene {

struct Import {
  Scene scene;
  std::uint64_t contentHash = 0;      ///< of the level's file and of every file beside it that was read
  std::vector<std::string> warnings;  ///< what was left out or repaired, one line each, without the path
};

/// Loads a level. Everything is checked before it is handed out (tinygltf and stb_image accept most malformed files).
/// Errors are one line that starts with the path. External buffers and images are only read from the file's own
/// folder and below; absolute paths, "..", links that lead outside and network addresses are refused.
/// The size of what is read is bounded (kMaxFileBytes, kMaxImagePixels ...), so a hostile file costs no memory.
Result<Import> loadGltf(const std::filesystem::path& path);

}  // namespace tyndall::scene
