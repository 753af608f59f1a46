#include "forest_parts.hpp"
#include "forest_textures.hpp"
#include "levels/levels.hpp"
#include "plants.hpp"

namespace tyndall::levels {
namespace {

using namespace forest;

constexpr float kFar = 160.0f;                               // metres: across the terrain with room above the trees
constexpr float kSunElevation = 27.0f, kSunAzimuth = 37.0f;  // degrees; azimuth from +x towards -z

Materials addMaterials(LevelBuilder& level) {
  Materials m{};
  m.litter = level.material("forest floor", litter());
  m.bark = level.material("bark", roughBark());
  m.birch = level.material("birch bark", birchBark());
  m.rock = level.material("rock", rock());
  m.planks = level.material("weathered planks", planks());
  // Cut-outs do not tile: the edge's filtering must not reach round to the other side.
  const std::int32_t twig = level.texture(leafyTwig(), scene::Wrap::kClampToEdge);
  m.leaves = foliage(level, "leaves", twig, {1, 1, 1});
  m.paleLeaves = foliage(level, "birch leaves", twig, {1.0f, 0.95f, 0.55f});
  m.needles = foliage(level, "needles", level.texture(spruceFrond(), scene::Wrap::kClampToEdge), {1, 1, 1});
  m.undergrowth = foliage(level, "undergrowth", level.texture(undergrowth(), scene::Wrap::kClampToEdge), {1, 1, 1});
  m.water = level.plain("water", {0.018f, 0.026f, 0.022f}, 0.08f);
  return m;
}

void addCameras(LevelBuilder& level) {
  const auto above = [](float x, float z, float height) { return glm::vec3(x, groundY(x, z) + height, z); };
  level.camera("0 clearing, shafts across", above(-2.5f, 11.0f, 1.75f), {-9.0f, 3.0f, -6.9f}, 60, kFar);
  level.camera("1 towards the sun", above(-6.0f, 5.5f, 1.6f), {8.0f, 6.0f, -5.0f}, 65, kFar);
  level.camera("2 away from the sun", above(8.5f, -6.5f, 1.7f), {-8.0f, 1.0f, 5.6f}, 65, kFar);
  const std::int32_t tour = level.camera("3 tour", {0, 2, 8}, {0, 2, 0}, 60, kFar);
  level.animateTour(tour,
                    {{{-3.0f, 2.0f, 10.0f}, {1.0f, 2.6f, -4.0f}},
                     {{2.5f, 2.3f, 4.6f}, {2.0f, 2.8f, -8.0f}},
                     {{2.6f, 1.9f, -2.5f}, {9.0f, 4.5f, -7.5f}},
                     {{-2.0f, 2.6f, -6.5f}, {6.0f, 4.5f, -8.0f}},
                     {{-6.0f, 2.4f, -1.4f}, {2.0f, 2.6f, 0.0f}},
                     {{-5.4f, 2.2f, 6.6f}, {0.0f, 2.4f, 0.5f}}},
                    24.0f);
}

}  // namespace

scene::Scene makeForest() {
  LevelBuilder level("forest");
  const float elevation = glm::radians(kSunElevation), azimuth = glm::radians(kSunAzimuth);
  const glm::vec3 toSun{glm::cos(elevation) * glm::cos(azimuth), glm::sin(elevation),
                        -glm::cos(elevation) * glm::sin(azimuth)};
  level.sun(toSun, {1.0f, 0.83f, 0.60f}, 10.0f);
  addCameras(level);
  const Materials m = addMaterials(level);
  addTerrain(level, m);
  const std::vector<Place> trees = addTrees(level, m);
  addUndergrowth(level, m, trees);
  addRocks(level, m);
  addFallenTrunk(level, m);
  addBridge(level, m);
  addBough(level, m);
  return level.take();
}

}  // namespace tyndall::levels
