// What stands and lies on the ground: trees, bushes, grass, rocks.
#include <glm/gtc/constants.hpp>

#include "forest_textures.hpp"
#include "noise.hpp"
#include "plants.hpp"
#include "shapes.hpp"
#include "terrain_parts.hpp"
#include "trees.hpp"

namespace tyndall::levels::terrain {
namespace {

void addTrees(LevelBuilder& level, const Materials& m) {
  const Coat bark{m.bark, forest::kBarkTile};
  const std::int32_t kinds[] = {broadTree(level, "oak", kOak, 14, bark, m.leaves),
                                spruceTree(level, "spruce", kSpruce, 12, bark, m.needles),
                                spruceTree(level, "spruce from afar", kDistantSpruce, 18, bark, m.needles),
                                broadTree(level, "beech from afar", kDistantBeech, 17, bark, m.leaves)};
  Random random(4321);
  const auto put = [&](float x, float z, int kind, float scale) {
    level.node("tree", kinds[kind], onGround(x, z) - glm::vec3(0, 0.15f, 0), random.range(0, 6.28f), scale);
  };
  // On the ridge's crest, before the sun, and where they frame a view.
  const std::tuple<float, float, int, float> chosen[] = {
      {24.0f, -55.0f, 1, 0.75f}, {27.0f, -58.0f, 1, 0.6f}, {22.0f, -62.0f, 1, 0.7f}, {33.0f, 42.0f, 1, 0.7f},
      {29.0f, 46.0f, 1, 0.85f},  {31.0f, 52.0f, 1, 0.7f},  {12.0f, 21.0f, 0, 0.8f},  {-20.0f, -24.0f, 0, 0.9f},
      {10.0f, -26.0f, 1, 0.6f},  {-26.0f, 22.0f, 0, 0.8f}};
  for (const auto& [x, z, kind, scale] : chosen) put(x, z, kind, scale);
  for (int i = 0, count = 0; i < 900 && count < 44; ++i) {
    const float x = random.range(-110.0f, 95.0f), z = random.range(-120.0f, 120.0f);
    const bool inTheGap = glm::abs(z) < 36.0f && x > -44.0f && x < 60.0f;
    if (inTheGap || valueNoise(glm::vec2(x, z) * 0.05f + 300.0f, {4096, 4096}, 7) < 0.52f) continue;
    if (glm::length(glm::vec2(x - 20.0f, z + 41.0f)) < 9.0f || glm::length(glm::vec2(x + 20.0f, z - 40.0f)) < 12.0f)
      continue;
    put(x, z, x > 15.0f ? 2 : 2 + random.below(2), random.range(0.55f, 0.95f));
    ++count;
  }
}

void addGrass(LevelBuilder& level, const Materials& m) {
  Random random(99);
  MeshBuilder quarter[4];  // so that a view culls what it does not see
  for (int i = 0; i < 5200; ++i) {
    const float x = random.range(-48.0f, 26.0f), z = random.range(-48.0f, 56.0f);
    if (valueNoise(glm::vec2(x, z) * 0.16f + 300.0f, {4096, 4096}, 5) < 0.5f) continue;
    if (glm::abs(x + 7.0f - 7.0f * glm::sin(0.045f * z + 0.4f) - 2.0f * glm::sin(0.13f * z)) < 1.5f)
      continue;  // the track
    MeshBuilder& b = quarter[(x > -11 ? 1 : 0) + (z > 4 ? 2 : 0)];
    const float dry = random.unit();
    b.color = glm::vec4(glm::mix(glm::vec3(0.75f, 0.85f, 0.6f), glm::vec3(1.0f, 0.78f, 0.5f), dry), 1);
    grassTuft(b, random, onGround(x, z), groundNormal(x, z), random.range(0.35f, 0.75f));
  }
  for (const MeshBuilder& b : quarter) level.single("undergrowth", {b.finish(m.grass)});
  const Coat bark{m.bark, forest::kBarkTile};
  const std::int32_t bush = bushMesh(level, bark, m.leaves, 33);
  for (int i = 0; i < 46; ++i) {
    const float x = random.range(-50.0f, 24.0f), z = random.range(-50.0f, 50.0f);
    if (glm::abs(x + 7.0f) < 9.0f) continue;
    level.node("bush", bush, onGround(x, z), random.range(0, 6), random.range(0.6f, 1.4f));
  }
}

void addRocks(LevelBuilder& level, const Materials& m) {
  const Coat coat{m.rock, forest::kRockTile};
  const std::int32_t rocks[] = {rockMesh(level, coat, 71), rockMesh(level, coat, 72), rockMesh(level, coat, 73)};
  Random random(707);
  const auto put = [&](float x, float z, float scale) {
    level.node("rock", rocks[random.below(3)], onGround(x, z) - glm::vec3(0, 0.25f * scale, 0), random.range(0, 6),
               scale);
  };
  // A tor on the crest, and boulders that rolled down.
  put(26, 38, 3.4f), put(23, 41, 2.6f), put(29, -36, 3.0f), put(25.5f, 40.0f, 2.2f), put(26, -33.5f, 2.0f);
  for (int i = 0; i < 60; ++i) {
    const float z = random.range(-60.0f, 60.0f), x = random.range(-60.0f, 22.0f);
    if (glm::abs(x + 7.0f) < 10.0f) continue;
    put(x, z, random.range(0.25f, 1.3f));
  }
}

}  // namespace

void addCover(LevelBuilder& level, const Materials& m) {
  addTrees(level, m);
  addGrass(level, m);
  addRocks(level, m);
}

}  // namespace tyndall::levels::terrain
