// The open storey: what the sun shines through. And the scaffolding beside it.
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "hall_textures.hpp"
#include "props.hpp"
#include "shapes.hpp"
#include "tower_parts.hpp"
#include "wall.hpp"

namespace tyndall::levels::tower {
namespace {

constexpr float kQuarter = glm::half_pi<float>();
constexpr glm::vec3 kFacing{0, 0, 1};

std::vector<glm::vec3> archPath(float half, float spring, float shift, float depth) {
  std::vector<glm::vec3> path;
  for (const glm::vec3& p : pointedArch(half, kSill, spring, 7)) path.emplace_back(p.x + shift, p.z, depth);
  path.insert(path.begin(), {path.front().x, kSill, depth}), path.emplace_back(path.back().x, kSill, depth);
  return path;
}

/// Mullion, two lancets and a quatrefoil, in a wall whose outer face is z = 0.
void tracery(MeshBuilder& stone) {
  const float d = -0.4f;
  bar(stone, archPath(kOpeningHalf - 0.02f, kSpring, 0, d), kFacing, 0.14f, 0.3f);
  bar(stone, {{0, kSill - 0.1f, d}, {0, kSpring + 0.6f, d}}, kFacing, 0.13f, 0.22f);
  for (const float s : {-1.0f, 1.0f}) bar(stone, archPath(0.55f, kSpring - 0.3f, 0.62f * s, d), kFacing, 0.09f, 0.18f);
  for (int i = 0; i < 4; ++i) {
    const float angle = kQuarter * real(i) + 0.5f * kQuarter;
    const glm::vec2 at = glm::vec2(0, kSpring + 1.12f) + 0.2f * glm::vec2(glm::cos(angle), glm::sin(angle));
    bar(stone, ringPath(0.2f, at, 12, d), kFacing, 0.06f, 0.14f, true);
  }
}

/// Down its inside and up its outside: fronts are to the right of the way.
void bellShape(MeshBuilder& bronze) {
  lathe(bronze,
        {{0.02f, -0.34f},
         {0.34f, -0.4f},
         {0.42f, -0.8f},
         {0.54f, -1.08f},
         {0.68f, -1.26f},
         {0.68f, -1.26f},
         {0.74f, -1.26f},
         {0.74f, -1.26f},
         {0.60f, -1.10f},
         {0.48f, -0.85f},
         {0.42f, -0.55f},
         {0.38f, -0.32f},
         {0.30f, -0.24f},
         {0.02f, -0.22f}},
        28);
}

}  // namespace

void addBelfry(LevelBuilder& level, const Materials& m) {
  MeshBuilder face, reveal, stone, wood, iron;
  const Outline hole = pointedArch(kOpeningHalf, kSill, kSpring, 9);
  for (int side = 0; side < 4; ++side) {
    const glm::mat4 frame =
        glm::rotate(glm::mat4(1), kQuarter * real(side), glm::vec3(0, 1, 0)) * placed({0, 0, kHalf});
    face.frame = reveal.frame = stone.frame = frame;
    wall(face, reveal, {kHalf, kBelfry - 0.1f, kBelfryTop, kBelfryTop, 0.7f}, hole, hole);
    tracery(stone);
    chamferBox(stone, {-kOpeningHalf - 0.15f, kSill - 0.16f, -0.75f}, {kOpeningHalf + 0.15f, kSill, 0.18f}, 0.04f,
               Mapping::kUpright);
    for (int i = 0; i < 5; ++i) {  // a balustrade in the opening
      const float x = -1.0f + 0.5f * real(i);
      bar(stone, {{x, kSill, -0.2f}, {x, kSill + 0.75f, -0.2f}}, kFacing, 0.08f, 0.08f);
    }
    bar(stone, {{-kOpeningHalf, kSill + 0.78f, -0.2f}, {kOpeningHalf, kSill + 0.78f, -0.2f}}, kFacing, 0.1f, 0.14f);
  }
  // The bell's frame: two trestles along x, the bell's axis along z between them.
  for (const float z : {-1.15f, 1.15f}) {
    for (const float s : {-1.0f, 1.0f})
      beam(wood, {s * 1.7f, kBelfry, z}, {s * 0.22f, kPivot.y, z}, 0.2f, 0.2f, 0.03f, {0, 0, 1});
    beam(wood, {-1.0f, 12.0f, z}, {1.0f, 12.0f, z}, 0.16f, 0.18f, 0.03f);
    beam(wood, {-0.4f, kPivot.y, z}, {0.4f, kPivot.y, z}, 0.22f, 0.2f, 0.03f);
  }
  level.single("belfry", {face.finish(m.ashlar, hall::kAshlarTile), reveal.finish(m.dressed, hall::kPillarTile),
                          stone.finish(m.dressed, hall::kPillarTile), wood.finish(m.timber, hall::kWoodTile)});
  MeshBuilder bronze, yoke;
  bellShape(bronze);
  beam(yoke, {0, -0.1f, -1.1f}, {0, -0.1f, 1.1f}, 0.34f, 0.36f, 0.04f);
  bar(iron, ringPath(0.95f, {0, 0}, 28, 0.75f), kFacing, 0.07f, 0.1f, true);
  for (int i = 0; i < 4; ++i) {
    const float angle = kQuarter * 0.5f * real(i);
    const glm::vec3 out = 0.95f * glm::vec3(glm::cos(angle), glm::sin(angle), 0);
    bar(iron, {glm::vec3(0, 0, 0.75f) - out, glm::vec3(0, 0, 0.75f) + out}, kFacing, 0.05f, 0.06f);
  }
  tube(iron, {{0, -0.4f, 0}, {0, -1.2f, 0}}, {0.04f, 0.05f}, 6);
  lathe(iron, {{0.02f, -1.42f}, {0.12f, -1.34f}, {0.12f, -1.22f}, {0.02f, -1.15f}}, 10);
  const std::int32_t bell =
      level.mesh("bell", {bronze.finish(m.bronze), yoke.finish(m.timber, hall::kWoodTile), iron.finish(m.iron)});
  level.animateSwing(level.node("bell", bell, kPivot), {0, 0, 1}, 0.0f, 0.75f, 3.0f, 8);
}

void addScaffolding(LevelBuilder& level, const Materials& m) {
  MeshBuilder wood, boards, cloth;
  Random random(301);
  const float xs[] = {-kHalf - 1.25f, -kHalf - 2.7f}, lift = 2.2f, top = 15.6f;
  const float zs[] = {-3.6f, -1.2f, 1.2f, 3.6f};
  const auto pole = [&](const glm::vec3& a, const glm::vec3& c, float r) {
    tube(wood, {a, c}, {r, 0.9f * r}, 7, true);
  };
  for (const float x : xs) {
    for (const float z : zs)
      pole({x, -0.3f, z}, {x + random.range(-0.06f, 0.06f), top + random.range(-0.7f, 0.5f), z}, 0.075f);
  }
  for (int storey = 1; storey <= 6; ++storey) {
    const float y = lift * real(storey);
    for (const float x : xs) {
      pole({x + 0.1f, y, -4.2f}, {x + 0.1f, y, 4.2f}, 0.06f);
      pole({x + 0.1f, y + 1.0f, -4.0f}, {x + 0.1f, y + 1.0f, 4.0f}, 0.04f);
    }
    for (const float z : zs) pole({xs[1] - 0.4f, y + 0.1f, z + 0.1f}, {-kHalf + 0.1f, y + 0.1f, z + 0.1f}, 0.055f);
    for (int plank = 0; plank < 5; ++plank) {  // platforms, with planks missing
      for (int bay = 0; bay < 3; ++bay) {
        if (random.unit() < 0.22f) continue;
        const float x = xs[1] + 0.18f + 0.29f * real(plank), z = zs[bay] + random.range(-0.1f, 0.1f);
        boards.uvOffset = {random.unit() * 2, random.unit() * 2};
        chamferBox(boards, {x, y + 0.16f, z}, {x + 0.26f, y + 0.21f, z + 2.5f}, 0.0f);
      }
    }
    const float z = storey % 2 == 0 ? 3.6f : 1.2f;
    pole({xs[1] - 0.08f, y - lift, -z}, {xs[1] - 0.08f, y, z}, 0.05f);  // braces
    boards.frame = glm::translate(glm::mat4(1), {xs[0] - 0.6f, y - lift + 0.1f, storey % 2 == 0 ? -2.4f : 2.4f}) *
                   glm::rotate(glm::mat4(1), storey % 2 == 0 ? 0.25f : -0.25f, glm::vec3(1, 0, 0));
    ladder(boards, lift + 0.9f);
    boards.frame = glm::mat4(1);
  }
  // A tarpaulin that hangs from one bay.
  surface(cloth, 8, 12, {2.4f, 4.2f}, [](float u, float v) {
    return glm::vec3(-kHalf - 2.82f + 0.12f * glm::sin(7.0f * u + 3.0f * v), 6.7f + 4.2f * v, 1.2f + 2.4f * u);
  });
  level.single("scaffolding",
               {wood.finish(m.timber, hall::kWoodTile), boards.finish(m.planks, 2.0f), cloth.finish(m.canvas, 2.0f)});
}

}  // namespace tyndall::levels::tower
