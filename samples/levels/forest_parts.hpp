// The forest's parts; forest.cpp puts them together. The clearing's middle is the origin.
#pragma once

#include "level_builder.hpp"
#include "random.hpp"

namespace tyndall::levels::forest {

struct Materials {
  std::int32_t litter, bark, birch, rock, planks, leaves, paleLeaves, needles, undergrowth, water;
};

inline constexpr float kHalfSize = 40.0f;  ///< the terrain reaches from -40 m to 40 m in x and z
inline constexpr int kCells = 96;          ///< a side
inline constexpr float kBridgeX = 2.5f;    ///< the bridge crosses the creek here, along z
inline constexpr float kWaterY = -0.42f;

/// The ground's height; the terrain's triangles lie within a few centimetres of it.
float groundY(float x, float z);
/// The creek's middle at x.
float creekZ(float x);
/// How far from the creek's middle, metres.
float creekDistance(float x, float z);

/// Meshes of trees: full for those near the clearing, spare for those behind.
struct Trees {
  std::vector<std::int32_t> full, spare;
};
Trees makeTrees(LevelBuilder& level, const Materials& m);

/// Where a trunk stands or would hide a camera's view.
struct Place {
  glm::vec2 at;
  float radius;
};
void addTerrain(LevelBuilder& level, const Materials& m);
/// Returns where trees stand.
std::vector<Place> addTrees(LevelBuilder& level, const Materials& m);
void addUndergrowth(LevelBuilder& level, const Materials& m, const std::vector<Place>& trees);
void addRocks(LevelBuilder& level, const Materials& m);
void addFallenTrunk(LevelBuilder& level, const Materials& m);
void addBridge(LevelBuilder& level, const Materials& m);
/// A leafy bough that sways: the moving caster.
void addBough(LevelBuilder& level, const Materials& m);

}  // namespace tyndall::levels::forest
