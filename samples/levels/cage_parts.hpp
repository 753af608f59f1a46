// The parts of the store room with the cage; cage.cpp puts them together.
#pragma once

#include "level_builder.hpp"
#include "levels/cage_plan.hpp"
#include "props.hpp"
#include "random.hpp"

namespace tyndall::levels::cage {

struct Materials {
  Coat brick, paving, dressed, planks, timber, rust, rustyBars, sack, rope;
  std::int32_t iron, brass, bulb, glass, embers;
};

void addRoom(LevelBuilder& level, const Materials& m);   ///< floor, walls, ceiling, beams, posts, door
void addLoft(LevelBuilder& level, const Materials& m);   ///< deck, rail and stair
void addLamp(LevelBuilder& level, const Materials& m);   ///< the caged lamp, which swings with its light
void addStove(LevelBuilder& level, const Materials& m);  ///< with embers behind its bars
void addGoods(LevelBuilder& level, const Materials& m);  ///< crates, barrels, sacks, rack, wheel, trellis, tackle

}  // namespace tyndall::levels::cage
