// Bounds on what an importer reads, so that a small hostile file cannot cost much memory or time. Each is several
// times what a large real level needs; a file beyond one is refused with a line that names the bound.
#pragma once

#include <cstddef>
#include <cstdint>

namespace tyndall::scene {

/// Everything read for one level together: the file, its buffers, its encoded images. A .glb is at most 4 GiB.
inline constexpr std::uint64_t kMaxFileBytes = 1ull << 30;
/// JSON values in one file (a node takes about 15); how deep they nest: base/json_shape.hpp.
inline constexpr std::size_t kMaxJsonValues = 4'000'000;
/// One image (8192 x 8192), and all images together: 4 bytes a pixel once decoded.
inline constexpr std::uint64_t kMaxImagePixels = 1ull << 26;
inline constexpr std::uint64_t kMaxTotalPixels = 1ull << 28;
inline constexpr std::uint32_t kMaxImageSide = 16384;
/// All primitives together, after expansion: a vertex takes 64 bytes, an index 4.
inline constexpr std::size_t kMaxVertices = 1u << 24;
inline constexpr std::size_t kMaxIndices = 1u << 26;
inline constexpr std::size_t kMaxNodes = 1u << 20;
/// Values of all animation channels together, 16 bytes each.
inline constexpr std::size_t kMaxAnimationValues = 1u << 24;
/// Longest side of the level's bounding box and farthest coordinate, metres; beyond it float depth is meaningless.
inline constexpr float kMaxExtent = 1e9f;
/// Linear factors on radiance that a level may ask for.
inline constexpr double kMinExposure = 1e-12, kMaxExposure = 1e12;

}  // namespace tyndall::scene
