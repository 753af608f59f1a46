// Cookies of a level's lights on the GPU: one array of square layers for all of them, because samplers cannot be
// indexed everywhere. A spot or directional light's image takes one layer, a point light's six, the faces of a cube.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "base/result.hpp"
#include "gpu/device.hpp"
#include "scene/scene.hpp"
#include "shared/light.h"

namespace tyndall::render {

/// Side of a layer at most, and memory of all layers with their mips; larger images are averaged down to what fits.
inline constexpr std::uint32_t kMaxCookieSide = 1024;
inline constexpr std::uint64_t kCookieBudgetBytes = 256ull << 20;
/// Linear, so that mips and filters average light; half floats hold every 8-bit sRGB code to 1 in 4096.
inline constexpr VkFormat kCookieFormat = VK_FORMAT_R16G16B16A16_SFLOAT;

struct CookiePlace {
  std::uint32_t layer = 0;     ///< the first
  std::uint32_t faces = 1;     ///< 1, or 6 in the order +X -X +Y -Y +Z -Z, oriented as Vulkan's cube maps are
  glm::bvec2 repeat{false};    ///< whether a directional light's tile repeats; else its border goes on
  glm::bvec2 mirrored{false};  ///< the tile is the image and its mirror image, twice as long, and repeats
};

struct Cookies {
  gpu::Image image;  ///< kCookieFormat, all mips, in SHADER_READ_ONLY; empty when no light has a cookie
  std::map<std::pair<std::int32_t, scene::LightKind>, CookiePlace> places;  ///< by texture and kind of light

  std::optional<CookiePlace> find(const scene::Light& light) const;
};
/// Errors: lack of memory, more layers than the device takes.
Result<Cookies> uploadCookies(gpu::Device& device, const scene::Scene& scene);

/// World point to the cookie's space: x and y over w go from -1 to 1 over the tile, y up; a point light's vector stays
/// in the frame of its faces.
glm::mat4 cookieFromWorld(const scene::LightView& light, const CookiePlace& place);

/// As lights.glsl reads it; faces 0 without a cookie.
shared::CookieBlock cookieBlock(const scene::LightView& light, const Cookies& cookies);

}  // namespace tyndall::render
