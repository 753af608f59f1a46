// Picture files: 8-bit PNG (stb) and 32-bit float EXR (OpenEXR). Everything is encoded in memory and written all or
// nothing; nothing throws.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "base/result.hpp"

namespace tyndall::image {

/// Longest side of a picture that is read or written, pixels.
inline constexpr std::uint32_t kMaxSide = 32768;

/// Linear values, interleaved, row 0 on top: values[(y * width + x) * channels + c].
struct FloatImage {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t channels = 0;  ///< 1, 3 (R,G,B) or 4 (R,G,B,A)
  std::vector<float> values;

  float& at(std::uint32_t x, std::uint32_t y, std::uint32_t c) { return values[index(x, y, c)]; }
  float at(std::uint32_t x, std::uint32_t y, std::uint32_t c) const { return values[index(x, y, c)]; }

 private:
  std::size_t index(std::uint32_t x, std::uint32_t y, std::uint32_t c) const {
    return (std::size_t{y} * width + x) * channels + c;
  }
};

/// 8-bit sRGB-coded colour, interleaved, row 0 on top. Alpha is linear and not premultiplied.
struct ByteImage {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t channels = 0;  ///< 3 (R,G,B) or 4 (R,G,B,A)
  std::vector<std::uint8_t> values;
};

/// 32-bit float, lossless (ZIP), line order from the top. Channels are named R,G,B and A; a picture of one channel is
/// named Z, as OpenEXR names depth (here: metres along the ray). Infinities and NaN are stored as they are.
Result<void> writeExr(const std::filesystem::path& path, const FloatImage& image);

/// Reads R,G,B and, when present, A; or the file's only channel whatever its name. Half and uint become float. Other
/// sets of channels are an error that lists them.
Result<FloatImage> readExr(const std::filesystem::path& path);

Result<void> writePng(const std::filesystem::path& path, const ByteImage& image);

/// Reads a PNG of any kind as 8-bit RGB, or RGBA when it has transparency. Truncated files are errors.
Result<ByteImage> readPng(const std::filesystem::path& path);

}  // namespace tyndall::image
