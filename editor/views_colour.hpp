// From numbers to colours: stretching, false colours, signed errors.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tyndall::editor {

using Rgb = std::array<std::uint8_t, 3>;

/// What is shown of an image of some channels.
struct Stretch {
  std::uint32_t channel = 0;  ///< 0 to 3: one alone; 4: the first three as a colour, sRGB-coded
  bool falseColour = false;   ///< of a single channel; else grey
  float low = 0, high = 1;    ///< shown as the least and the greatest
};

struct Range {
  float low = 0, high = 1;
};
/// Values at the shares `low` and `high` (0 to 1, nearest rank) of the finite values of a channel, or of the first
/// three (channel 4). They differ: a constant is the middle of its range. No finite value: 0 to 1.
Range percentiles(std::span<const float> values, std::uint32_t channels, std::uint32_t channel, double low,
                  double high);

/// Viridis (van der Walt and Smith 2015), t in [0, 1].
Rgb falseColour(float t);
/// Blue over white to red (ColorBrewer's RdBu, Harrower and Brewer 2003), t in [-1, 1].
Rgb signedColour(float t);
/// What is not a number.
inline constexpr Rgb kNotFinite{255, 0, 255};

/// RGBA bytes, opaque.
std::vector<std::uint8_t> stretched(std::span<const float> values, std::uint32_t channels, const Stretch& stretch);
/// The mean of the first three channels of `image` minus that of `reference`; +-`most` are the ends of signedColour().
std::vector<std::uint8_t> errorMap(std::span<const float> image, std::span<const float> reference,
                                   std::uint32_t channels, float most);

}  // namespace tyndall::editor
