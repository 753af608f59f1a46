// What is seen: the virtual display's own memory, and how two looks at it differ.
#pragma once

#include <filesystem>
#include <vector>

#include "image/image_io.hpp"

namespace tyndall::editor_test {

/// The screen as it is now, RGB, from the file that Xvfb keeps with -fbdir (X window dump format, version 7). Throws
/// what is wrong with it.
image::ByteImage readScreen(const std::filesystem::path& file);

struct Area {
  std::uint32_t left = 0, top = 0, right = 0, bottom = 0;
  /// x, y, width, height, as the state file has them.
  static Area of(const std::vector<double>& rect);
};
image::ByteImage part(const image::ByteImage& picture, const Area& area);
/// Share of the pixels of two equally large pictures that differ.
double changedShare(const image::ByteImage& a, const image::ByteImage& b);
/// Mean of all channels, 0 to 255.
double brightness(const image::ByteImage& picture);

}  // namespace tyndall::editor_test
