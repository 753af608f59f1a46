// From the ABI's view and lights to the shared uniform blocks.
#pragma once

#include <glm/glm.hpp>

#include "params/table.hpp"
#include "stages/blocks.h"
#include "tyndall/plugin.h"

namespace volumetrics {

using namespace tyndall::shared;

/// Camera rays and medium. The view is a perspective one without skew.
RayBlock rayBlock(const TyView& view, const Settings& settings);

/// A directional light and its orthographic shadow map, relative to `eye` (m, world).
SunBlock sunBlock(const TyLight& light, const glm::vec3& eye);

}  // namespace volumetrics
