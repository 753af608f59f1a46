// Tables, benches, crates, barrels, the throne; the door leaf.
#include <algorithm>

#include <glm/gtc/constants.hpp>

#include "hall_parts.hpp"
#include "hall_textures.hpp"
#include "props.hpp"
#include "shapes.hpp"

namespace tyndall::levels::hall {
namespace {

std::int32_t tableMesh(LevelBuilder& level, const Materials& m) {
  MeshBuilder wood, metal;
  for (int i = 0; i < 4; ++i) {  // four boards
    const float x = -0.5f + 0.25f * real(i);
    wood.uvOffset = {0.37f * real(i), 0.25f * real(i)};
    wood.color = glm::vec4(glm::vec3(0.85f + 0.08f * real(i % 3)), 1);
    chamferBox(wood, {x + 0.004f, 0.70f, -2.1f}, {x + 0.246f, 0.77f, 2.1f}, 0.012f);
  }
  for (const float z : {-1.6f, 1.6f}) {
    chamferBox(wood, {-0.40f, 0.62f, z - 0.06f}, {0.40f, 0.71f, z + 0.06f}, 0.015f);
    chamferBox(wood, {-0.38f, -0.02f, z - 0.06f}, {0.38f, 0.08f, z + 0.06f}, 0.015f);
    for (const float x : {-0.24f, 0.24f})
      chamferBox(wood, {x - 0.05f, 0.05f, z - 0.05f}, {x + 0.05f, 0.65f, z + 0.05f}, 0.015f);
  }
  beam(wood, {0, 0.3f, -1.7f}, {0, 0.3f, 1.7f}, 0.06f, 0.14f, 0.01f);
  Random random(17);
  for (int i = 0; i < 6; ++i) {  // goblets and bowls
    const glm::vec3 at{random.range(-0.36f, 0.36f), 0.77f, -1.7f + 0.68f * real(i)};
    metal.frame = placed(at);
    if (i % 3 == 1) {
      lathe(metal,
            {{0.05f, 0}, {0.13f, 0.05f}, {0.16f, 0.09f}, {0.16f, 0.09f}, {0.15f, 0.09f}, {0.1f, 0.04f}, {0.01f, 0.03f}},
            14);
    } else {
      lathe(metal,
            {{0.045f, 0},
             {0.04f, 0.012f},
             {0.012f, 0.03f},
             {0.012f, 0.08f},
             {0.04f, 0.11f},
             {0.045f, 0.19f},
             {0.045f, 0.19f},
             {0.04f, 0.19f},
             {0.03f, 0.12f},
             {0.005f, 0.11f}},
            12);
    }
  }
  return level.mesh("table", {wood.finish(m.timber, kWoodTile), metal.finish(m.gold)});
}

std::int32_t benchMesh(LevelBuilder& level, const Materials& m) {
  MeshBuilder wood;
  chamferBox(wood, {-0.17f, 0.41f, -2.0f}, {0.17f, 0.47f, 2.0f}, 0.015f);
  for (const float z : {-1.5f, 1.5f}) chamferBox(wood, {-0.14f, -0.02f, z - 0.04f}, {0.14f, 0.42f, z + 0.04f}, 0.015f);
  beam(wood, {0, 0.22f, -1.6f}, {0, 0.22f, 1.6f}, 0.04f, 0.1f, 0.01f);
  return level.mesh("bench", {wood.finish(m.timber, kWoodTile)});
}

std::int32_t throneMesh(LevelBuilder& level, const Materials& m) {
  MeshBuilder wood, metal, cloth;
  chamferBox(wood, {-0.42f, 0.38f, -0.4f}, {0.42f, 0.5f, 0.35f}, 0.03f);
  for (const float x : {-0.38f, 0.38f}) {
    chamferBox(wood, {x - 0.06f, -0.02f, -0.42f}, {x + 0.06f, 2.0f, -0.3f}, 0.02f);
    chamferBox(wood, {x - 0.06f, -0.02f, 0.22f}, {x + 0.06f, 0.82f, 0.34f}, 0.02f);
    chamferBox(wood, {x - 0.07f, 0.78f, -0.36f}, {x + 0.07f, 0.86f, 0.40f}, 0.02f);
    metal.frame = placed({x, 2.0f, -0.36f});
    lathe(metal, {{0.05f, 0}, {0.05f, 0.02f}, {0.02f, 0.05f}, {0.07f, 0.11f}, {0.06f, 0.17f}, {0.005f, 0.21f}}, 12);
  }
  chamferBox(wood, {-0.4f, 0.5f, -0.40f}, {0.4f, 1.85f, -0.32f}, 0.02f);
  chamferBox(cloth, {-0.30f, 0.49f, -0.28f}, {0.30f, 0.57f, 0.3f}, 0.03f);
  chamferBox(cloth, {-0.28f, 0.7f, -0.34f}, {0.28f, 1.6f, -0.29f}, 0.02f);
  return level.mesh("throne",
                    {wood.finish(m.darkTimber, kWoodTile), metal.finish(m.gold), cloth.finish(m.runner, kRunnerTile)});
}

}  // namespace

void addFurniture(LevelBuilder& level, const Materials& m) {
  Random random(91);
  const std::int32_t table = tableMesh(level, m), bench = benchMesh(level, m);
  for (const float side : {-1.0f, 1.0f}) {
    for (const float z : {-10.2f, -4.6f, 1.0f}) {
      const float x = side * 2.35f;
      level.node("table", table, {x, 0, z}, side < 0 ? 0 : glm::pi<float>());
      for (const float to : {-0.74f, 0.74f})
        level.node("bench", bench, {x + to + random.range(-0.05f, 0.05f), 0, z}, random.range(-0.03f, 0.03f));
    }
  }
  const std::int32_t crate = crateMesh(level, {m.planks, kWoodTile}, {m.timber, kWoodTile}),
                     barrel = barrelMesh(level, {m.timber, 0.5f * kWoodTile}, {m.iron, 1});
  for (const auto& [at, yaw, scale] : {std::tuple{glm::vec3(5.9f, 0, 9.2f), 0.2f, 1.0f},
                                       {glm::vec3(5.7f, 0, 10.5f), -0.35f, 1.1f},
                                       {glm::vec3(5.85f, 0.9f, 9.3f), 0.7f, 0.8f},
                                       {glm::vec3(-5.9f, 0, -10.6f), 0.1f, 1.0f},
                                       {glm::vec3(-4.6f, 0, 17.4f), 0.4f, 1.15f}}) {
    level.node("crate", crate, at, yaw, scale);
  }
  for (const glm::vec2 at :
       {glm::vec2(6.1f, 7.9f), {5.2f, 8.0f}, {-6.1f, -9.2f}, {-5.4f, -8.9f}, {-6.0f, -7.9f}, {-3.9f, 18.6f}}) {
    level.node("barrel", barrel, {at.x, 0, at.y}, random.range(0, 6));
  }
  level.node("throne", throneMesh(level, m), {0, 0.51f, -18.9f}, 0, 1.15f);
}

void addDoor(LevelBuilder& level, const Materials& m) {
  // The hinge at the leaf's edge is the node's origin; the leaf reaches along +x, seen from the room.
  MeshBuilder wood, iron;
  const Outline arch = pointedArch(kDoorHalf, 0.05f, kDoorSpring, 8);
  for (const bool front : {true, false}) {
    std::vector<glm::vec3> corners{{arch.front().x, arch.front().y, 0}, {arch.back().x, arch.back().y, 0}};
    for (auto p = arch.rbegin(); p != arch.rend(); ++p) corners.emplace_back(p->x, p->z, 0);
    std::vector<glm::vec2> uv;
    for (glm::vec3& p : corners) {
      uv.emplace_back(p.y, p.x);  // boards upright
      p += glm::vec3(kDoorHalf, 0, front ? 0.05f : -0.05f);
    }
    if (!front) std::reverse(corners.begin(), corners.end()), std::reverse(uv.begin(), uv.end());
    wood.flatPolygon(corners, uv);
  }
  std::vector<glm::vec3> rim{{0.03f, 0.05f, 0}};
  for (const glm::vec3& p : arch) rim.emplace_back(0.97f * p.x + kDoorHalf, p.z - 0.03f, 0);
  rim.emplace_back(2 * kDoorHalf - 0.03f, 0.05f, 0);
  bar(wood, rim, {0, 0, 1}, 0.07f, 0.13f);
  for (const float y : {0.6f, 2.1f}) chamferBox(iron, {0.0f, y, -0.065f}, {1.6f, y + 0.09f, 0.065f}, 0.01f);
  chamferBox(iron, {1.85f, 1.1f, -0.1f}, {1.93f, 1.3f, 0.1f}, 0.01f);
  const std::int32_t mesh = level.mesh("door leaf", {wood.finish(m.planks, kWoodTile), iron.finish(m.iron)});
  // In the north wall (frame turned by 90 degrees: its x runs to -z), hinge at the +z side.
  const std::int32_t frame = level.node("door frame", scene::kNone, {-kHalfWidth - 0.2f, 0, bayZ(kDoorBay) + kDoorHalf},
                                        glm::half_pi<float>());
  const std::int32_t leaf = level.node("door leaf", mesh, {0, 0, 0}, 0, 1, frame);
  level.animateSwing(leaf, {0, 1, 0}, -0.55f, 0.4f, 12.0f, 2);
}

}  // namespace tyndall::levels::hall
