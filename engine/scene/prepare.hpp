// Everything between a file's bytes and tinygltf: JSON checked against the schema and reduced to what the importer
// reads, buffers and images fetched. tinygltf then sees only sound input and opens nothing by itself.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "container.hpp"
#include "import_log.hpp"

namespace tyndall::scene {

struct Prepared {
  /// glTF whose buffers and images have the URIs "buffer/N" and "image/N".
  std::string json;
  std::vector<std::vector<std::byte>> buffers;  ///< empty: the bytes are absent (a placeholder of an extension)
  std::vector<std::vector<std::byte>> images;   ///< encoded; empty: no material shows it
  std::vector<std::string> imageNames;          ///< how messages call each image
  std::uint64_t contentHash = 0;                ///< of the files beside the level that were read
  bool hasMeshes = false;                       ///< the file has some, be they broken
};

/// `fileSize`: counts towards kMaxFileBytes.
Prepared prepare(const Container& container, const std::filesystem::path& path, std::uint64_t fileSize,
                 Warnings& warnings);

}  // namespace tyndall::scene
