// The square's parts; tower.cpp puts them together.
#pragma once

#include "level_builder.hpp"
#include "levels/tower_plan.hpp"
#include "random.hpp"

namespace tyndall::levels::tower {

struct Materials {
  std::int32_t ashlar, dressed, slates, plaster, timber, planks, paving, grass, bark, leaves, tufts, iron, bronze, glow,
      gold, canvas;
};

inline constexpr float kSlateTile = 2.0f, kPlasterTile = 3.0f;

Surface slates();   ///< courses of slates, 2 m
Surface plaster();  ///< old limewash, 3 m

float groundY(float x, float z);

void addTower(LevelBuilder& level, const Materials& m);
/// The open storey: openings with tracery, the frame and the bell that swings.
void addBelfry(LevelBuilder& level, const Materials& m);
/// Poles, platforms and ladders on the tower's west side.
void addScaffolding(LevelBuilder& level, const Materials& m);
void addChurch(LevelBuilder& level, const Materials& m);
void addHouses(LevelBuilder& level, const Materials& m);
void addSquare(LevelBuilder& level, const Materials& m);

}  // namespace tyndall::levels::tower
