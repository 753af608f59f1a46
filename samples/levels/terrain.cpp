#include "forest_textures.hpp"
#include "hall_textures.hpp"
#include "levels/levels.hpp"
#include "noise.hpp"
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

/// Grass and gravel without a hue of their own: the ground's vertices bring the colours.
Surface heath() {
  return {512, 512, [](glm::vec2 uv) {
            const float patches = fbm(uv * 5.0f, glm::ivec2(5), 5, 301), fine = fbm(uv * 72.0f, glm::ivec2(72), 3, 302);
            const glm::vec2 bent = uv + 0.02f * glm::vec2(fbm(uv * 9.0f, glm::ivec2(9), 2, 303), patches);
            const float blades = fbm(bent * glm::vec2(110, 40), glm::ivec2(110, 40), 2, 304);
            const Cellular pebble = cellular(uv * 40.0f, glm::ivec2(40), 305);
            const float stone = (1.0f - glm::smoothstep(0.22f, 0.34f, pebble.nearest)) * glm::step(0.78f, pebble.id);
            Texel t;
            t.color =
                glm::vec3(0.50f + 0.34f * (blades - 0.5f) + 0.22f * (fine - 0.5f) + 0.34f * (patches - 0.5f)) + 0.2f;
            t.color = glm::mix(t.color, glm::vec3(0.82f, 0.80f, 0.78f) * (0.7f + 0.4f * fine), 0.7f * stone);
            t.height = 2.4f * patches + 1.6f * blades + 1.0f * fine + 1.2f * stone;
            t.roughness = 0.95f;
            return t;
          }};
}

Materials addMaterials(LevelBuilder& level) {
  Materials m{};
  m.ground = level.material("heath", heath());
  m.rock = level.material("rock", forest::rock());
  m.ashlar = level.material("ashlar", hall::ashlar(), {0.92f, 0.84f, 0.74f, 1});
  m.dressed = level.material("dressed stone", hall::dressed(), {0.80f, 0.74f, 0.66f, 1});
  m.planks = level.material("weathered planks", forest::planks());
  m.bark = level.material("bark", forest::roughBark());
  m.plaster = level.plain("whitewash", {0.66f, 0.62f, 0.55f}, 0.9f);
  m.canvas = level.plain("canvas", {0.58f, 0.50f, 0.38f}, 0.95f);
  // Cut-outs do not tile: the edge's filtering must not reach round to the other side.
  const auto cutout = [&](scene::Image image) { return level.texture(std::move(image), scene::Wrap::kClampToEdge); };
  m.leaves = foliage(level, "autumn leaves", cutout(forest::leafyTwig()), {1.0f, 0.74f, 0.38f});
  m.needles = foliage(level, "needles", cutout(forest::spruceFrond()), {1, 1, 1});
  m.grass = foliage(level, "grass", cutout(forest::undergrowth()), {1.0f, 0.9f, 0.7f});
  return m;
}

void addCameras(LevelBuilder& level) {
  const auto above = [](float x, float z, float height) { return onGround(x, z) + glm::vec3(0, height, 0); };
  level.camera("0 vista, shafts across", above(-14.0f, 36.0f, 3.4f), {12.0f, 6.2f, -6.0f}, 60, kFar);
  const glm::vec3 eye = above(22.5f, 3.5f, 3.2f);
  level.camera("1 away from the sun", eye, eye - 40.0f * toSun() + glm::vec3(0, 3, 0), 66, kFar);
  level.camera("2 valley, the ridge against the light", above(-16.0f, -22.0f, 1.7f), {24.0f, 14.0f, -36.0f}, 62, kFar);
  const std::int32_t tour = level.camera("3 tour", {0, 2, 8}, {0, 2, 0}, 60, kFar);
  level.animateTour(tour,
                    {{above(-20, 40, 5), {10, 6, 0}},
                     {above(-4, 24, 4), {24, 7, -8}},
                     {above(6, 6, 3.5f), {30, 7, -16}},
                     {above(2, -12, 4), {24, 12, -44}},
                     {above(-14, -16, 4), {-4, 5, 20}},
                     {above(-26, 10, 6), {20, 7, 8}}},
                    24.0f);
}

}  // namespace

scene::Scene makeTerrain() {
  LevelBuilder level("terrain");
  level.sun(toSun(), {1.0f, 0.70f, 0.42f}, 10.0f);
  addCameras(level);
  const Materials m = addMaterials(level);
  addGround(level, m);
  addAqueduct(level, m);
  addWindmill(level, m);
  addCover(level, m);
  return level.take();
}

}  // namespace tyndall::levels
