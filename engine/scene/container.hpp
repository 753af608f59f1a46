// A .gltf or .glb file taken apart into its JSON text and its binary chunk.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "import_log.hpp"

namespace tyndall::scene {

struct Container {
  std::string_view json;
  std::optional<std::span<const std::byte>> binary;  ///< the BIN chunk of a .glb
};

/// Decides by the content, not by the name. Refuses broken headers and chunks; both views point into `file`.
Container openContainer(std::span<const std::byte> file, Warnings& warnings);

/// Refuses JSON text that nests deeper than kMaxJsonDepth or holds more than kMaxJsonValues, before anything parses it
/// (a parser's memory is a multiple of its text, and some recurse).
void checkJsonShape(std::string_view json);

}  // namespace tyndall::scene
