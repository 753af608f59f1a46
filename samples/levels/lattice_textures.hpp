// What the shed is made of. Every surface tiles; the size of one tile in metres stands beside it.
#pragma once

#include "canvas.hpp"

namespace tyndall::levels::lattice {

inline constexpr float kConcreteTile = 4.0f, kSheetTile = 2.0f;
inline constexpr int kDiamonds = 4;  ///< of the fence, along each side of its tile

Surface concrete();        ///< a floor with joints, cracks and oil, 4 m
Surface sheet();           ///< corrugated steel, ribs along v, rust along its laps, 2 m
scene::Image chainLink();  ///< wire 16 mm thick where a diamond is 160 mm wide: cut out, it tiles

}  // namespace tyndall::levels::lattice
