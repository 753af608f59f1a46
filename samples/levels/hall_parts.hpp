// The hall's parts; hall.cpp puts them together.
#pragma once

#include "level_builder.hpp"
#include "levels/hall_plan.hpp"
#include "random.hpp"
#include "wall.hpp"

namespace tyndall::levels::hall {

/// Indices of the materials.
struct Materials {
  std::int32_t ashlar, flags, dressed, planks, timber, darkTimber, runner, bannerSun, bannerCross, glass, iron, gold,
      wax, flame, lamp, earth;
};

constexpr int kWindows = kBays;
/// The openings' contours in their walls' frames (wall.hpp).
Outline windowOutline(bool inner);
Outline roseOutline(bool inner);
Outline doorOutline(bool inner);
inline constexpr int kDoorBay = 3, kStainedBay = 1;
inline constexpr float kSill = 2.6f, kSpring = 7.2f, kWindowHalf = 0.75f, kRoseY = 8.3f, kRoseRadius = 1.55f;
inline constexpr float kDoorHalf = 1.05f, kDoorSpring = 2.2f;

void addShell(LevelBuilder& level, const Materials& m);      ///< floor, walls, roof, ground outside
void addTracery(LevelBuilder& level, const Materials& m);    ///< bars and glass of the windows
void addPillars(LevelBuilder& level, const Materials& m);    ///< pillars, posts, pilasters, dais
void addTimber(LevelBuilder& level, const Materials& m);     ///< trusses, purlins, rafters
void addGallery(LevelBuilder& level, const Materials& m);    ///< gallery with its stairs
void addFurniture(LevelBuilder& level, const Materials& m);  ///< tables, benches, crates, barrels, throne
void addHangings(LevelBuilder& level, const Materials& m);   ///< banners, runner, chandeliers, lanterns
void addDoor(LevelBuilder& level, const Materials& m);       ///< the leaf that moves

}  // namespace tyndall::levels::hall
