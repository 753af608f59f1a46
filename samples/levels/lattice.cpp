#include "cellar_textures.hpp"
#include "hall_textures.hpp"
#include "lattice_parts.hpp"
#include "lattice_textures.hpp"
#include "levels/levels.hpp"

namespace tyndall::levels {
namespace {

using namespace lattice;

constexpr float kFar = 90.0f;  // metres: across the yard beyond the fence
constexpr glm::vec4 kWhite{1};

Materials addMaterials(LevelBuilder& level) {
  Materials m{};
  m.concrete = {level.material("concrete", concrete()), kConcreteTile};
  m.sheet = {level.material("corrugated sheet", sheet()), kSheetTile};
  m.roof = m.sheet;
  m.rust = {level.material("rusty steel", cellar::rust()), cellar::kRustTile};
  m.planks = {level.material("planks", hall::planks()), hall::kWoodTile};
  m.timber = {level.material("timber", hall::timber()), hall::kWoodTile};
  // Without mips: their averages fall below the cut-off, and a distant fence would vanish with its shadow.
  m.chain = {level.cutout("chain link", level.texture(chainLink(), scene::Wrap::kRepeat, false), {1, 1, 1}, 0.5f), 1};
  m.iron = level.plain("iron", {0.10f, 0.10f, 0.10f}, 0.5f, 0.6f);
  m.galvanised = level.plain("galvanised wire", {0.42f, 0.43f, 0.43f}, 0.5f, 0.5f);
  m.yellow = level.plain("yellow paint", {0.60f, 0.38f, 0.04f}, 0.55f);
  m.bulb = level.glowing("bulb", {0.9f, 0.95f, 1, 1}, {30.0f, 36.0f, 40.0f}, 0.4f, scene::AlphaMode::kBlend);
  m.glass = level.glowing("lens", {1, 0.95f, 0.85f, 1}, {28.0f, 24.0f, 18.0f}, 0.4f, scene::AlphaMode::kBlend);
  return m;
}

void addCameras(LevelBuilder& level) {
  level.camera("0 through the fence to the sun", {5.9f, 1.5f, 4.9f}, {3.0f, 3.2f, -12.0f}, 62, kFar);
  level.camera("1 along the fence", {1.05f, 1.6f, 5.6f}, {1.15f, 1.9f, -6.0f}, 64, kFar);
  level.camera("2 up in the tower", {-4.25f, 0.7f, -3.55f}, {-4.75f, 5.0f, -5.1f}, 76, kFar);
  const std::int32_t tour = level.camera("3 tour", {0, 2, 8}, {0, 2, 0}, 62, kFar);
  level.animateTour(tour,
                    {{{-3.6f, 2.3f, 9.6f}, {-0.6f, 3.0f, -8.0f}},
                     {{-4.9f, 2.1f, 4.4f}, {0.2f, 2.4f, -5.0f}},
                     {{-3.4f, 1.7f, 0.6f}, {-2.0f, 3.4f, -9.0f}},
                     {{0.8f, 1.9f, -0.6f}, {0.2f, 3.6f, -12.0f}},
                     {{1.0f, 2.6f, 5.4f}, {2.2f, 2.4f, -4.0f}},
                     {{-0.4f, 2.6f, 9.0f}, {1.0f, 3.0f, -8.0f}}},
                    24.0f);
}

}  // namespace

scene::Scene makeLattice() {
  LevelBuilder level("lattice");
  const float elevation = glm::radians(kSunElevation), azimuth = glm::radians(kSunAzimuth);
  level.sun({glm::cos(elevation) * glm::sin(azimuth), glm::sin(elevation), -glm::cos(elevation) * glm::cos(azimuth)},
            {1.0f, 0.76f, 0.48f}, 4.5f);
  addCameras(level);
  const Materials m = addMaterials(level);
  addShed(level, m);
  addFans(level, m);
  addGirders(level, m);
  addFences(level, m);
  addTower(level, m);
  addStairs(level, m);
  addGoods(level, m);
  return level.take();
}

}  // namespace tyndall::levels
