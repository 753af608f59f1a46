// What the forest is made of. Surfaces tile (size in metres beside them); cut-outs stand upright in their image.
#pragma once

#include "canvas.hpp"

namespace tyndall::levels::forest {

inline constexpr float kGroundTile = 4.0f, kBarkTile = 1.2f, kRockTile = 2.0f;

Surface litter();     ///< moss, soil and fallen leaves
Surface roughBark();  ///< ridges along v
Surface birchBark();
Surface rock();
Surface planks();  ///< weathered wood, grain along u

scene::Image leafyTwig();    ///< a twig of a broad-leaved tree
scene::Image spruceFrond();  ///< a flat branch with needles
/// Left half: a tuft of grass; right half: a fern's frond.
scene::Image undergrowth();

}  // namespace tyndall::levels::forest
