// The square: ground, trees, lamps, railings, and what stands about.
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "cellar_textures.hpp"
#include "forest_textures.hpp"
#include "hall_textures.hpp"
#include "noise.hpp"
#include "plants.hpp"
#include "props.hpp"
#include "shapes.hpp"
#include "tower_parts.hpp"
#include "trees.hpp"

namespace tyndall::levels::tower {
namespace {

constexpr float kHalfSize = 75.0f;
constexpr glm::ivec2 kNoPeriod{4096, 4096};

void addGround(LevelBuilder& level, const Materials& m) {
  MeshBuilder grass, paving;
  const auto at = [](float x, float z, float up) { return glm::vec3(x, groundY(x, z) + up, z); };
  surface(grass, 70, 70, {2 * kHalfSize, 2 * kHalfSize},
          [&](float u, float v) { return at(kHalfSize * (2 * u - 1), kHalfSize * (1 - 2 * v), 0); });
  const glm::vec2 half{13.0f, 21.0f};
  surface(paving, 26, 40, 2.0f * half,
          [&](float u, float v) { return at(half.x * (2 * u - 1), 16.0f + half.y * (1 - 2 * v), 0.05f); });
  level.single("ground", {grass.finish(m.grass, forest::kGroundTile), paving.finish(m.paving, cellar::kPavingTile)});
}

void addTrees(LevelBuilder& level, const Materials& m) {
  const Coat bark{m.bark, forest::kBarkTile};
  const std::int32_t kinds[] = {broadTree(level, "lime", kBeech, 24, bark, m.leaves),
                                broadTree(level, "oak", kOak, 21, bark, m.leaves),
                                broadTree(level, "lime from afar", kDistantBeech, 27, bark, m.leaves)};
  Random random(808);
  const auto put = [&](int kind, float x, float z, float scale) {
    level.node("tree", kinds[kind], {x, groundY(x, z) - 0.1f, z}, random.range(0, 6), scale);
  };
  put(0, 8.2f, -2.5f, 0.92f), put(1, 7.6f, 8.0f, 0.62f), put(0, -9.0f, -9.5f, 0.95f), put(1, 10.5f, -11.0f, 1.05f);
  put(2, -20.0f, -32.0f, 1.1f), put(2, 19.0f, -34.0f, 1.1f), put(2, -33.0f, -12.0f, 1.0f), put(2, 33.0f, -10.0f, 1.0f);
  put(2, -32.0f, 20.0f, 1.0f), put(2, 31.0f, 24.0f, 1.0f), put(2, 0.0f, -38.0f, 1.1f), put(2, 9.0f, -42.0f, 1.0f);
  const std::int32_t bush = bushMesh(level, bark, m.leaves, 35);
  for (const glm::vec2& p :
       {glm::vec2(4.6f, 1.8f), {5.4f, -0.6f}, {-6.2f, -6.0f}, {6.4f, 3.6f}, {-7.4f, -4.0f}, {9.6f, -6.0f}})
    level.node("bush", bush, {p.x, groundY(p.x, p.y), p.y}, random.range(0, 6), random.range(0.7f, 1.1f));
  MeshBuilder tufts;
  for (int i = 0; i < 900; ++i) {
    const float x = random.range(-16.0f, 16.0f), z = random.range(-20.0f, 3.5f);
    if (glm::abs(x) < 6.3f && z < 3.6f && z > -26) continue;
    if (z > -4.5f && glm::abs(x) < 12.5f && random.unit() < 0.6f) continue;
    grassTuft(tufts, random, {x, groundY(x, z), z}, {0, 1, 0}, random.range(0.3f, 0.55f));
  }
  level.single("undergrowth", {tufts.finish(m.tufts)});
}

/// A post with a lantern.
std::int32_t lampMesh(LevelBuilder& level, const Materials& m) {
  MeshBuilder iron, glow;
  lathe(iron,
        {{0.22f, -0.2f},
         {0.22f, 0.25f},
         {0.22f, 0.25f},
         {0.12f, 0.4f},
         {0.07f, 0.5f},
         {0.055f, 3.0f},
         {0.09f, 3.05f},
         {0.09f, 3.12f},
         {0.02f, 3.14f}},
        10);
  chamferBox(glow, {-0.13f, 3.16f, -0.13f}, {0.13f, 3.58f, 0.13f}, 0.02f);
  for (const float x : {-0.16f, 0.16f}) {
    for (const float z : {-0.16f, 0.16f}) tube(iron, {{0.8f * x, 3.1f, 0.8f * z}, {x, 3.62f, z}}, {0.02f, 0.02f}, 5);
  }
  lathe(iron, {{0.02f, 3.58f}, {0.26f, 3.60f}, {0.26f, 3.60f}, {0.14f, 3.82f}, {0.03f, 3.98f}}, 4);
  return level.mesh("lamp", {iron.finish(m.iron), glow.finish(m.glow)});
}

/// Railings with spear heads and stone posts round the tower's foot.
void addRailings(LevelBuilder& level, const Materials& m) {
  MeshBuilder iron, stone;
  const auto run = [&](const glm::vec2& a, const glm::vec2& c) {
    const int bars = static_cast<int>(glm::length(c - a) / 0.2f);
    for (int i = 0; i <= bars; ++i) {
      const glm::vec2 p = glm::mix(a, c, real(i) / real(bars));
      const float y = groundY(p.x, p.y);
      tube(iron, {{p.x, y, p.y}, {p.x, y + 1.15f, p.y}, {p.x, y + 1.3f, p.y}}, {0.018f, 0.018f, 0.002f}, 5);
      if (i % 14 != 0 && i != bars) continue;
      chamferBox(stone, {p.x - 0.22f, y - 0.3f, p.y - 0.22f}, {p.x + 0.22f, y + 1.35f, p.y + 0.22f}, 0.05f,
                 Mapping::kUpright);
    }
    for (const float y : {0.25f, 1.05f})
      beam(iron, {a.x, groundY(a.x, a.y) + y, a.y}, {c.x, groundY(c.x, c.y) + y, c.y}, 0.04f, 0.03f, 0.0f);
  };
  run({-11.0f, 5.2f}, {-1.6f, 5.2f}), run({1.6f, 5.2f}, {11.0f, 5.2f});
  level.single("railings", {iron.finish(m.iron), stone.finish(m.dressed, hall::kPillarTile)});
}

void addGoods(LevelBuilder& level, const Materials& m) {
  const Coat planks{m.planks, 2.0f}, timber{m.timber, hall::kWoodTile}, iron{m.iron, 1.0f};
  const std::int32_t crate = crateMesh(level, planks, timber), barrel = barrelMesh(level, planks, iron),
                     lamp = lampMesh(level, m);
  const auto put = [&](const char* name, std::int32_t mesh, float x, float z, float yaw, float scale = 1,
                       float up = 0) {
    level.node(name, mesh, {x, groundY(x, z) + 0.05f + up, z}, yaw, scale);
  };
  put("crate", crate, -7.6f, 7.4f, 0.3f), put("crate", crate, -8.7f, 7.1f, 1.1f),
      put("crate", crate, -8.1f, 7.3f, 0.7f, 0.8f, 0.9f);
  put("barrel", barrel, -6.4f, 7.0f, 0), put("barrel", barrel, -6.9f, 8.3f, 1), put("barrel", barrel, 8.8f, 14.6f, 2),
      put("crate", crate, 9.2f, 16.0f, 0.2f);
  for (const float z : {9.5f, 20.5f}) put("lamp", lamp, -8.6f, z, 0), put("lamp", lamp, 8.2f, z + 1.5f, 0);
  // The well in the middle of the square.
  MeshBuilder stone, wood;
  lathe(stone, {{1.15f, -0.3f}, {1.15f, 0.85f}, {1.15f, 0.85f}, {0.85f, 0.85f}, {0.85f, 0.85f}, {0.85f, -0.3f}}, 24);
  lathe(stone, {{1.6f, -0.3f}, {1.6f, 0.16f}, {1.6f, 0.16f}, {1.1f, 0.16f}}, 24);
  for (const float x : {-0.98f, 0.98f}) beam(wood, {x, 0.6f, 0}, {x, 2.5f, 0}, 0.16f, 0.16f, 0.02f, {0, 0, 1});
  beam(wood, {-1.25f, 2.45f, 0}, {1.25f, 2.45f, 0}, 0.16f, 0.16f, 0.02f);
  tube(wood, {{-0.95f, 1.9f, 0}, {0.95f, 1.9f, 0}}, {0.1f, 0.1f}, 10);
  for (const float s : {-1.0f, 1.0f})
    beam(wood, {0, 2.98f, s * 0.02f}, {0, 2.35f, s * 0.95f}, 2.7f, 0.06f, 0.0f, {0, 1, 0});
  tube(wood, {{0.2f, 1.9f, 0.1f}, {0.2f, 0.9f, 0.1f}}, {0.015f, 0.015f}, 5);
  level.node("well", level.mesh("well", {stone.finish(m.ashlar, hall::kAshlarTile), wood.finish(m.planks, 2.0f)}),
             {4.6f, groundY(4.6f, 15.5f), 15.5f}, 0.5f);
}

}  // namespace

float groundY(float x, float z) {
  const glm::vec2 p{x, z};
  const float far = glm::smoothstep(22.0f, 70.0f, glm::length(p));
  return 0.22f * (fbm(p * 0.12f + 300.0f, kNoPeriod, 3, 5) - 0.5f) +
         far * (9.0f * fbm(p * 0.03f + 300.0f, kNoPeriod, 4, 6) - 1.5f);
}

void addSquare(LevelBuilder& level, const Materials& m) {
  addGround(level, m);
  addTrees(level, m);
  addRailings(level, m);
  addGoods(level, m);
}

}  // namespace tyndall::levels::tower
