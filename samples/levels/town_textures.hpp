// What the town is made of. Every surface tiles; the size of one tile in metres stands beside it.
#pragma once

#include "canvas.hpp"

namespace tyndall::levels::town {

inline constexpr float kCobbleTile = 2.4f, kPlasterTile = 3.0f, kTileTile = 1.6f, kStripeTile = 1.2f;

Surface cobbles();  ///< worn setts with puddles between, 2.4 m
Surface plaster();  ///< stained, flaking over stone, 3 m; to be tinted
Surface tiles();    ///< a roof's plain tiles, 1.6 m
Surface stripes();  ///< an awning's cloth, 1.2 m

/// Windows: what the glass lets through, bars black; they fill the image. Alpha: how much the pane hides.
scene::Image leadedWindow();  ///< diamonds of uneven glass in lead
scene::Image panedWindow();   ///< upright panes between wooden bars, curtains at the sides

}  // namespace tyndall::levels::town
