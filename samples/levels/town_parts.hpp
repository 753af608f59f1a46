// The parts of the street at night; town.cpp puts them together.
#pragma once

#include "level_builder.hpp"
#include "levels/town_plan.hpp"
#include "props.hpp"
#include "random.hpp"

namespace tyndall::levels::town {

struct Materials {
  Coat cobbles, plaster, ochre, rose, rubble, brick, dressed, planks, timber, shutter, tiles, rust, stripes, cloth;
  std::int32_t iron, brass, darkGlass, litRoom, bulb, lampGlass, neon, leaded, paned;
};
struct Cookies {
  std::int32_t leaded, paned;  ///< textures
};

/// Where a thing on a house's face is built: s along the face, y up, z out to the street.
/// `side` -1 or +1: left or right of one who looks to the gate; `forward`: metres by which the face stands out.
glm::mat4 facing(float side, float z, float forward = 0);

void addHouses(LevelBuilder& level, const Materials& m, const Cookies& cookies);  ///< with the lights in their rooms
void addRoofs(LevelBuilder& level, const Materials& m);
void addGate(LevelBuilder& level, const Materials& m);  ///< the tower over the street's end
void addBalconies(LevelBuilder& level, const Materials& m);
void addAwnings(LevelBuilder& level, const Materials& m);
void addStreet(LevelBuilder& level, const Materials& m);  ///< cobbles, gutter, kerbs, bins, crates, the cart
void addLamps(LevelBuilder& level, const Materials& m);   ///< lamps on brackets and the lantern over the street
void addSigns(LevelBuilder& level, const Materials& m);   ///< and what hangs across: ropes, washing

/// One house of the row: where it stands and how high it is.
struct House {
  float side, z;     ///< z of its middle
  int bays, floors;  ///< above the ground floor
  float forward;
  int coat;  ///< 0 plaster, 1 ochre, 2 rose, 3 brick
  float halfWidth() const { return 0.5f * kBay * static_cast<float>(bays); }
  float top() const { return kGround + kStorey * static_cast<float>(floors); }
};
inline constexpr House kHouses[] = {
    {-1, 10.75f, 2, 2, 0.0f, 3},   {-1, 4.0f, 3, 2, 0.2f, 0},   {-1, -4.1f, 3, 1, -0.1f, 1},
    {-1, -10.85f, 2, 3, 0.15f, 2}, {-1, -17.6f, 3, 2, 0.0f, 0}, {1, 9.4f, 3, 2, 0.1f, 1},
    {1, 2.65f, 2, 3, -0.1f, 2},    {1, -4.1f, 3, 2, 0.2f, 3},   {1, -12.2f, 3, 1, 0.0f, 0},
    {1, -18.95f, 2, 2, 0.2f, 1},   {-1, 17.5f, 3, 2, 0.1f, 2},  {1, 17.5f, 3, 3, 0.0f, 0}};

}  // namespace tyndall::levels::town
