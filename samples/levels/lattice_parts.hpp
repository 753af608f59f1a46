// The parts of the shed full of lattice; lattice.cpp puts them together.
#pragma once

#include "level_builder.hpp"
#include "levels/lattice_plan.hpp"
#include "props.hpp"
#include "random.hpp"

namespace tyndall::levels::lattice {

struct Materials {
  Coat concrete, sheet, roof, rust, planks, timber, chain;
  std::int32_t iron, galvanised, yellow, bulb, glass;
};

void addShed(LevelBuilder& level, const Materials& m);  ///< floor, walls, roof, and the sunny end's openings
void addFans(LevelBuilder& level, const Materials& m);  ///< one turns
void addGirders(LevelBuilder& level, const Materials& m);
void addFences(LevelBuilder& level, const Materials& m);  ///< cut-outs, and real wire before the lamp
void addTower(LevelBuilder& level, const Materials& m);   ///< with its gratings and the lamp
void addStairs(LevelBuilder& level, const Materials& m);
void addGoods(LevelBuilder& level, const Materials& m);  ///< pallets, drums, the lamp on a tripod

/// A lattice girder from `from` to `to`, `depth` high towards `up`: two chords and a zigzag between.
void girder(MeshBuilder& b, const glm::vec3& from, const glm::vec3& to, float depth, float thick, int panels,
            const glm::vec3& up = {0, 1, 0});
/// A walkway's grating in the plane y: bars along x and, wider apart, along z.
void grating(MeshBuilder& b, const glm::vec2& min, const glm::vec2& max, float y, float pitch);

}  // namespace tyndall::levels::lattice
