// PNG and JPEG to 8-bit RGBA, strictly: what libpng or libjpeg calls damaged is refused.
#pragma once

#include <cstddef>
#include <span>

#include "base/result.hpp"
#include "scene/scene.hpp"

namespace tyndall::scene {

/// Recognises the format by its first bytes, not by a name or MIME type. At most maxPixels are decoded.
Result<Image> decodeImage(std::span<const std::byte> bytes, std::uint64_t maxPixels);

/// Baseline and progressive JPEG, grey or colour.
Result<Image> decodeJpeg(std::span<const std::byte> bytes, std::uint64_t maxPixels);

/// "is W x H pixels; at most ..." or nothing when the size is acceptable.
Result<void> checkImageSize(std::uint64_t width, std::uint64_t height, std::uint64_t maxPixels);

}  // namespace tyndall::scene
