#include "forest_textures.hpp"
#include "hall_textures.hpp"
#include "levels/levels.hpp"
#include "plants.hpp"
#include "terrain_parts.hpp"

namespace tyndall::levels {
namespace terrain {

glm::vec3 toSun() {
  const float elevation = glm::radians(kSunElevation), azimuth = glm::radians(kSunAzimuth);
  return {glm::cos(elevation) * glm::cos(azimuth), glm::sin(elevation), -glm::cos(elevation) * glm::sin(azimuth)};
}

}  // namespace terrain

namespace {

using namespace terrain;

constexpr float kFar = 320.0f;  // metres: the mountains behind the valley; 7e-5 of what lies there comes through

// What the eastern sky adds in the shade: bluer than the analytic sky, whose colour is the sun's.
constexpr glm::vec3 kDusk{0.02f, 0.03f, 0.05f};

Materials addMaterials(LevelBuilder& level) {
  Materials m{};
  m.ground = level.material("heath", heath());
  m.rock = level.material("rock", forest::rock(), glm::vec4(1), kDusk);
  m.ashlar = level.material("ashlar", hall::ashlar(), {0.92f, 0.84f, 0.74f, 1}, kDusk);
  m.dressed = level.material("dressed stone", hall::dressed(), {0.80f, 0.74f, 0.66f, 1}, kDusk);
  m.planks = level.material("weathered planks", forest::planks());
  m.bark = level.material("bark", forest::roughBark());
  m.plaster = level.plain("whitewash", {0.66f, 0.62f, 0.55f}, 0.9f);
  m.canvas = level.plain("canvas", {0.58f, 0.50f, 0.38f}, 0.95f);
  // Cut-outs do not tile: the edge's filtering must not reach round to the other side.
  const auto cutout = [&](scene::Image image) { return level.texture(std::move(image), scene::Wrap::kClampToEdge); };
  m.leaves = foliage(level, "autumn leaves", cutout(forest::leafyTwig()), {1.0f, 0.74f, 0.38f});
  m.needles = foliage(level, "needles", cutout(forest::spruceFrond()), {1, 1, 1});
  m.grass = foliage(level, "grass", cutout(dryGrass()), {1, 1, 1});
  return m;
}

void addCameras(LevelBuilder& level) {
  const auto above = [](float x, float z, float height) { return onGround(x, z) + glm::vec3(0, height, 0); };
  const auto eye = [&](int camera, float height) { return above(kEyes[camera].x, kEyes[camera].y, height); };
  level.camera("0 vista, shafts across", eye(0, 3.0f), {9.0f, 6.4f, -7.0f}, 60, kFar);
  const glm::vec3 high = glm::vec3(kEyes[1].x, 5.6f, kEyes[1].y);  // in the shadow of a pier: beams on all sides
  level.camera("1 away from the sun", high, high - 40.0f * toSun() + glm::vec3(0, 6.5f, 0), 64, kFar);
  level.camera("2 valley, the ridge against the light", eye(2, 2.2f), {21.5f, 8.8f, -32.5f}, 62, kFar);
  const std::int32_t tour = level.camera("3 tour", {0, 2, 8}, {0, 2, 0}, 60, kFar);
  level.animateTour(tour,
                    {{above(-20, 40, 5), {10, 6, 0}},
                     {above(-4, 24, 4), {24, 7, -8}},
                     {above(6, 6, 3.5f), {30, 7, -16}},
                     {above(2, -12, 4), {24, 12, -44}},
                     {above(-10, -16, 4), {-4, 5, 20}},
                     {above(-16, 12, 5), {24, 7, 2}}},
                    24.0f);
}

}  // namespace

scene::Scene makeTerrain() {
  LevelBuilder level("terrain");
  level.sun(toSun(), {1.0f, 0.66f, 0.38f}, 8.5f);
  addCameras(level);
  const Materials m = addMaterials(level);
  addGround(level, m);
  addAqueduct(level, m);
  addWindmill(level, m);
  addCover(level, m);
  return level.take();
}

}  // namespace tyndall::levels
