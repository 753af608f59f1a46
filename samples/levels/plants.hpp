// Grass, ferns and bushes, and the material that everything green has. Grass is the left half of the texture that
// forest_textures paints for them, a fern's frond the right half.
#pragma once

#include "props.hpp"
#include "random.hpp"

namespace tyndall::levels {

/// Cut-out (MASK), seen from both sides.
std::int32_t foliage(LevelBuilder& level, const std::string& name, std::int32_t texture, const glm::vec3& tint);

/// Three crossed cards on ground that slopes like `normal`; `uvMax`: the part of the image from its upper left corner.
void grassTuft(MeshBuilder& b, Random& random, const glm::vec3& at, const glm::vec3& normal, float size,
               const glm::vec2& uvMax = {0.5f, 1.0f});
/// Fronds in a funnel, each bent once.
void fern(MeshBuilder& b, Random& random, const glm::vec3& at, float size);
std::int32_t bushMesh(LevelBuilder& level, const Coat& bark, std::int32_t leafCards, int seed);

}  // namespace tyndall::levels
