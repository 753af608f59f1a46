#include "screen.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace tyndall::editor_test {
namespace {

// Words of the header (X11/XWDFile.h), each of 32 bits, the greatest byte first.
enum Word {
  kHeaderSize = 0,
  kVersion = 1,
  kWidth = 4,
  kHeight = 5,
  kByteOrder = 7,
  kBitsPerPixel = 11,
  kBytesPerLine = 12,
  kColours = 19,
  kWords = 25
};
constexpr std::uint32_t kColourBytes = 12;

}  // namespace

image::ByteImage readScreen(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  const auto word = [&](Word which) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
      value = value << 8 | static_cast<std::uint8_t>(bytes[4 * static_cast<std::size_t>(which) + i]);
    return value;
  };
  if (bytes.size() < 4 * kWords) throw std::runtime_error(path.string() + ": is no screen");
  if (word(kVersion) != 7 || word(kBitsPerPixel) != 32 || word(kByteOrder) != 0)
    throw std::runtime_error(path.string() + ": is not 32 bits a pixel, the least byte first");
  image::ByteImage picture{word(kWidth), word(kHeight), 3, {}};
  const std::size_t start = word(kHeaderSize) + std::size_t{word(kColours)} * kColourBytes, line = word(kBytesPerLine);
  if (bytes.size() < start + line * picture.height) throw std::runtime_error(path.string() + ": ends too early");
  for (std::size_t y = 0; y < picture.height; ++y)
    for (std::size_t x = 0; x < picture.width; ++x)
      for (std::size_t c = 0; c < 3; ++c)  // stored blue first
        picture.values.push_back(static_cast<std::uint8_t>(bytes[start + y * line + 4 * x + 2 - c]));
  return picture;
}

Area Area::of(const std::vector<double>& rect) {
  const auto whole = [](double value) { return static_cast<std::uint32_t>(std::max(value, 0.0)); };
  return {whole(std::ceil(rect[0])), whole(std::ceil(rect[1])), whole(rect[0] + rect[2]), whole(rect[1] + rect[3])};
}

image::ByteImage part(const image::ByteImage& picture, const Area& area) {
  const std::uint32_t right = std::min(area.right, picture.width), bottom = std::min(area.bottom, picture.height);
  image::ByteImage result{right - std::min(area.left, right), bottom - std::min(area.top, bottom), 3, {}};
  for (std::uint32_t y = bottom - result.height; y < bottom; ++y) {
    const auto row = picture.values.begin() +
                     static_cast<std::ptrdiff_t>((std::size_t{y} * picture.width + right - result.width) * 3);
    result.values.insert(result.values.end(), row, row + static_cast<std::ptrdiff_t>(result.width * 3));
  }
  return result;
}

double changedShare(const image::ByteImage& a, const image::ByteImage& b) {
  if (a.width != b.width || a.height != b.height) return 1;
  std::size_t changed = 0;
  const std::size_t pixels = std::size_t{a.width} * a.height;
  for (std::size_t i = 0; i < pixels; ++i)
    changed += !std::equal(a.values.begin() + static_cast<std::ptrdiff_t>(3 * i),
                           a.values.begin() + static_cast<std::ptrdiff_t>(3 * i + 3),
                           b.values.begin() + static_cast<std::ptrdiff_t>(3 * i));
  return pixels == 0 ? 0 : static_cast<double>(changed) / static_cast<double>(pixels);
}

double brightness(const image::ByteImage& picture) {
  double sum = 0;
  for (const std::uint8_t value : picture.values) sum += value;
  return picture.values.empty() ? 0 : sum / static_cast<double>(picture.values.size());
}

}  // namespace tyndall::editor_test
