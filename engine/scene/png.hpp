// PNG in memory, by libpng. Colour profiles and gamma chunks are ignored, as glTF 2.0 asks.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/result.hpp"
#include "scene/scene.hpp"

namespace tyndall::scene {

/// RGB when every pixel is opaque, else RGBA; 8 bits a channel. Errors say what libpng said.
Result<std::vector<std::byte>> encodePng(const Image& image);

/// Any PNG to 8-bit RGBA. At most maxPixels are decoded; damaged and truncated files are refused.
Result<Image> decodePng(std::span<const std::byte> bytes, std::uint64_t maxPixels);

}  // namespace tyndall::scene
