// The ground, what stands on it, and the lamps.
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "shapes.hpp"
#include "town_parts.hpp"

namespace tyndall::levels::town {
namespace {

std::int32_t binMesh(LevelBuilder& level, const Materials& m) {
  MeshBuilder tin;
  lathe(tin,
        {{0.02f, 0.02f},
         {0.25f, 0.02f},
         {0.25f, 0.02f},
         {0.25f, 0.06f},
         {0.29f, 0.78f},
         {0.29f, 0.78f},
         {0.31f, 0.78f},
         {0.31f, 0.82f},
         {0.31f, 0.82f},
         {0.18f, 0.90f},
         {0.01f, 0.92f}},
        22);
  for (const float y : {0.25f, 0.5f}) {
    tin.frame = placed({0, y, 0});
    lathe(tin, {{0.25f + 0.045f * y, -0.02f}, {0.285f + 0.045f * y, 0}, {0.25f + 0.045f * y, 0.02f}}, 22);
  }
  tin.frame = placed({0, 0.91f, 0});
  tube(tin, {{-0.09f, 0, 0}, {-0.07f, 0.06f, 0}, {0.07f, 0.06f, 0}, {0.09f, 0, 0}}, {0.012f, 0.012f, 0.012f, 0.012f},
       6);
  return level.mesh("bin", {m.rust.finish(tin)});
}

/// A hand cart's body about its axle, wheels apart; it comes down the street and goes back.
void addCart(LevelBuilder& level, const Materials& m) {
  MeshBuilder wood, wheelWood, tyre;
  for (float x = -0.5f; x < 0.51f; x += 0.2f) beam(wood, {x, 0.2f, -0.95f}, {x, 0.2f, 0.95f}, 0.17f, 0.035f, 0.006f);
  for (const float x : {-0.55f, 0.55f}) {
    beam(wood, {x, 0.16f, -1.0f}, {x, 0.1f, 2.1f}, 0.07f, 0.08f, 0.01f);
    for (const float y : {0.42f, 0.62f, 0.82f}) beam(wood, {x, y, -0.95f}, {x, y, 0.95f}, 0.03f, 0.10f, 0.006f);
    for (const float z : {-0.9f, 0.0f, 0.9f}) beam(wood, {x, 0.14f, z}, {x, 0.92f, z}, 0.06f, 0.06f, 0.01f, {0, 0, 1});
  }
  for (const float y : {0.42f, 0.62f, 0.82f}) beam(wood, {-0.55f, y, -0.95f}, {0.55f, y, -0.95f}, 0.03f, 0.10f, 0.006f);
  beam(wood, {-0.75f, 0, 0}, {0.75f, 0, 0}, 0.07f, 0.07f, 0.01f);
  constexpr float kRadius = 0.55f;
  wheelWood.frame = tyre.frame = glm::rotate(glm::mat4(1), glm::half_pi<float>(), glm::vec3(0, 1, 0));
  bar(wheelWood, ringPath(kRadius - 0.05f, {0, 0}, 32), {0, 0, 1}, 0.08f, 0.06f, true);
  bar(tyre, ringPath(kRadius, {0, 0}, 32), {0, 0, 1}, 0.015f, 0.065f, true);
  for (int i = 0; i < 10; ++i) {
    const float angle = glm::pi<float>() * real(i) / 5.0f;
    const glm::vec3 out{glm::cos(angle), glm::sin(angle), 0};
    beam(wheelWood, 0.05f * out, (kRadius - 0.06f) * out, 0.04f, 0.045f, 0.008f, {0, 0, 1});
  }
  const std::int32_t body = level.node("cart", level.mesh("cart", {m.timber.finish(wood)}), {0.9f, kRadius, -9.0f});
  const std::int32_t wheel = level.mesh("wheel", {m.timber.finish(wheelWood), tyre.finish(m.iron)});
  constexpr int kKeys = 96;
  constexpr float kSeconds = 24.0f, kReach = 4.0f;  // there and back, metres from the middle
  scene::AnimationChannel move;
  move.node = body;
  move.target = scene::AnimationTarget::kTranslation;
  scene::AnimationChannel roll[2];
  for (int w = 0; w < 2; ++w) {
    roll[w].node = level.node("wheel", wheel, {w == 0 ? -0.68f : 0.68f, 0, 0}, 0, 1, body);
    roll[w].target = scene::AnimationTarget::kRotation;
  }
  for (int i = 0; i <= kKeys; ++i) {
    const float away = kReach * glm::sin(2.0f * glm::pi<float>() * real(i % kKeys) / kKeys),
                time = kSeconds * real(i) / kKeys;
    move.times.push_back(time);
    move.values.emplace_back(0.9f, kRadius, -9.0f + away, 0.0f);
    const float half = 0.5f * away / kRadius;
    for (scene::AnimationChannel& r : roll) {
      r.times.push_back(time);
      r.values.emplace_back(glm::sin(half), 0, 0, glm::cos(half));
    }
  }
  level.animate(std::move(move));
  for (scene::AnimationChannel& r : roll) level.animate(std::move(r));
}

}  // namespace

void addStreet(LevelBuilder& level, const Materials& m) {
  MeshBuilder ground, kerb, outside;
  const float low = kGateZ - 14.0f, high = 22.0f;
  surface(ground, 8, 30, {6.0f, high - low}, [&](float u, float v) {  // crowned, falling to the gutters
    const float x = glm::mix(-3.0f, 3.0f, u);
    return glm::vec3(x, -0.006f * x * x, glm::mix(high, low, v));
  });
  chamferBox(outside, {-40, -0.5f, low - 30}, {40, -0.22f, high + 10}, 0, Mapping::kUpright);
  Random random(541);
  for (const float side : {-1.0f, 1.0f}) {
    const float a = side * 2.85f, c = side * (kFront + 0.4f);
    for (float z = low; z < high; z += 1.1f) {
      kerb.uvOffset = {random.unit() * 2, random.unit() * 2};
      kerb.color = glm::vec4(glm::vec3(random.range(0.6f, 0.85f)), 1);
      const float lift = random.range(0.08f, 0.1f);
      chamferBox(kerb, {glm::min(a, c), -0.3f, z}, {glm::max(a, c), lift, z + 1.09f}, 0.012f, Mapping::kUpright);
    }
  }
  level.single("street", {m.cobbles.finish(ground), m.dressed.finish(kerb), m.cobbles.finish(outside)});
  const std::int32_t bin = binMesh(level, m), crate = crateMesh(level, m.planks, m.timber),
                     barrel = barrelMesh(level, m.timber, {m.iron, 1});
  for (const auto& [mesh, at, scale] : {std::tuple{bin, glm::vec3(-3.55f, 0.09f, 6.9f), 1.0f},
                                        {bin, glm::vec3(-3.5f, 0.09f, 7.6f), 0.95f},
                                        {bin, glm::vec3(3.6f, 0.09f, -0.5f), 1.0f},
                                        {bin, glm::vec3(-3.6f, 0.09f, -7.8f), 1.0f},
                                        {crate, glm::vec3(3.55f, 0.09f, 5.3f), 0.8f},
                                        {crate, glm::vec3(3.5f, 0.09f, 4.4f), 0.7f},
                                        {crate, glm::vec3(3.55f, 0.81f, 5.25f), 0.6f},
                                        {crate, glm::vec3(-3.5f, 0.09f, -2.6f), 0.75f},
                                        {barrel, glm::vec3(3.6f, 0.09f, 3.4f), 0.95f},
                                        {barrel, glm::vec3(-3.65f, 0.09f, -1.7f), 1.0f},
                                        {barrel, glm::vec3(-3.6f, 0.09f, -5.6f), 0.9f},
                                        {barrel, glm::vec3(3.5f, 0.09f, -9.4f), 1.0f}})
    level.node(mesh == bin ? "bin" : mesh == crate ? "crate" : "barrel", mesh, at, 3.1f * at.z, scale);
  addCart(level, m);
}

}  // namespace tyndall::levels::town
