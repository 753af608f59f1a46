// What every writer of this room asks of a picture before it touches the disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "base/assert.hpp"
#include "base/result.hpp"
#include "image/image_io.hpp"

namespace tyndall::image {

inline std::string sizeText(std::uint64_t width, std::uint64_t height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

/// `place` is the path or whatever names the picture in an error.
inline Result<void> checkSize(const std::string& place, std::uint64_t width, std::uint64_t height) {
  if (width >= 1 && height >= 1 && width <= kMaxSide && height <= kMaxSide) return {};
  return failed(place + ": a picture of " + sizeText(width, height) + " pixels; each side must be 1 to " +
                std::to_string(kMaxSide));
}

/// The caller's arrays and sizes disagreeing is our own bug.
template <class Picture>
void assertComplete(const Picture& picture) {
  const std::size_t expected = std::size_t{picture.width} * picture.height * picture.channels;
  TY_ASSERT(picture.values.size() == expected,
            std::to_string(picture.values.size()) + " values, " + std::to_string(expected) + " expected for " +
                sizeText(picture.width, picture.height) + "x" + std::to_string(picture.channels));
}

}  // namespace tyndall::image
