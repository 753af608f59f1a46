// The dale's parts; terrain.cpp puts them together.
#pragma once

#include "level_builder.hpp"
#include "levels/terrain_plan.hpp"
#include "random.hpp"

namespace tyndall::levels::terrain {

struct Materials {
  std::int32_t ground, rock, ashlar, dressed, plaster, planks, bark, canvas, leaves, needles, grass;
};

inline constexpr float kHeathTile = 4.0f;
/// Where the cameras stand, x and z: the vista, away from the sun, in the valley.
inline constexpr glm::vec2 kEyes[] = {{-10.0f, 36.0f}, {22.5f, 3.5f}, {4.5f, -3.0f}};

glm::vec3 onGround(float x, float z);
glm::vec3 groundNormal(float x, float z);
/// The middle of the trodden track that follows the valley, and how far from it, metres.
float trackX(float z);
float trackDistance(float x, float z);
/// Towards the sun.
glm::vec3 toSun();

/// Painted for the dale: ground without a hue of its own (its vertices bring the colours), and a tuft of dry grass.
Surface heath();
scene::Image dryGrass();

void addGround(LevelBuilder& level, const Materials& m);
/// Trees, bushes, grass and rocks.
void addCover(LevelBuilder& level, const Materials& m);
/// Two tiers of arches, broken in places, that fill the ridge's gap.
void addAqueduct(LevelBuilder& level, const Materials& m);
/// A windmill on the ridge: its sails are the moving caster.
void addWindmill(LevelBuilder& level, const Materials& m);

}  // namespace tyndall::levels::terrain
