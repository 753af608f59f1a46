// Every pipeline of the frame as data: shaders, bindings, targets, states. Binding numbers are those of shaders/engine.
#pragma once

#include <cstdint>

#include "draw_list.hpp"
#include "pipeline_library.hpp"

namespace tyndall::render {

inline constexpr VkFormat kDepthFormat = VK_FORMAT_D32_SFLOAT;
inline constexpr VkFormat kBaseFormat = VK_FORMAT_R8G8B8A8_SRGB;         ///< base colour, A occlusion
inline constexpr VkFormat kNormalFormat = VK_FORMAT_R16G16B16A16_UNORM;  ///< normal, metallic / 2 or unlit, roughness
inline constexpr VkFormat kEmissiveFormat = VK_FORMAT_B10G11R11_UFLOAT_PACK32;
/// Full floats: a highlight of a real sun (1e5 lux) is beyond half floats, and infinity would survive the composition.
inline constexpr VkFormat kColorFormat = VK_FORMAT_R32G32B32A32_SFLOAT;
inline constexpr VkFormat kPictureFormat = VK_FORMAT_R8G8B8A8_UNORM;
inline constexpr VkFormat kDistanceFormat = VK_FORMAT_R32_SFLOAT;

/// Of moment shadow maps with 64 bits a texel, quantised, and with 128.
inline constexpr VkFormat kMoments64Format = VK_FORMAT_R16G16B16A16_UNORM;
inline constexpr VkFormat kMoments128Format = VK_FORMAT_R32G32B32A32_SFLOAT;

/// How surfaces read shadow maps: SHADOW_MAPS of engine/include/lights.glsl.
enum class ShadowMaps : std::uint32_t { kDepths = 0, kQuantisedMoments = 1, kMoments = 2 };

/// Push constants of lighting.frag and transparent.frag: a part of the light array.
struct UnshadowedLights {
  std::uint32_t first = 0, count = 0;
};
/// Push constants of distance.frag and debug_view.frag.
struct DistancePush {
  float tangentX, tangentY, width, height, znear, zfar;
};
struct DebugPush {
  float width, height;
  std::uint32_t channel;
  float low, high;
};

/// `textures`: shared::k...Map bits, of the maps that the shader looks up.
Recipe gbufferRecipe(Facing facing, bool mask, std::uint32_t textures);
Recipe casterRecipe(bool mask);
/// `slots`: how many shadow maps the shader reads, at most kShadowSlots. `cookies`: some light has one.
Recipe transparentRecipe(Facing facing, std::uint32_t textures, std::uint32_t slots, ShadowMaps maps, bool cookies);
/// `base`: the first pass, which also writes sky and emission; others add.
Recipe lightingRecipe(bool base, std::uint32_t slots, ShadowMaps maps, bool cookies);
/// `metered`: the exposure is a factor on what exposure_adapt.comp has found.
Recipe compositeRecipe(bool scatter, bool metered);
Recipe distanceRecipe();
Recipe debugViewRecipe();
ComputeRecipe exposureMeterRecipe(bool scatter);
ComputeRecipe exposureAdaptRecipe();
/// `rows`: the first direction, from depths; else the second, from what the first made.
ComputeRecipe momentBlurRecipe(bool rows, VkFormat format);
ComputeRecipe momentMipRecipe();
/// Widens the occluders of one layer of the sky's maps.
ComputeRecipe skySpreadRecipe();

}  // namespace tyndall::render
