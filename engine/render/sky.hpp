// Radiances of the analytic sky (shaders/engine/include/sky.glsl), in proportion to the suns.
#pragma once

#include <vector>

#include "scene/scene.hpp"
#include "shared/view.h"

namespace tyndall::render {

/// Fills the sky members of `block` from the directional lights.
void fillSky(shared::ViewBlock& block, const std::vector<scene::LightView>& lights);

}  // namespace tyndall::render
