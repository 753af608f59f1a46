// Which lights get shadow maps, in which order they are lit, and how shaders see them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/frame.hpp"
#include "shadow_fit.hpp"
#include "shared/light.h"

namespace tyndall::render {

/// Memory that all shadow maps of a frame may take together.
inline constexpr std::uint64_t kShadowBudgetBytes = 1ull << 30;
/// Of one texel of a shadow map (D32).
inline constexpr double kDepthTexelBytes = 4;
/// Shadow maps that one lighting pass reads.
using shared::kShadowSlots;

/// Texels a side below which no map goes for want of memory.
inline constexpr std::uint32_t kLeastShadowSide = 32;

struct PlannedLight {
  std::uint32_t source = 0;  ///< index into the frame's lights
  std::uint32_t size = 0;    ///< texels a side of its map
  ShadowFit fit;             ///< meaningless for lights without a map
};

struct LightPlan {
  /// Lights with maps, most important first: suns, then by their irradiance at the eye.
  std::vector<PlannedLight> shadowed;
  /// Lights for whose smallest maps there is no memory: they light nothing, rather than through walls. Indices into the
  /// frame's lights.
  std::vector<std::uint32_t> unshadowed;
  std::vector<std::string> notes;
  /// The order of the shaders' light array: shadowed, then unshadowed.
  std::vector<shared::LightBlock> blocks;
};

/// Where maps of `shadowSize` do not fit into the budget, those of weaker lights are halved first, and again, down to
/// kLeastShadowSide: sides differ by a factor of two at most, and do not hang on the camera.
/// `texelBytes`: what a light's maps take for each texel, all of them together.
LightPlan planLights(const View& view, const std::vector<scene::LightView>& lights, const scene::Bounds& casters,
                     std::uint32_t shadowSize, std::uint64_t budgetBytes = kShadowBudgetBytes,
                     double texelBytes = kDepthTexelBytes);

/// Pixels a light can reach: the whole view unless it has a range and the sphere of that range lies before the eye.
struct PixelRect {
  std::int32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;  ///< [x0, x1) x [y0, y1)
  bool empty() const { return x0 >= x1 || y0 >= y1; }
  void add(const PixelRect& other);
};
PixelRect reach(const View& view, const scene::LightView& light);

}  // namespace tyndall::render
