// Texels of the engine's image formats as floats.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <volk.h>

namespace tyndall::app {

struct TexelFormat {
  const char* name = nullptr;  ///< "RGBA16 unorm"; null: none that is known here
  std::uint32_t channels = 0;
};
TexelFormat texelFormat(VkFormat format);

/// Decodes `count` tightly packed texels into count * channels values, as a shader would read them.
std::vector<float> decodeTexels(VkFormat format, const std::byte* texels, std::size_t count);

/// A unit vector from its octahedral code in [0, 1] (shaders/engine/include/encode.glsl).
void unitFromOct(float u, float v, float out[3]);

}  // namespace tyndall::app
