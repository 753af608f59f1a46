#include "views_colour.hpp"

#include <algorithm>
#include <cmath>

namespace tyndall::editor {
namespace {

constexpr std::array<Rgb, 11> kViridis{{{68, 1, 84},
                                        {72, 36, 117},
                                        {65, 68, 135},
                                        {53, 95, 141},
                                        {42, 120, 142},
                                        {33, 145, 140},
                                        {34, 168, 132},
                                        {68, 191, 112},
                                        {122, 209, 81},
                                        {189, 223, 38},
                                        {253, 231, 37}}};
constexpr std::array<Rgb, 5> kBlueToRed{
    {{33, 102, 172}, {146, 197, 222}, {247, 247, 247}, {244, 165, 130}, {178, 24, 43}}};

std::uint8_t byte(float value) { return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255)); }

float srgbCoded(float c) {  // IEC 61966-2-1
  return c <= 0.0031308f ? c * 12.92f : 1.055f * std::pow(c, 1 / 2.4f) - 0.055f;
}

/// Colours evenly spaced over t in [0, 1], linear between.
template <std::size_t kCount>
Rgb between(const std::array<Rgb, kCount>& colours, float t) {
  const float at = std::clamp(t, 0.0f, 1.0f) * static_cast<float>(kCount - 1);
  const auto i = std::min(static_cast<std::size_t>(at), kCount - 2);
  const float share = at - static_cast<float>(i);
  Rgb mixed;
  for (std::size_t c = 0; c < 3; ++c)
    mixed[c] = static_cast<std::uint8_t>(
        std::lround(static_cast<float>(colours[i][c]) * (1 - share) + static_cast<float>(colours[i + 1][c]) * share));
  return mixed;
}

void put(std::vector<std::uint8_t>& bytes, const Rgb& colour) {
  bytes.insert(bytes.end(), {colour[0], colour[1], colour[2], 255});
}

/// Mean of the channels that are a colour.
float meanOf(const float* texel, std::uint32_t channels) {
  const std::uint32_t count = std::min(channels, 3u);
  float sum = 0;
  for (std::uint32_t c = 0; c < count; ++c) sum += texel[c];
  return sum / static_cast<float>(count);
}

}  // namespace

Range percentiles(std::span<const float> values, std::uint32_t channels, std::uint32_t channel, double low,
                  double high) {
  std::vector<float> taken;
  const std::uint32_t first = channel < 4 ? std::min(channel, channels - 1) : 0,
                      last = channel < 4 ? first + 1 : std::min(channels, 3u);
  taken.reserve(values.size() / channels * (last - first));
  for (std::size_t i = 0; i + channels <= values.size(); i += channels)
    for (std::uint32_t c = first; c < last; ++c)
      if (std::isfinite(values[i + c])) taken.push_back(values[i + c]);
  if (taken.empty()) return {};
  const auto rank = [&](double share) {
    const auto nearest =
        static_cast<std::size_t>(std::max(std::ceil(share * static_cast<double>(taken.size())), 1.0)) - 1;
    const auto at = taken.begin() + static_cast<std::ptrdiff_t>(std::min(nearest, taken.size() - 1));
    std::nth_element(taken.begin(), at, taken.end());
    return *at;
  };
  Range range{rank(low), rank(high)};
  if (!(range.high > range.low)) {
    const float half = std::max(std::abs(range.low) * 0.5f, 1e-6f);
    range = {range.low - half, range.low + half};
  }
  return range;
}

Rgb falseColour(float t) { return between(kViridis, t); }
Rgb signedColour(float t) { return between(kBlueToRed, 0.5f + 0.5f * t); }

std::vector<std::uint8_t> stretched(std::span<const float> values, std::uint32_t channels, const Stretch& stretch) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(values.size() / channels * 4);
  const float scale = 1 / (stretch.high - stretch.low);
  for (std::size_t i = 0; i + channels <= values.size(); i += channels) {
    if (stretch.channel < 4) {
      const float value = values[i + std::min(stretch.channel, channels - 1)];
      const float t = (value - stretch.low) * scale;
      if (!std::isfinite(value))
        put(bytes, kNotFinite);
      else if (stretch.falseColour)
        put(bytes, falseColour(t));
      else
        put(bytes, {byte(t), byte(t), byte(t)});
      continue;
    }
    Rgb colour{0, 0, 0};
    for (std::uint32_t c = 0; c < std::min(channels, 3u); ++c) {
      const float value = values[i + c];
      if (!std::isfinite(value)) {
        colour = kNotFinite;
        break;
      }
      colour[c] = byte(srgbCoded(std::clamp((value - stretch.low) * scale, 0.0f, 1.0f)));
    }
    put(bytes, colour);
  }
  return bytes;
}

std::vector<std::uint8_t> errorMap(std::span<const float> image, std::span<const float> reference,
                                   std::uint32_t channels, float most) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(image.size() / channels * 4);
  for (std::size_t i = 0; i + channels <= std::min(image.size(), reference.size()); i += channels) {
    const float error = meanOf(&image[i], channels) - meanOf(&reference[i], channels);
    put(bytes, std::isfinite(error) ? signedColour(error / most) : kNotFinite);
  }
  return bytes;
}

}  // namespace tyndall::editor
