// What the vault and the cage are made of. Every surface tiles; the size of one tile in metres stands beside it.
#pragma once

#include "canvas.hpp"

namespace tyndall::levels::cellar {

inline constexpr float kBrickTile = 2.0f, kRubbleTile = 3.0f, kPavingTile = 3.0f, kRustTile = 0.8f, kSackTile = 0.6f;

Surface brick();      ///< sooty bricks in running bond, 2 m
Surface rubble();     ///< rough stones of all sizes in wide mortar, 3 m
Surface paving();     ///< worn slabs with damp patches that shine, 3 m
Surface rust();       ///< wrought iron with rust, 0.8 m
Surface sackcloth();  ///< 0.6 m

/// A rose window: leaded panes of coloured glass inside the circle that touches the image's sides, black around it.
/// The colour is what the glass lets through, for a lamp behind it too; alpha: how much the pane itself hides.
scene::Image roseWindow();

}  // namespace tyndall::levels::cellar
