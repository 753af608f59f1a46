// What stands about: tombs, rubble, a ladder below the well, crates and barrels, candles.
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "shapes.hpp"
#include "vault_parts.hpp"

namespace tyndall::levels::vault {
namespace {

/// Chest of a tomb with blind arches, 2.1 m long, along z.
std::int32_t chestMesh(LevelBuilder& level, const Materials& m) {
  MeshBuilder stone;
  chamferBox(stone, {-0.52f, -0.05f, -1.12f}, {0.52f, 0.14f, 1.12f}, 0.03f, Mapping::kUpright);
  chamferBox(stone, {-0.43f, 0.1f, -1.02f}, {0.43f, 0.74f, 1.02f}, 0.02f, Mapping::kUpright);
  for (const float side : {-1.0f, 1.0f}) {
    for (int i = 0; i < 5; ++i) {
      const float z = -0.8f + 0.4f * real(i);
      std::vector<glm::vec3> arch{{side * 0.435f, 0.16f, z - 0.15f}};
      for (int k = 0; k <= 8; ++k) {
        const float angle = glm::pi<float>() * (1.0f - real(k) / 8.0f);
        arch.emplace_back(side * 0.435f, 0.5f + 0.15f * glm::sin(angle), z + 0.15f * glm::cos(angle));
      }
      arch.emplace_back(side * 0.435f, 0.16f, z + 0.15f);
      bar(stone, arch, {1, 0, 0}, 0.05f, 0.06f);
    }
  }
  return level.mesh("tomb", {m.dressed.finish(stone)});
}

std::int32_t lidMesh(LevelBuilder& level, const Materials& m) {
  MeshBuilder stone;
  chamferBox(stone, {-0.5f, 0, -1.1f}, {0.5f, 0.12f, 1.1f}, 0.035f, Mapping::kUpright);
  chamferBox(stone, {-0.06f, 0.1f, -0.9f}, {0.06f, 0.17f, 0.9f}, 0.02f, Mapping::kUpright);
  chamferBox(stone, {-0.3f, 0.1f, -0.56f}, {0.3f, 0.165f, -0.44f}, 0.02f, Mapping::kUpright);
  return level.mesh("lid", {m.dressed.finish(stone)});
}

void addTombs(LevelBuilder& level, const Materials& m) {
  const std::int32_t chest = chestMesh(level, m), lid = lidMesh(level, m);
  const auto put = [&](const glm::vec3& at, float yaw) {
    level.node("tomb", chest, at, yaw);
    level.node("lid", lid, at + glm::vec3(0, 0.73f, 0), yaw);
  };
  put({0.4f, 0, -3.35f}, 1.42f);
  put({-3.3f, 0, 0.9f}, 0.05f);
  // The third is open: its lid leans against it.
  level.node("tomb", chest, {3.3f, 0, 0.2f}, -0.04f);
  scene::Node n;
  n.name = "lid";
  n.mesh = lid;
  n.translation = {2.36f, 0.42f, 0.35f};
  n.rotation = glm::angleAxis(0.1f, glm::vec3(0, 1, 0)) * glm::angleAxis(1.12f, glm::vec3(0, 0, 1));
  level.node(n);
}

void addRubble(LevelBuilder& level, const Materials& m) {
  const std::int32_t rocks[] = {rockMesh(level, m.rock, 71), rockMesh(level, m.rock, 72),
                                rockMesh(level, m.rubble, 73)};
  MeshBuilder one;
  chamferBox(one, {-0.125f, 0, -0.06f}, {0.125f, 0.07f, 0.06f}, 0.008f, Mapping::kGrain);
  const std::int32_t brick = level.mesh("brick", {m.brick.finish(one)});
  Random random(303);
  const auto heap = [&](const glm::vec2& at, float radius, int stones, int bricks) {
    for (int i = 0; i < stones + bricks; ++i) {
      const float angle = random.range(0, 6.2832f), far = radius * glm::sqrt(random.unit());
      const glm::vec2 p = at + far * glm::vec2(glm::cos(angle), glm::sin(angle));
      const float pile = 0.45f * radius * glm::max(0.0f, 1.0f - far / radius) * random.unit();
      const float yaw = random.range(0, 6.2832f);
      if (i < stones) {
        const float size = random.range(0.09f, 0.26f);
        level.node("rubble", rocks[random.below(3)], {p.x, pile + 0.25f * size, p.y}, yaw, size);
      } else {
        scene::Node n;
        n.name = "brick";
        n.mesh = brick;
        n.translation = {p.x, pile + 0.01f, p.y};
        n.rotation =
            glm::angleAxis(yaw, glm::vec3(0, 1, 0)) * glm::angleAxis(random.range(-0.3f, 0.3f), glm::vec3(1, 0, 0));
        level.node(n);
      }
    }
  };
  heap({1.9f, 3.0f}, 0.9f, 16, 14);
  heap({-3.7f, 4.9f}, 1.0f, 16, 10);
  heap({-0.4f, 1.3f}, 1.3f, 8, 12);  // below the well
  heap({3.9f, -5.9f}, 0.8f, 12, 6);
}

void addWood(LevelBuilder& level, const Materials& m) {
  MeshBuilder wood;
  // The ladder by which someone came in: it leans against the well's curb, in the light.
  const glm::vec3 foot{-1.55f, 0, 3.0f}, head{-0.62f, 4.98f, 2.32f};
  const glm::vec3 up = glm::normalize(head - foot), back = glm::normalize(glm::cross(glm::vec3(0.55f, 0, 0.83f), up));
  wood.frame = glm::mat4(glm::vec4(glm::cross(up, back), 0), glm::vec4(up, 0), glm::vec4(back, 0), glm::vec4(foot, 1));
  ladder(wood, glm::length(head - foot));
  level.single("ladder", {m.timber.finish(wood)});

  const std::int32_t crate = crateMesh(level, m.planks, m.timber), barrel = barrelMesh(level, m.timber, {m.iron, 1});
  for (const auto& [at, yaw, scale] : {std::tuple{glm::vec3(-3.85f, 0, -5.9f), 0.15f, 1.0f},
                                       {glm::vec3(-2.8f, 0, -6.2f), -0.3f, 0.85f},
                                       {glm::vec3(-3.8f, 0.9f, -5.95f), 0.6f, 0.7f},
                                       {glm::vec3(3.85f, 0, 5.7f), 0.1f, 0.95f}}) {
    level.node("crate", crate, at, yaw, scale);
  }
  for (const glm::vec2 at : {glm::vec2(-4.0f, -4.6f), {3.95f, 4.5f}, {-4.0f, 6.3f}, {-3.2f, 6.4f}})
    level.node("barrel", barrel, {at.x, 0, at.y}, 5.0f * at.x);
  scene::Node fallen;
  fallen.name = "barrel";
  fallen.mesh = barrel;
  fallen.translation = {2.2f, 0.37f, -5.2f};
  fallen.rotation =
      glm::angleAxis(0.7f, glm::vec3(0, 1, 0)) * glm::angleAxis(glm::half_pi<float>(), glm::vec3(1, 0, 0));
  level.node(fallen);

  MeshBuilder bench;
  chamferBox(bench, {-0.17f, 0.41f, -1.0f}, {0.17f, 0.47f, 1.0f}, 0.015f);
  for (const float z : {-0.75f, 0.75f})
    chamferBox(bench, {-0.14f, -0.02f, z - 0.04f}, {0.14f, 0.42f, z + 0.04f}, 0.015f);
  const std::int32_t mesh = level.mesh("bench", {m.timber.finish(bench)});
  level.node("bench", mesh, {-0.9f, 0, -0.35f}, 0.75f);
  level.node("bench", mesh, {1.7f, 0, -1.1f}, -0.5f);
}

/// The door by which the stairs come down: closed, in a frame on the +z wall.
void addDoor(LevelBuilder& level, const Materials& m) {
  MeshBuilder boards, stone, iron;
  const float z = kHalfLength;
  chamferBox(boards, {-0.75f, 0.02f, z - 0.07f}, {0.75f, 2.2f, z + 0.1f}, 0.0f);
  for (const float x : {-0.86f, 0.86f})
    chamferBox(stone, {x - 0.14f, -0.05f, z - 0.16f}, {x + 0.14f, 2.3f, z + 0.1f}, 0.03f, Mapping::kUpright);
  chamferBox(stone, {-1.1f, 2.2f, z - 0.18f}, {1.1f, 2.55f, z + 0.1f}, 0.03f, Mapping::kUpright);
  for (const float y : {0.5f, 1.7f}) chamferBox(iron, {-0.7f, y, z - 0.09f}, {0.55f, y + 0.07f, z}, 0.008f);
  level.single("door", {m.planks.finish(boards), m.dressed.finish(stone), m.rust.finish(iron)});
}

void addCandles(LevelBuilder& level, const Materials& m) {
  MeshBuilder iron, wax, flame;
  lathe(iron, {{0.02f, 0}, {0.08f, 0.012f}, {0.09f, 0.04f}, {0.09f, 0.04f}, {0.08f, 0.04f}, {0.01f, 0.02f}}, 14);
  lathe(wax, {{0.036f, 0.02f}, {0.034f, 0.2f}, {0.034f, 0.2f}, {0.02f, 0.195f}, {0.005f, 0.19f}}, 12);
  lathe(flame, {{0.004f, 0.2f}, {0.018f, 0.225f}, {0.015f, 0.255f}, {0.002f, 0.305f}}, 8);
  const std::int32_t candle = level.mesh("candle", {iron.finish(m.iron), wax.finish(m.wax), flame.finish(m.flame)});
  for (const auto& [at, scale] : {std::pair{glm::vec3(-0.72f, 1.33f, -6.5f), 1.2f},
                                  {glm::vec3(-0.5f, 1.33f, -6.3f), 0.9f},
                                  {glm::vec3(0.7f, 1.33f, -6.45f), 1.2f},
                                  {glm::vec3(0.46f, 1.33f, -6.62f), 0.8f},
                                  {glm::vec3(-3.25f, 0.85f, 1.5f), 1.0f},
                                  {glm::vec3(0.95f, 0.85f, -3.3f), 1.0f}}) {
    level.node("candle", candle, at, 0, scale);
  }
}

}  // namespace

void addThings(LevelBuilder& level, const Materials& m) {
  addTombs(level, m);
  addRubble(level, m);
  addWood(level, m);
  addDoor(level, m);
  addCandles(level, m);
}

}  // namespace tyndall::levels::vault
