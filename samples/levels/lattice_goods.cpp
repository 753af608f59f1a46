// What stands about: pallets, drums, crates, and the work lamp on its tripod.
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>

#include "lattice_parts.hpp"
#include "shapes.hpp"

namespace tyndall::levels::lattice {
namespace {

std::int32_t palletMesh(LevelBuilder& level, const Materials& m) {
  MeshBuilder wood;
  Random random(611);
  const auto board = [&](const glm::vec3& min, const glm::vec3& max) {
    wood.uvOffset = {random.unit() * 2, random.unit() * 2};
    wood.color = glm::vec4(glm::vec3(random.range(0.7f, 1.0f)), 1);
    chamferBox(wood, min, max, 0.004f);
  };
  for (int i = 0; i < 7; ++i)
    board({-0.6f, 0.122f, -0.4f + 0.117f * real(i)}, {0.6f, 0.144f, -0.31f + 0.117f * real(i)});
  for (const float x : {-0.55f, 0.0f, 0.55f}) board({x - 0.05f, 0.1f, -0.4f}, {x + 0.05f, 0.122f, 0.4f});
  for (const float x : {-0.52f, 0.0f, 0.52f})
    for (const float z : {-0.34f, 0.0f, 0.34f}) board({x - 0.06f, 0.02f, z - 0.05f}, {x + 0.06f, 0.1f, z + 0.05f});
  for (const float z : {-0.34f, 0.0f, 0.34f}) board({-0.6f, 0, z - 0.05f}, {0.6f, 0.02f, z + 0.05f});
  return level.mesh("pallet", {m.planks.finish(wood)});
}

std::int32_t drumMesh(LevelBuilder& level, std::int32_t paint) {
  MeshBuilder tin;
  std::vector<glm::vec2> profile{{0.01f, 0.02f}, {0.28f, 0.02f}, {0.28f, 0.02f},
                                 {0.29f, 0},     {0.29f, 0},     {0.29f, 0.02f}};
  for (const float y : {0.29f, 0.58f})
    for (const glm::vec2 p : {glm::vec2(0.285f, -0.03f), {0.298f, 0}, {0.285f, 0.03f}})
      profile.emplace_back(p.x, y + p.y);
  for (const glm::vec2 p : {glm::vec2(0.285f, 0.86f),
                            {0.29f, 0.88f},
                            {0.29f, 0.88f},
                            {0.275f, 0.88f},
                            {0.275f, 0.88f},
                            {0.275f, 0.86f},
                            {0.275f, 0.86f},
                            {0.01f, 0.86f}})
    profile.push_back(p);
  lathe(tin, profile, 22);
  return level.mesh("drum", {tin.finish(paint)});
}

void addTripod(LevelBuilder& level, const Materials& m, const glm::vec3& aim) {
  MeshBuilder iron, lens;
  for (int i = 0; i < 3; ++i) {
    const float angle = 2.0f * glm::pi<float>() * real(i) / 3.0f + 0.3f;
    tube(iron, {{0.55f * glm::cos(angle), 0, 0.55f * glm::sin(angle)}, {0, 1.25f, 0}}, {0.016f, 0.016f}, 6, true);
  }
  tube(iron, {{0, 1.1f, 0}, {0, kTripodLamp.y - 0.16f, 0}}, {0.018f, 0.018f}, 8, true);
  const glm::vec3 foot(kTripodLamp.x, 0, kTripodLamp.z);
  level.node("tripod", level.mesh("tripod", {iron.finish(m.yellow)}), foot + glm::vec3(0.12f, 0, -0.08f));
  MeshBuilder head;
  chamferBox(head, {-0.2f, -0.15f, 0.05f}, {0.2f, 0.15f, 0.17f}, 0.015f);  // behind the light, which looks down -z
  for (float y = -0.12f; y < 0.13f; y += 0.04f) chamferBox(head, {-0.18f, y, 0.17f}, {0.18f, y + 0.012f, 0.21f}, 0);
  card(lens, {0, -0.13f, 0.045f}, {0.36f, 0, 0}, {0, 0.26f, 0}, {0, 0, -1});
  scene::Node n;
  n.name = "work lamp";
  n.translation = kTripodLamp;
  n.rotation = lookRotation(aim - kTripodLamp);
  n.mesh = level.mesh("work lamp", {head.finish(m.yellow), lens.finish(m.glass)});
  level.node(n);
  level.spot("work lamp", kTripodLamp, aim, {1.0f, 0.90f, 0.74f}, 620.0f, 34.0f, 40.0f, 13.0f);
}

}  // namespace

void addGoods(LevelBuilder& level, const Materials& m) {
  const std::int32_t pallet = palletMesh(level, m), crate = crateMesh(level, m.planks, m.timber);
  const std::int32_t drums[] = {drumMesh(level, m.rust.material), drumMesh(level, m.yellow)};
  Random random(612);
  const auto stack = [&](const glm::vec2& at, float yaw, int count) {
    for (int i = 0; i < count; ++i)
      level.node("pallet", pallet,
                 {at.x + random.range(-0.04f, 0.04f), 0.146f * real(i), at.y + random.range(-0.04f, 0.04f)},
                 yaw + random.range(-0.08f, 0.08f));
  };
  stack({-1.3f, -2.6f}, 0.2f, 9);
  stack({0.3f, -4.6f}, -0.35f, 5);
  stack({-6.9f, -8.2f}, 1.4f, 7);
  stack({6.6f, 2.4f}, 0.1f, 6);
  stack({-1.9f, 7.6f}, 0.9f, 3);
  for (int i = 0; i < 3; ++i) {  // upright, leaning at the tower and the fence
    scene::Node n;
    n.name = "pallet";
    n.mesh = pallet;
    n.translation = i == 0   ? glm::vec3(-2.9f, 0.58f, -5.2f)
                    : i == 1 ? glm::vec3(2.46f, 0.6f, 0.35f)
                             : glm::vec3(7.4f, 0.58f, -6.4f);
    n.rotation = glm::angleAxis(i == 2 ? 0.3f : glm::half_pi<float>(), glm::vec3(0, 1, 0)) *
                 glm::angleAxis(i == 0 ? -1.35f : 1.35f, glm::vec3(0, 0, 1));
    level.node(n);
  }
  for (const auto& [kind, at] : {std::pair{0, glm::vec2(-6.3f, -0.4f)},
                                 {1, {-6.95f, -0.7f}},
                                 {0, {-6.5f, 0.3f}},
                                 {0, {5.6f, -4.2f}},
                                 {1, {6.3f, -4.5f}},
                                 {1, {0.2f, 3.2f}},
                                 {0, {0.85f, 3.6f}}})
    level.node("drum", drums[kind], {at.x, 0, at.y}, 3 * at.x);
  for (const auto& [at, scale] : {std::pair{glm::vec3(6.9f, 0, -1.2f), 1.1f},
                                  {glm::vec3(7.9f, 0, -1.0f), 0.9f},
                                  {glm::vec3(-1.3f, 1.32f, -2.6f), 0.7f},
                                  {glm::vec3(-7.9f, 0, 9.6f), 1.1f}})
    level.node("crate", crate, at, at.x, scale);
  addTripod(level, m, {kCageX, 1.55f, 0.05f});
}

}  // namespace tyndall::levels::lattice
