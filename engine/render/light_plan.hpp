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

struct PlannedLight {
  std::uint32_t source = 0;  ///< index into the frame's lights
  ShadowFit fit;             ///< meaningless for lights without a map
};

struct LightPlan {
  /// Lights with maps, most important first: suns, then by their irradiance at the eye.
  std::vector<PlannedLight> shadowed;
  std::vector<std::uint32_t> unshadowed;  ///< indices into the frame's lights
  std::vector<std::string> notes;
  /// The order of the shaders' light array: shadowed, then unshadowed.
  std::vector<shared::LightBlock> blocks;
};

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
