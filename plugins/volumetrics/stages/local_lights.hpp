// Spot and point lights on the CPU: their uniform blocks, and which of them reach no view ray.
#pragma once

#include "geometry/camera_rays.hpp"
#include "technique.hpp"
#include "tyndall/plugin.h"

namespace volumetrics {

/// A spot or point light and its perspective shadow map, relative to `eye` (m, world).
LocalBlock localBlock(const TyLight& light, const glm::vec3& eye);

/// The cookie of a light of any kind; faces 0 without one, or with a host of before the cookies.
CookieBlock cookieBlock(const TyLight& light, const glm::vec3& eye);

/// False only if the light's cone and range lie outside the view's frustum (or it is black): then no view ray scatters
/// its light.
bool reachesView(const LocalBlock& light, const RayBlock& rays);

/// Share of the picture, in (0, 1], that the square around the light's range has on screen, as far as it is on it; 1
/// without a range.
double screenShare(const LocalBlock& light, const RayBlock& rays);

/// Fills block `block` of every spot and point light, and leaves out the passes (LayoutRoles::localPasses) of those
/// that reach no view ray.
void prepareLocalLights(const FrameContext& context, std::uint32_t block, const RayBlock& rays);

}  // namespace volumetrics
