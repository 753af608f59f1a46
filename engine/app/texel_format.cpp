#include "texel_format.hpp"

#include <cmath>
#include <cstring>

#include <glm/gtc/packing.hpp>

#include "base/assert.hpp"

namespace tyndall::app {
namespace {

float linearFromSrgb(float c) {  // IEC 61966-2-1
  return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
}

template <class Stored, class Convert>
void decode(const std::byte* texels, std::vector<float>& values, Convert convert) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    Stored stored;
    std::memcpy(&stored, texels + i * sizeof stored, sizeof stored);
    values[i] = convert(stored);
  }
}

/// Formats that pack a texel into one word of 32 bits.
template <class Convert>
void decodePacked(const std::byte* texels, std::vector<float>& values, std::uint32_t channels, Convert convert) {
  for (std::size_t i = 0; i < values.size() / channels; ++i) {
    std::uint32_t word;
    std::memcpy(&word, texels + i * sizeof word, sizeof word);
    const auto texel = convert(word);
    for (std::uint32_t c = 0; c < channels; ++c) values[i * channels + c] = texel[static_cast<int>(c)];
  }
}

}  // namespace

TexelFormat texelFormat(VkFormat format) {
  switch (format) {
    case VK_FORMAT_R8_UNORM: return {"R8 unorm", 1};
    case VK_FORMAT_R8G8B8A8_UNORM: return {"RGBA8 unorm", 4};
    case VK_FORMAT_R8G8B8A8_SRGB: return {"RGBA8 sRGB", 4};
    case VK_FORMAT_A2B10G10R10_UNORM_PACK32: return {"RGB10A2 unorm", 4};
    case VK_FORMAT_B10G11R11_UFLOAT_PACK32: return {"RG11B10 float", 3};
    case VK_FORMAT_R16_UNORM: return {"R16 unorm", 1};
    case VK_FORMAT_R16G16_UNORM: return {"RG16 unorm", 2};
    case VK_FORMAT_R16G16B16A16_UNORM: return {"RGBA16 unorm", 4};
    case VK_FORMAT_R16_SFLOAT: return {"R16 float", 1};
    case VK_FORMAT_R16G16_SFLOAT: return {"RG16 float", 2};
    case VK_FORMAT_R16G16B16A16_SFLOAT: return {"RGBA16 float", 4};
    case VK_FORMAT_R32_SFLOAT: return {"R32 float", 1};
    case VK_FORMAT_D32_SFLOAT: return {"D32 float", 1};
    case VK_FORMAT_R32G32_SFLOAT: return {"RG32 float", 2};
    case VK_FORMAT_R32G32B32A32_SFLOAT: return {"RGBA32 float", 4};
    default: return {};
  }
}

std::vector<float> decodeTexels(VkFormat format, const std::byte* texels, std::size_t count) {
  const TexelFormat known = texelFormat(format);
  TY_ASSERT(known.name, "format " + std::to_string(format) + " has no decoder");
  std::vector<float> values(count * known.channels);
  switch (format) {
    case VK_FORMAT_R8_UNORM:
    case VK_FORMAT_R8G8B8A8_UNORM:
      decode<std::uint8_t>(texels, values, [](std::uint8_t v) { return static_cast<float>(v) / 255.0f; });
      break;
    case VK_FORMAT_R8G8B8A8_SRGB:
      decode<std::uint8_t>(texels, values, [](std::uint8_t v) { return static_cast<float>(v) / 255.0f; });
      for (std::size_t i = 0; i < values.size(); ++i)
        if (i % 4 != 3) values[i] = linearFromSrgb(values[i]);
      break;
    case VK_FORMAT_A2B10G10R10_UNORM_PACK32:
      decodePacked(texels, values, 4, [](std::uint32_t w) { return glm::unpackUnorm3x10_1x2(w); });
      break;
    case VK_FORMAT_B10G11R11_UFLOAT_PACK32:
      decodePacked(texels, values, 3, [](std::uint32_t w) { return glm::unpackF2x11_1x10(w); });
      break;
    case VK_FORMAT_R16_UNORM:
    case VK_FORMAT_R16G16_UNORM:
    case VK_FORMAT_R16G16B16A16_UNORM:
      decode<std::uint16_t>(texels, values, [](std::uint16_t v) { return static_cast<float>(v) / 65535.0f; });
      break;
    case VK_FORMAT_R16_SFLOAT:
    case VK_FORMAT_R16G16_SFLOAT:
    case VK_FORMAT_R16G16B16A16_SFLOAT:
      decode<std::uint16_t>(texels, values, [](std::uint16_t v) { return glm::unpackHalf1x16(v); });
      break;
    default: std::memcpy(values.data(), texels, values.size() * sizeof(float)); break;  // 32-bit floats
  }
  return values;
}

void unitFromOct(float u, float v, float out[3]) {
  const float x = u * 2 - 1, y = v * 2 - 1, z = 1 - std::abs(x) - std::abs(y);
  const float sx = x >= 0 ? 1.0f : -1.0f, sy = y >= 0 ? 1.0f : -1.0f;
  const float fx = z < 0 ? (1 - std::abs(y)) * sx : x, fy = z < 0 ? (1 - std::abs(x)) * sy : y;
  const float length = std::sqrt(fx * fx + fy * fy + z * z);
  out[0] = fx / length, out[1] = fy / length, out[2] = z / length;
}

}  // namespace tyndall::app
