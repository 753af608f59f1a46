// What the hall is made of. Every surface tiles; the size of one tile in metres stands beside it.
#pragma once

#include "canvas.hpp"

namespace tyndall::levels::hall {

inline constexpr float kAshlarTile = 4.0f, kFloorTile = 2.0f, kPillarTile = 2.0f, kWoodTile = 2.0f, kRunnerTile = 1.8f;

Surface ashlar();   ///< coursed stone blocks, 4 m
Surface flags();    ///< square floor tiles in two tones, 2 m
Surface dressed();  ///< fine-cut stone of pillars and tracery, 2 m
Surface planks();   ///< boards along u, 2 m
Surface timber();   ///< a beam's wood along u, without joints, 2 m
Surface runner();   ///< the carpet, as wide as one tile, 1.8 m
/// One banner, one tile: field and emblem colours sRGB-coded.
Surface banner(const glm::vec3& field, const glm::vec3& emblem, int motif);
/// Leaded coloured glass for one lancet, one tile; alpha: how much the glass hides.
scene::Image stainedGlass();

}  // namespace tyndall::levels::hall
