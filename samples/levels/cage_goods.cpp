// What is stored: whatever has bars, slats or spokes to throw shadows with.
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "cage_parts.hpp"
#include "shapes.hpp"

namespace tyndall::levels::cage {
namespace {

constexpr float kTurn = 2.0f * glm::pi<float>();

std::int32_t sackMesh(LevelBuilder& level, const Materials& m) {
  MeshBuilder sack, cord;
  lathe(sack,
        {{0.02f, 0.02f},
         {0.2f, 0},
         {0.28f, 0.06f},
         {0.31f, 0.2f},
         {0.29f, 0.4f},
         {0.2f, 0.56f},
         {0.09f, 0.64f},
         {0.08f, 0.66f},
         {0.13f, 0.76f},
         {0.12f, 0.78f},
         {0.02f, 0.7f}},
        18);
  cord.frame = placed({0, 0.65f, 0});
  lathe(cord, {{0.085f, -0.02f}, {0.105f, 0}, {0.085f, 0.02f}}, 14);
  return level.mesh("sack", {m.sack.finish(sack), m.rope.finish(cord)});
}

/// A cart's wheel about the z axis, its middle at the origin.
std::int32_t wheelMesh(LevelBuilder& level, const Materials& m) {
  MeshBuilder wood, iron;
  constexpr float kRadius = 0.72f;
  bar(wood, ringPath(kRadius - 0.05f, {0, 0}, 36), {0, 0, 1}, 0.09f, 0.08f, true);
  bar(iron, ringPath(kRadius, {0, 0}, 36), {0, 0, 1}, 0.016f, 0.085f, true);
  for (int i = 0; i < 12; ++i) {
    const float angle = kTurn * real(i) / 12.0f;
    const glm::vec3 out{glm::cos(angle), glm::sin(angle), 0};
    beam(wood, 0.08f * out, (kRadius - 0.07f) * out, 0.045f, 0.05f, 0.01f, {0, 0, 1});
  }
  wood.frame = iron.frame = glm::rotate(glm::mat4(1), glm::half_pi<float>(), glm::vec3(1, 0, 0));
  lathe(wood, {{0.06f, -0.17f}, {0.09f, -0.14f}, {0.12f, 0}, {0.09f, 0.14f}, {0.06f, 0.17f}}, 16);
  lathe(iron, {{0.005f, -0.18f}, {0.065f, -0.18f}, {0.065f, -0.18f}, {0.065f, -0.16f}}, 12);
  return level.mesh("wheel", {m.timber.finish(wood), m.rust.finish(iron)});
}

void addCrates(LevelBuilder& level, const Materials& m) {
  const std::int32_t crate = crateMesh(level, m.planks, m.timber), barrel = barrelMesh(level, m.timber, {m.iron, 1});
  for (const auto& [at, yaw, scale] : {std::tuple{glm::vec3(5.1f, 0, -2.6f), 0.08f, 1.15f},
                                       {glm::vec3(5.2f, 0, -1.35f), -0.12f, 1.0f},
                                       {glm::vec3(5.15f, 1.035f, -2.55f), 0.4f, 0.9f},
                                       {glm::vec3(4.05f, 0, -2.75f), 0.5f, 0.8f},
                                       {glm::vec3(-5.1f, 0, 5.7f), 0.05f, 1.2f},
                                       {glm::vec3(-5.2f, 0, 4.45f), -0.2f, 1.0f},
                                       {glm::vec3(-5.15f, 1.08f, 5.6f), 0.3f, 0.95f},
                                       {glm::vec3(-1.2f, 0, -2.7f), 0.35f, 0.9f},
                                       {glm::vec3(1.2f, kDeck, -6.6f), 0.2f, 0.9f},
                                       {glm::vec3(0.1f, kDeck, -6.7f), -0.1f, 0.8f},
                                       {glm::vec3(-2.4f, 0, -6.6f), 0.1f, 1.1f}}) {
    level.node("crate", crate, at, yaw, scale);
  }
  for (const glm::vec2 at : {glm::vec2(-3.9f, 6.6f),
                             {-3.1f, 6.8f},
                             {-4.0f, 5.8f},
                             {0.9f, -5.0f},
                             {5.3f, 0.0f},
                             {1.0f, -6.9f},
                             {-0.2f, -6.8f}})
    level.node("barrel", barrel, {at.x, 0, at.y}, 4.0f * at.y);
  const std::int32_t sack = sackMesh(level, m);
  Random random(411);
  for (const glm::vec3 at : {glm::vec3(-5.4f, 0, 3.3f),
                             {-4.8f, 0, 3.45f},
                             {-5.2f, 0, 2.75f},
                             {2.7f, 0, -2.3f},
                             {-2.2f, kDeck, -6.9f},
                             {-2.9f, kDeck, -6.7f},
                             {-1.6f, kDeck, -6.6f}})
    level.node("sack", sack, at, random.range(0, 6), random.range(0.9f, 1.15f));
}

/// Shelves of slats along the +x wall, with jars.
void addRack(LevelBuilder& level, const Materials& m) {
  MeshBuilder wood, clay;
  const float x0 = 5.25f, x1 = 5.95f, z0 = 1.2f, z1 = 4.0f;
  for (const float z : {z0, 0.5f * (z0 + z1), z1}) {
    for (const float x : {x0, x1}) beam(wood, {x, -0.02f, z}, {x, 2.5f, z}, 0.07f, 0.07f, 0.01f, {0, 0, 1});
    for (const float y : {0.4f, 1.1f, 1.8f, 2.45f})
      beam(wood, {x0, y - 0.04f, z}, {x1, y - 0.04f, z}, 0.05f, 0.06f, 0.008f);
  }
  Random random(412);
  for (const float y : {0.4f, 1.1f, 1.8f, 2.45f}) {
    for (int i = 0; i < 5; ++i) {
      const float x = x0 + 0.02f + 0.16f * real(i);
      wood.uvOffset = {random.unit() * 2, random.unit() * 2};
      beam(wood, {x, y, z0 - 0.1f}, {x, y, z1 + 0.1f}, 0.10f, 0.025f, 0.004f);
    }
    for (float z = z0 + 0.2f; z < z1; z += random.range(0.3f, 0.55f)) {
      const float s = random.range(0.75f, 1.2f);
      clay.frame = placed({random.range(5.45f, 5.7f), y + 0.012f, z}, random.range(0, 6), s);
      clay.color =
          glm::vec4(glm::mix(glm::vec3(0.42f, 0.25f, 0.17f), glm::vec3(0.26f, 0.30f, 0.27f), random.unit()), 1);
      lathe(clay,
            {{0.06f, 0},
             {0.11f, 0.06f},
             {0.12f, 0.14f},
             {0.08f, 0.24f},
             {0.05f, 0.27f},
             {0.06f, 0.30f},
             {0.06f, 0.30f},
             {0.05f, 0.30f},
             {0.01f, 0.26f}},
            14);
    }
  }
  level.single("rack", {m.timber.finish(wood), m.dressed.finish(clay)});
}

/// A screen of crossed laths between two posts: the lamp draws it on floor and wall.
void addTrellis(LevelBuilder& level, const Materials& m) {
  MeshBuilder wood;
  const float x = -3.1f, z0 = 1.0f, z1 = 3.7f, low = 0.15f, high = 2.3f;
  for (const float z : {z0, z1}) beam(wood, {x, -0.02f, z}, {x, high + 0.1f, z}, 0.08f, 0.08f, 0.01f, {0, 0, 1});
  for (const float y : {low, high}) beam(wood, {x, y, z0}, {x, y, z1}, 0.05f, 0.07f, 0.01f);
  const float height = high - low;
  for (float at = z0 - height; at < z1; at += 0.27f) {
    for (const float side : {-1.0f, 1.0f}) {
      // A lath from (at, low) rising at 45 degrees, cut to the frame; the other way round for the second layer.
      const float from = glm::max(at, z0), to = glm::min(at + height, z1);
      if (to - from < 0.05f) continue;
      const auto z = [&](float s) { return side > 0 ? s : z0 + z1 - s; };
      beam(wood, {x + 0.015f * side, low + from - at, z(from)}, {x + 0.015f * side, low + to - at, z(to)}, 0.018f,
           0.045f, 0.003f);
    }
  }
  level.single("trellis", {m.timber.finish(wood)});
}

/// Block and tackle, a net of ropes with a load; a ladder; a wheel; coils.
void addTackle(LevelBuilder& level, const Materials& m) {
  MeshBuilder links;
  const glm::vec3 load{1.9f, 0, 4.4f};
  chain(links, 2.2f, 0.12f, 0.012f);
  std::vector<glm::vec3> hook{{0, -2.2f, 0}};
  for (int i = 0; i <= 12; ++i) {
    const float angle = glm::half_pi<float>() - 1.45f * glm::pi<float>() * real(i) / 12.0f;
    hook.emplace_back(0.1f * glm::cos(angle), -2.36f + 0.1f * glm::sin(angle), 0);
  }
  tube(links, hook, std::vector<float>(hook.size(), 0.02f), 8, true);
  const std::int32_t tackle =
      level.node("tackle", level.mesh("tackle", {m.rustyBars.finish(links)}), {load.x, kCeiling - 0.32f, load.z});
  level.animateSwing(tackle, {1, 0, 0}, 0, 0.05f, 3.0f, 8);

  MeshBuilder wood;
  const glm::vec3 foot{-1.5f, 0, -2.9f}, head{-1.75f, 3.65f, kLoftZ};
  const glm::vec3 up = glm::normalize(head - foot), right = glm::normalize(glm::cross(up, glm::vec3(0, 0, 1)));
  wood.frame =
      glm::mat4(glm::vec4(right, 0), glm::vec4(up, 0), glm::vec4(glm::cross(right, up), 0), glm::vec4(foot, 1));
  ladder(wood, glm::length(head - foot));
  level.single("ladder", {m.timber.finish(wood)});

  const std::int32_t wheel = wheelMesh(level, m);
  const auto lean = [&](const glm::vec3& at, float yaw, float tilt) {
    scene::Node n;
    n.name = "wheel";
    n.mesh = wheel;
    n.translation = at;
    n.rotation = glm::angleAxis(yaw, glm::vec3(0, 1, 0)) * glm::angleAxis(tilt, glm::vec3(1, 0, 0));
    level.node(n);
  };
  lean({3.25f, 0.70f, 1.0f}, 1.55f, -0.22f);
  lean({2.5f, 0.71f, -6.9f}, 0.1f, -0.25f);

  MeshBuilder rope;
  for (int coil = 0; coil < 5; ++coil) {
    std::vector<glm::vec3> ring;
    for (int i = 0; i <= 28; ++i) {
      const float angle = -kTurn * real(i % 28) / 28.0f, r = 0.27f - 0.012f * real(coil);
      ring.emplace_back(r * glm::cos(angle), 0.03f + 0.045f * real(coil), r * glm::sin(angle));
    }
    tube(rope, ring, std::vector<float>(ring.size(), 0.026f), 8);
  }
  const std::int32_t coil = level.mesh("rope", {m.rope.finish(rope)});
  level.node("rope", coil, {-2.2f, 0, 0.9f});
  level.node("rope", coil, {4.2f, 0, 5.6f}, 1, 1.3f);

  // A bird's cage on a crate: more bars, close to the floor's light.
  MeshBuilder wire;
  for (int i = 0; i < 16; ++i) {
    const float angle = kTurn * real(i) / 16.0f;
    std::vector<glm::vec3> path;
    for (int k = 0; k <= 8; ++k) {
      const float up01 = real(k) / 8.0f,
                  r = up01 < 0.6f ? 0.2f
                                  : 0.2f * glm::sqrt(glm::max(0.002f, 1.0f - glm::pow((up01 - 0.6f) / 0.4f, 2.0f)));
      path.emplace_back(r * glm::cos(angle), 0.5f * up01, r * glm::sin(angle));
    }
    tube(wire, path, std::vector<float>(path.size(), 0.006f), 5);
  }
  for (const float y : {0.01f, 0.15f, 0.30f}) {
    std::vector<glm::vec3> ring;
    for (int i = 0; i <= 28; ++i)
      ring.emplace_back(0.2f * glm::cos(kTurn * real(i % 28) / 28.0f), y,
                        -0.2f * glm::sin(kTurn * real(i % 28) / 28.0f));
    tube(wire, ring, std::vector<float>(ring.size(), 0.008f), 5);
  }
  level.node("bird cage", level.mesh("bird cage", {wire.finish(m.brass)}), {-1.2f, 0.81f, -2.7f}, 0, 1.25f);
}

}  // namespace

void addGoods(LevelBuilder& level, const Materials& m) {
  addCrates(level, m);
  addRack(level, m);
  addTrellis(level, m);
  addTackle(level, m);
}

}  // namespace tyndall::levels::cage
