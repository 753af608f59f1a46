// The vault's parts; vault.cpp puts them together.
#pragma once

#include "level_builder.hpp"
#include "levels/vault_plan.hpp"
#include "props.hpp"
#include "random.hpp"

namespace tyndall::levels::vault {

struct Materials {
  Coat rubble, brick, paving, dressed, planks, timber, rock, rust, rustyBars;
  std::int32_t iron, wax, flame, bulb, rose, brass;
};

void addShell(LevelBuilder& level, const Materials& m);    ///< floor, walls, vault, well, the chamber behind the window
void addStone(LevelBuilder& level, const Materials& m);    ///< ribs, pilasters, columns, altar, tracery of the window
void addGrating(LevelBuilder& level, const Materials& m);  ///< bars, fan, chain, the lamp in the well
void addThings(LevelBuilder& level, const Materials& m);   ///< tombs, rubble, ladder, crates, candles

}  // namespace tyndall::levels::vault
