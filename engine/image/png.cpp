// PNG through stb (Debian ships it as a library, so no STB_*_IMPLEMENTATION here).
#include <array>
#include <cstring>
#include <memory>
#include <span>

#include <stb_image.h>
#include <stb_image_write.h>

#include "base/file.hpp"
#include "checks.hpp"
#include "image/image_io.hpp"

namespace tyndall::image {
namespace {

constexpr std::array<unsigned char, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

std::size_t bigEndian32(const std::byte* bytes) {
  std::size_t value = 0;
  for (int i = 0; i < 4; ++i) value = value << 8 | std::to_integer<std::size_t>(bytes[i]);
  return value;
}

/// stb_image takes cut-off files for whole ones, so walk the chunks (PNG specification, 5.3) up to IEND first.
bool complete(std::span<const std::byte> bytes) {
  constexpr std::size_t kChunkOverhead = 12;  // length, type, checksum
  if (bytes.size() < kSignature.size() || std::memcmp(bytes.data(), kSignature.data(), kSignature.size()) != 0)
    return false;
  std::size_t at = kSignature.size();
  while (bytes.size() - at >= kChunkOverhead) {
    const std::size_t length = bigEndian32(bytes.data() + at);
    if (length > bytes.size() - at - kChunkOverhead) return false;
    if (std::memcmp(bytes.data() + at + 4, "IEND", 4) == 0) return true;
    at += kChunkOverhead + length;
  }
  return false;
}

void append(void* context, void* data, int size) {
  const auto* bytes = static_cast<const std::byte*>(data);
  auto* out = static_cast<std::vector<std::byte>*>(context);
  out->insert(out->end(), bytes, bytes + size);
}

}  // namespace

Result<void> writePng(const std::filesystem::path& path, const ByteImage& image) {
  if (auto size = checkSize(path.string(), image.width, image.height); !size) return size;
  TY_ASSERT(image.channels == 3 || image.channels == 4, std::to_string(image.channels));
  assertComplete(image);
  // stb encodes with int sizes.
  constexpr std::size_t kMaxBytes = std::size_t{1} << 30;
  if (image.values.size() > kMaxBytes)
    return failed(path.string() + ": a picture of " + sizeText(image.width, image.height) +
                  " pixels does not fit a PNG encoder of 1 GiB; choose a smaller size");
  std::vector<std::byte> bytes;
  const int done = stbi_write_png_to_func(append, &bytes, static_cast<int>(image.width), static_cast<int>(image.height),
                                          static_cast<int>(image.channels), image.values.data(),
                                          static_cast<int>(image.width * image.channels));
  if (!done || bytes.empty()) return failed(path.string() + ": the PNG encoder ran out of memory");
  return writeFileAtomically(path, bytes);
}

Result<ByteImage> readPng(const std::filesystem::path& path) {
  auto bytes = readFile(path, std::uint64_t{1} << 30);
  if (!bytes) return bytes.error();
  if (!complete(bytes.value())) return failed(path.string() + ": not a PNG file, or cut off");
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes->data());
  const int size = static_cast<int>(bytes->size());
  int width = 0, height = 0, channels = 0;
  if (!stbi_info_from_memory(data, size, &width, &height, &channels))
    return failed(path.string() + ": not a readable PNG file: " + stbi_failure_reason());
  if (auto checked = checkSize(path.string(), static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height));
      !checked)
    return checked.error();
  const int wanted = channels == 2 || channels == 4 ? 4 : 3;
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(data, size, &width, &height, &channels, wanted), stbi_image_free);
  if (!pixels) return failed(path.string() + ": not a readable PNG file: " + stbi_failure_reason());
  ByteImage image{
      static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), static_cast<std::uint32_t>(wanted), {}};
  image.values.assign(pixels.get(), pixels.get() + std::size_t{image.width} * image.height * image.channels);
  return image;
}

}  // namespace tyndall::image
