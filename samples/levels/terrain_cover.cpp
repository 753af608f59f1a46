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
      {24.0f, -55.0f, 1, 0.75f}, {27.0f, -58.0f, 1, 0.6f},  {22.0f, -62.0f, 1, 0.7f}, {33.0f, 42.0f, 1, 0.7f},
      {29.0f, 46.0f, 1, 0.85f},  {31.0f, 52.0f, 1, 0.7f},   {12.0f, 21.0f, 0, 0.8f},  {-20.0f, -24.0f, 0, 0.9f},
      {10.0f, -26.0f, 1, 0.6f},  {-26.0f, 22.0f, 0, 0.8f},  {-30.0f, 3.0f, 0, 0.85f}, {-17.0f, -6.0f, 0, 0.55f},
      {-38.0f, -12.0f, 2, 0.8f}, {-41.0f, -8.0f, 2, 0.65f}, {-33.0f, 14.0f, 2, 0.7f}, {-12.0f, 25.0f, 0, 0.75f}};
  for (const auto& [x, z, kind, scale] : chosen) put(x, z, kind, scale);
  for (int i = 0, count = 0; i < 900 && count < 28; ++i) {
    const float x = random.range(-110.0f, 95.0f), z = random.range(-120.0f, 120.0f);
    const bool inTheGap = glm::abs(z) < 36.0f && x > -44.0f && x < 60.0f;
    if (inTheGap || valueNoise(glm::vec2(x, z) * 0.05f + 300.0f, {4096, 4096}, 7) < 0.52f) continue;
    if (glm::length(glm::vec2(x - 20.0f, z + 41.0f)) < 9.0f || glm::length(glm::vec2(x + 20.0f, z - 40.0f)) < 12.0f)
      continue;
    put(x, z, x > 15.0f ? 2 : 2 + random.below(2), random.range(0.55f, 0.95f));
    ++count;
  }
}

/// Where grass may grow, and how dry it is: none on the track.
bool grows(float x, float z, float least) {
  return trackDistance(x, z) > 1.5f && valueNoise(glm::vec2(x, z) * 0.16f + 300.0f, {4096, 4096}, 5) > least;
}

void addGrass(LevelBuilder& level, const Materials& m) {
  Random random(99);
  MeshBuilder quarter[4];  // so that a view culls what it does not see
  const auto put = [&](float x, float z, float size) {
    MeshBuilder& b = quarter[(x > -11 ? 1 : 0) + (z > 4 ? 2 : 0)];
    const float dry = random.unit();
    b.color = glm::vec4(glm::mix(glm::vec3(0.62f, 0.74f, 0.42f), glm::vec3(1.0f, 0.92f, 0.8f), dry), 1);
    grassTuft(b, random, onGround(x, z), groundNormal(x, z), size, {1, 1});
  };
  // Dense where a camera stands, sparse elsewhere.
  for (const glm::vec2& eye : kEyes) {
    for (int i = 0; i < 1600; ++i) {
      const float far = 1.0f + 18.0f * random.unit(), angle = random.range(0, 2.0f * glm::pi<float>());
      const float x = eye.x + far * glm::cos(angle), z = eye.y + far * glm::sin(angle);
      if (grows(x, z, 0.40f)) put(x, z, random.range(0.28f, 0.55f));
    }
  }
  for (int i = 0; i < 2400; ++i) {
    const float x = random.range(-48.0f, 26.0f), z = random.range(-48.0f, 56.0f);
    if (grows(x, z, 0.52f)) put(x, z, random.range(0.45f, 0.8f));
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

/// Posts and rails beside the track; some rails have fallen.
void addFence(LevelBuilder& level, const Materials& m) {
  MeshBuilder wood;
  Random random(606);
  const auto at = [](float z) { return onGround(trackX(z) - 2.3f, z); };
  for (float z = -40.0f; z < 52.0f; z += 2.6f) {
    const glm::vec3 a = at(z), c = at(z + 2.6f), lean(random.range(-0.07f, 0.07f), 0, random.range(-0.07f, 0.07f));
    wood.uvOffset = {random.unit() * 2, random.unit() * 2};
    wood.color = glm::vec4(glm::vec3(random.range(0.7f, 1.0f)), 1);
    beam(wood, a - glm::vec3(0, 0.4f, 0), a + glm::vec3(0, 1.15f, 0) + lean, 0.13f, 0.13f, 0.02f, {0, 0, 1});
    for (const float y : {0.5f, 0.95f}) {
      const float chance = random.unit();
      if (chance < 0.18f) continue;
      const float drop = chance < 0.3f ? y - 0.12f : random.range(-0.05f, 0.05f);
      beam(wood, a + glm::vec3(0.06f, y, 0), c + glm::vec3(0.06f, y - drop, 0.1f), 0.05f, 0.11f, 0.01f);
    }
  }
  level.single("fence", {wood.finish(m.planks, 2.0f)});
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
  put(-6.5f, 29.5f, 1.0f), put(26, 38, 3.4f), put(23, 41, 2.6f), put(29, -36, 3.0f), put(25.5f, 40.0f, 2.2f),
      put(26, -33.5f, 2.0f);
  for (int i = 0; i < 36; ++i) {
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
  addFence(level, m);
}

}  // namespace tyndall::levels::terrain
