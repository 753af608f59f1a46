#include "image_decode.hpp"

#include <cstring>
#include <string>

#include "png.hpp"
#include "scene/limits.hpp"

namespace tyndall::scene {
namespace {

template <std::size_t N>
bool startsWith(std::span<const std::byte> bytes, const char (&magic)[N]) {
  return bytes.size() >= N - 1 && std::memcmp(bytes.data(), magic, N - 1) == 0;
}

}  // namespace

Result<void> checkImageSize(std::uint64_t width, std::uint64_t height, std::uint64_t maxPixels) {
  if (width == 0 || height == 0) return failed("has no pixels");
  if (width > kMaxImageSide || height > kMaxImageSide || width * height > maxPixels)
    return failed("is " + std::to_string(width) + " x " + std::to_string(height) + " pixels; at most " +
                  std::to_string(kMaxImageSide) + " a side and " + std::to_string(maxPixels) + " in all are decoded");
  return {};
}

Result<Image> decodeImage(std::span<const std::byte> bytes, std::uint64_t maxPixels) {
  if (startsWith(bytes, "\x89PNG\r\n\x1a\n")) return decodePng(bytes, maxPixels);
  if (startsWith(bytes, "\xff\xd8\xff")) return decodeJpeg(bytes, maxPixels);
  if (startsWith(bytes, "RIFF")) return failed("is a WebP image; only PNG and JPEG are read");
  if (startsWith(bytes, "\xabKTX")) return failed("is a KTX image; only PNG and JPEG are read");
  return failed("is neither PNG nor JPEG");
}

}  // namespace tyndall::scene
