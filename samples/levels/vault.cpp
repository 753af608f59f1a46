#include "cellar_textures.hpp"
#include "forest_textures.hpp"
#include "hall_textures.hpp"
#include "levels/levels.hpp"
#include "vault_parts.hpp"

namespace tyndall::levels {
namespace {

using namespace vault;

constexpr float kFar = 60.0f;  // metres: nothing of the closed room is farther away than 18
constexpr glm::vec4 kWhite{1};
/// The lamps put some 350 lumen into 360 square metres of sooty stone, which gives back a seventh: 0.16 lux from all
/// around, over pi.
constexpr glm::vec3 kBounced{0.050f, 0.046f, 0.044f};

Materials addMaterials(LevelBuilder& level, std::int32_t rose) {
  Materials m{};
  m.rubble = {level.material("rubble", cellar::rubble(), kWhite, kBounced), cellar::kRubbleTile};
  m.brick = {level.material("brick", cellar::brick(), kWhite, kBounced), cellar::kBrickTile};
  m.paving = {level.material("paving", cellar::paving(), kWhite, kBounced), cellar::kPavingTile};
  m.dressed = {level.material("dressed stone", hall::dressed(), kWhite, kBounced), hall::kPillarTile};
  m.planks = {level.material("planks", hall::planks(), kWhite, kBounced), hall::kWoodTile};
  m.timber = {level.material("timber", hall::timber(), kWhite, kBounced), hall::kWoodTile};
  m.rock = {level.material("fallen stone", forest::rock(), {0.9f, 0.86f, 0.8f, 1}, kBounced), forest::kRockTile};
  m.rust = {level.material("rusty iron", cellar::rust(), kWhite, kBounced), cellar::kRustTile};
  m.rustyBars = {m.rust.material, 0.3f};
  m.iron = level.plain("iron", {0.16f, 0.155f, 0.15f}, 0.55f, 0.6f);
  m.brass = level.plain("brass", {0.78f, 0.57f, 0.26f}, 0.35f, 1.0f);
  m.wax = level.plain("wax", {0.82f, 0.75f, 0.58f}, 0.5f);
  m.flame = level.glowing("flame", {1, 0.8f, 0.4f, 1}, {9.0f, 4.6f, 1.4f}, 0.6f);
  m.bulb = level.glowing("bulb", {1, 1, 1, 1}, {30.0f, 27.0f, 22.0f}, 0.6f);
  m.rose = level.pane("rose window", rose, glm::vec3(2.2f));
  return m;
}

void addCameras(LevelBuilder& level) {
  level.camera("0 crypt, both shafts across", {3.3f, 1.65f, 6.1f}, {-2.6f, 2.05f, -3.2f}, 60, kFar);
  level.camera("1 towards the grating", {-2.4f, 1.5f, 1.9f}, {0.3f, 4.1f, 1.85f}, 75, kFar);
  level.camera("2 within the window's light", {3.1f, 2.1f, -1.7f}, {-4.5f, 0.75f, -1.75f}, 65, kFar);
  const std::int32_t tour = level.camera("3 tour", {0, 2, 5}, {0, 2, 0}, 62, kFar);
  level.animateTour(tour,
                    {{{0.6f, 1.7f, 5.6f}, {-0.5f, 2.3f, -2.0f}},
                     {{2.3f, 2.0f, 1.9f}, {-2.0f, 2.2f, -1.4f}},
                     {{2.0f, 2.2f, -2.0f}, {-3.0f, 1.6f, -2.2f}},
                     {{-0.6f, 2.1f, -4.9f}, {1.6f, 2.3f, 0.0f}},
                     {{-1.6f, 2.4f, -1.6f}, {3.0f, 2.4f, -1.2f}},
                     {{0.9f, 2.2f, 0.5f}, {-1.4f, 2.6f, 1.4f}}},
                    24.0f);
}

}  // namespace

scene::Scene makeVault() {
  LevelBuilder level("vault");
  const std::int32_t rose = level.texture(cellar::roseWindow(), scene::Wrap::kClampToEdge);
  level.spot("lamp in the well", kWellLamp, kWellAim, {1.0f, 0.93f, 0.80f}, 1100.0f, 14.5f, kWellCone, 20.0f);
  level.spot("lamp behind the rose window", kWindowLamp, {kHalfWidth, kWindowY, kWindowZ}, {1.0f, 0.95f, 0.86f},
             8000.0f, kWindowCone - 0.5f, kWindowCone, 30.0f, rose);
  addCameras(level);
  const Materials m = addMaterials(level, rose);
  addShell(level, m);
  addStone(level, m);
  addGrating(level, m);
  addThings(level, m);
  return level.take();
}

}  // namespace tyndall::levels
