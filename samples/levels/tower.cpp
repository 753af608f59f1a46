#include "cellar_textures.hpp"
#include "forest_textures.hpp"
#include "hall_textures.hpp"
#include "levels/levels.hpp"
#include "plants.hpp"
#include "tower_parts.hpp"

namespace tyndall::levels {
namespace {

using namespace tower;

constexpr float kFar = 160.0f;  // metres: across the village and beyond what the mist shows

glm::vec3 toSun() {
  const float elevation = glm::radians(kSunElevation), azimuth = glm::radians(kSunAzimuth);
  return {glm::cos(elevation) * glm::cos(azimuth), glm::sin(elevation), -glm::cos(elevation) * glm::sin(azimuth)};
}

Materials addMaterials(LevelBuilder& level) {
  Materials m{};
  m.ashlar = level.material("ashlar", hall::ashlar(), {0.95f, 0.90f, 0.82f, 1});
  m.dressed = level.material("dressed stone", hall::dressed(), {0.85f, 0.80f, 0.72f, 1});
  m.slates = level.material("slates", slates());
  m.plaster = level.material("limewash", plaster());
  m.timber = level.material("timber", hall::timber(), {0.6f, 0.55f, 0.5f, 1});
  m.planks = level.material("weathered planks", forest::planks());
  m.paving = level.material("paving", cellar::paving());
  m.grass = level.material("ground", forest::litter());
  m.bark = level.material("bark", forest::roughBark());
  // Cut-outs do not tile: the edge's filtering must not reach round to the other side.
  const auto cutout = [&](scene::Image image) { return level.texture(std::move(image), scene::Wrap::kClampToEdge); };
  m.leaves = foliage(level, "leaves", cutout(forest::leafyTwig()), {1.0f, 0.92f, 0.70f});
  m.tufts = foliage(level, "grass", cutout(forest::undergrowth()), {1, 1, 1});
  m.iron = level.plain("iron", {0.06f, 0.06f, 0.065f}, 0.5f, 0.5f);
  m.bronze = level.plain("bronze", {0.45f, 0.33f, 0.18f}, 0.4f, 1.0f);
  m.gold = level.plain("gilding", {0.85f, 0.62f, 0.25f}, 0.35f, 1.0f);
  m.canvas = level.plain("canvas", {0.55f, 0.50f, 0.42f}, 0.95f);
  scene::Material glow;
  glow.name = "lit windows";
  glow.baseColor = {1, 0.8f, 0.5f, 1};
  glow.metallic = 0;
  glow.emissive = {1.9f, 1.0f, 0.36f};
  m.glow = level.material(glow);
  return m;
}

/// From where the sun stands behind `point`, `height` above the ground.
glm::vec3 below(const glm::vec3& point, float height) { return point - toSun() * ((point.y - height) / toSun().y); }

void addCameras(LevelBuilder& level) {
  level.camera("0 the sun just behind the tower", below({-1.3f, 8.6f, 0}, 1.7f), {-0.9f, 7.4f, 0}, 68, kFar);
  level.camera("1 the sun in the belfry", below({0.5f, 12.6f, 0}, 1.7f), {0.0f, 8.6f, 0}, 58, kFar);
  level.camera("2 beside it, from below", {10.2f, 1.7f, 6.2f}, {-1.6f, 9.4f, -2.6f}, 70, kFar);
  const std::int32_t tour = level.camera("3 tour, the sun passes behind the tower", {0, 2, 8}, {0, 2, 0}, 60, kFar);
  level.animateTour(tour,
                    {{{-6.5f, 2.2f, 22.0f}, {-1.0f, 8.0f, 0}},
                     {{-2.6f, 2.0f, 24.0f}, {0, 8.5f, 0}},
                     {{1.5f, 2.4f, 22.0f}, {0.5f, 8.5f, 0}},
                     {{6.0f, 3.0f, 25.0f}, {1.0f, 8.0f, 0}},
                     {{2.0f, 5.0f, 31.0f}, {0, 9.0f, 0}},
                     {{-4.5f, 3.4f, 28.0f}, {-0.5f, 8.5f, 0}}},
                    24.0f);
}

}  // namespace

scene::Scene makeTower() {
  LevelBuilder level("tower");
  level.sun(toSun(), {1.0f, 0.66f, 0.37f}, 5.0f);
  addCameras(level);
  const Materials m = addMaterials(level);
  addTower(level, m);
  addBelfry(level, m);
  addScaffolding(level, m);
  addChurch(level, m);
  addHouses(level, m);
  addSquare(level, m);
  return level.take();
}

}  // namespace tyndall::levels
