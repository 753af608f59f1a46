// The sample levels as plain scenes, made by code: the same bytes on every run of the same build.
// What each one stresses, and its cameras: README.md of this folder.
#pragma once

#include "scene/scene.hpp"

namespace tyndall::levels {

/// A great hall, 40 m x 14 m x 12 m, closed but for its windows and one door, in slanting sunlight.
scene::Scene makeHall();

/// A clearing with a creek and a footbridge in a forest of alpha-cut leaves, under a low sun.
scene::Scene makeForest();

/// An abandoned crypt, 14 m x 9 m x 5 m: a spot light through a grating and a fan, another through a rose window.
scene::Scene makeVault();

/// A store room, 15 m x 12 m x 5 m: a point light in a swinging cage, another in a stove.
scene::Scene makeCage();

/// A dale at dusk, 400 m x 400 m: a low sun behind a ridge, an aqueduct in its gap, a windmill.
scene::Scene makeTerrain();

/// A bell tower before a low sun, 5.4 m x 5.4 m x 28 m, openwork and scaffolding, on a village's square.
scene::Scene makeTower();

/// A street at night, 45 m long: lamps, lit windows and the moon behind a gate tower.
scene::Scene makeTown();

/// A shed full of lattice, 24 m x 18 m x 7 m: chain link, girders and fans before a low sun, and two work lamps.
scene::Scene makeLattice();

/// Every level by its file's name.
struct Sample {
  const char* name;
  scene::Scene (*make)();
};
inline constexpr Sample kSamples[] = {{"hall", makeHall}, {"forest", makeForest},   {"vault", makeVault},
                                      {"cage", makeCage}, {"terrain", makeTerrain}, {"tower", makeTower},
                                      {"town", makeTown}, {"lattice", makeLattice}};

/// How many triangles a frame that culls nothing draws: every mesh counted once per node that uses it.
std::size_t instancedTriangles(const scene::Scene& scene);

}  // namespace tyndall::levels
