#include "cage_parts.hpp"
#include "cellar_textures.hpp"
#include "hall_textures.hpp"
#include "levels/levels.hpp"

namespace tyndall::levels {
namespace {

using namespace cage;

constexpr float kFar = 60.0f;  // metres: nothing of the closed room is farther away than 20
constexpr glm::vec4 kWhite{1};
constexpr glm::vec3 kBounced{0.020f, 0.015f, 0.011f};  ///< the lamp's light, come back from brick and wood

Materials addMaterials(LevelBuilder& level) {
  Materials m{};
  m.brick = {level.material("brick", cellar::brick(), kWhite, kBounced), cellar::kBrickTile};
  m.paving = {level.material("paving", cellar::paving(), kWhite, kBounced), cellar::kPavingTile};
  m.dressed = {level.material("dressed stone", hall::dressed(), kWhite, kBounced), hall::kPillarTile};
  m.planks = {level.material("planks", hall::planks(), kWhite, kBounced), hall::kWoodTile};
  m.timber = {level.material("timber", hall::timber(), kWhite, kBounced), hall::kWoodTile};
  m.rust = {level.material("rusty iron", cellar::rust(), kWhite, kBounced), cellar::kRustTile};
  m.rustyBars = {m.rust.material, 0.3f};
  m.sack = {level.material("sackcloth", cellar::sackcloth(), kWhite, kBounced), cellar::kSackTile};
  m.rope = {m.sack.material, 0.15f};
  m.iron = level.plain("iron", {0.16f, 0.155f, 0.15f}, 0.55f, 0.6f);
  m.brass = level.plain("brass", {0.78f, 0.57f, 0.26f}, 0.35f, 1.0f);
  m.bulb = level.glowing("bulb", {1, 0.9f, 0.7f, 1}, {60.0f, 46.0f, 26.0f}, 0.4f, scene::AlphaMode::kBlend);
  m.glass = level.glowing("glass", {1, 0.9f, 0.75f, 0.22f}, {6.0f, 4.4f, 2.4f}, 0.4f, scene::AlphaMode::kBlend);
  m.embers = level.glowing("embers", {0.2f, 0.05f, 0.02f, 1}, {7.0f, 1.5f, 0.25f}, 0.4f);
  return m;
}

void addCameras(LevelBuilder& level) {
  level.camera("0 store room, shadows across", {0.9f, 1.6f, 2.5f}, {-4.6f, 1.75f, -4.0f}, 60, kFar);
  level.camera("1 towards the lamp", {-1.4f, 1.5f, 6.6f}, {0.35f, 2.7f, 0.2f}, 62, kFar);
  level.camera("2 close to the cage", {1.25f, 2.75f, 1.55f}, {-0.6f, 3.0f, -1.2f}, 70, kFar);
  const std::int32_t tour = level.camera("3 tour", {0, 2, 5}, {0, 2, 0}, 62, kFar);
  level.animateTour(tour,
                    {{{0.2f, 1.8f, 5.6f}, {0.4f, 2.6f, -1.0f}},
                     {{1.9f, 2.1f, 2.2f}, {-1.2f, 2.6f, -2.4f}},
                     {{2.2f, 1.9f, -1.4f}, {3.4f, 1.5f, -6.0f}},
                     {{0.6f, 2.0f, -3.2f}, {0.2f, 2.6f, 1.5f}},
                     {{-2.0f, 2.1f, -1.5f}, {1.0f, 2.6f, 1.2f}},
                     {{-1.9f, 2.0f, 2.6f}, {-3.4f, 2.0f, -3.0f}}},
                    24.0f);
}

}  // namespace

scene::Scene makeCage() {
  LevelBuilder level("cage");
  addCameras(level);
  const Materials m = addMaterials(level);
  addLamp(level, m);
  addRoom(level, m);
  addLoft(level, m);
  addStove(level, m);
  addGoods(level, m);
  return level.take();
}

}  // namespace tyndall::levels
