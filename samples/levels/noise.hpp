// Noise that repeats, so that textures tile. Coordinates are cells of the lattice; `period` is in cells.
#pragma once

#include <cstdint>

#include <glm/glm.hpp>

namespace tyndall::levels {

/// A number in [0, 1) for a lattice cell.
float cellHash(int x, int y, std::uint32_t seed);

/// Smooth value noise in [0, 1].
float valueNoise(glm::vec2 p, glm::ivec2 period, std::uint32_t seed);

/// Octaves of value noise, each twice as fine and half as strong; in [0, 1].
float fbm(glm::vec2 p, glm::ivec2 period, int octaves, std::uint32_t seed);

/// Distances to the nearest and second nearest feature point, and the nearest one's cell hash (Worley 1996,
/// "A Cellular Texture Basis Function").
struct Cellular {
  float nearest, second, id;
};
Cellular cellular(glm::vec2 p, glm::ivec2 period, std::uint32_t seed);

}  // namespace tyndall::levels
