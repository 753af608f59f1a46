// A level of a few triangles: a floor, a box on it, a pane of glass, a spot light, a sun, two cameras. A frame of it
// costs next to nothing, so that tests of the window do not pay for the picture.
#pragma once

#include <filesystem>

namespace tyndall::editor_test {

/// Nodes, by index, of the file written.
inline constexpr int kBoxNode = 1, kSpotNode = 3, kSunNode = 4;
/// Materials.
inline constexpr int kBoxMaterial = 1, kGlassMaterial = 2;

/// Throws when it cannot be written.
void writeTinyLevel(const std::filesystem::path& file);

}  // namespace tyndall::editor_test
