// Banners, the runner, chandeliers, lanterns.
#include <glm/gtc/constants.hpp>

#include "hall_parts.hpp"
#include "hall_textures.hpp"
#include "shapes.hpp"

namespace tyndall::levels::hall {
namespace {

constexpr float kTurn = 2.0f * glm::pi<float>();
constexpr float kChandelierDrop = 4.0f;  // from the tie beam to the wheel

/// Cloth of 1.5 m by 3.6 m on a rod, with a pointed lower hem; its upper edge at y = 0, facing +z.
std::int32_t bannerMesh(LevelBuilder& level, const Materials& m, std::int32_t cloth, float phase) {
  MeshBuilder c, rod;
  surface(c, 14, 24, {1, 1}, [&](float u, float v) {
    const float down = 1.0f - v, side = 2.0f * u - 1.0f;
    const float hem = 3.15f + 0.5f * (1.0f - glm::abs(side)) * glm::smoothstep(0.5f, 1.0f, down);
    const float wave = (0.02f + 0.06f * down) * glm::sin(u * 9.0f + phase + 1.3f * down) +
                       0.04f * down * glm::sin(4.0f * down + phase);
    return glm::vec3(0.75f * side * (1.0f - 0.03f * down), -hem * down, wave);
  });
  tube(rod, {{-0.9f, 0.01f, 0}, {0.9f, 0.01f, 0}}, {0.025f, 0.025f}, 8, true);
  for (const float x : {-0.9f, 0.9f}) {
    rod.frame = placed({x, 0.01f, 0});
    lathe(rod, {{0.005f, -0.05f}, {0.045f, -0.02f}, {0.045f, 0.02f}, {0.005f, 0.05f}}, 8);
  }
  return level.mesh("banner", {c.finish(cloth), rod.finish(m.iron)});
}

/// A wheel with eight candles, hanging from the node's origin.
std::int32_t chandelierMesh(LevelBuilder& level, const Materials& m) {
  MeshBuilder iron, wax, flame;
  const float y = -kChandelierDrop, radius = 1.05f;
  std::vector<glm::vec3> wheel;
  for (int i = 0; i < 32; ++i)
    wheel.emplace_back(radius * glm::cos(kTurn * real(i) / 32.0f), y, radius * glm::sin(kTurn * real(i) / 32.0f));
  bar(iron, wheel, {0, 1, 0}, 0.035f, 0.12f, true);
  for (int i = 0; i < 4; ++i) {
    const glm::vec3 out{glm::cos(kTurn * real(i) / 4.0f), 0, glm::sin(kTurn * real(i) / 4.0f)};
    beam(iron, glm::vec3(0, y, 0), glm::vec3(0, y, 0) + radius * out, 0.035f, 0.05f, 0.0f);
    tube(iron, {glm::vec3(0, y, 0) + radius * out, {0, y + 1.3f, 0}}, {0.014f, 0.014f}, 6);
  }
  tube(iron, {{0, y + 1.28f, 0}, {0, 0, 0}}, {0.022f, 0.022f}, 6);
  iron.frame = placed({0, y, 0});
  lathe(iron, {{0.005f, -0.2f}, {0.06f, -0.12f}, {0.11f, -0.04f}, {0.11f, 0.05f}, {0.03f, 0.1f}}, 12);
  for (int i = 0; i < 8; ++i) {
    const float angle = kTurn * (real(i) + 0.5f) / 8.0f;
    const glm::mat4 at = placed({radius * glm::cos(angle), y + 0.06f, radius * glm::sin(angle)});
    iron.frame = wax.frame = flame.frame = at;
    lathe(iron, {{0.02f, 0}, {0.07f, 0.02f}, {0.08f, 0.05f}, {0.08f, 0.05f}, {0.07f, 0.05f}, {0.01f, 0.03f}}, 10);
    lathe(wax, {{0.033f, 0.03f}, {0.031f, 0.26f}, {0.031f, 0.26f}, {0.005f, 0.265f}}, 10);
    lathe(flame, {{0.004f, 0.265f}, {0.018f, 0.29f}, {0.015f, 0.32f}, {0.002f, 0.37f}}, 8);
  }
  return level.mesh("chandelier", {iron.finish(m.iron), wax.finish(m.wax), flame.finish(m.flame)});
}

/// A caged lamp on a bracket, from a wall at z = 0 towards +z.
std::int32_t lanternMesh(LevelBuilder& level, const Materials& m) {
  MeshBuilder iron, lamp;
  chamferBox(iron, {-0.06f, -0.2f, -0.06f}, {0.06f, 0.25f, 0.03f}, 0.01f);
  tube(iron, {{0, -0.1f, 0.02f}, {0, 0.12f, 0.18f}, {0, 0.25f, 0.38f}, {0, 0.21f, 0.46f}},
       {0.02f, 0.018f, 0.015f, 0.012f}, 6);
  iron.frame = lamp.frame = placed({0, -0.22f, 0.46f});
  lathe(iron, {{0.01f, -0.05f}, {0.11f, 0}, {0.11f, 0.03f}, {0.11f, 0.03f}, {0.01f, 0.03f}}, 6);
  lathe(iron, {{0.01f, 0.315f}, {0.13f, 0.32f}, {0.13f, 0.32f}, {0.13f, 0.34f}, {0.05f, 0.42f}, {0.012f, 0.45f}}, 6);
  for (int i = 0; i < 6; ++i) {
    const glm::vec3 at{0.1f * glm::cos(kTurn * real(i) / 6.0f), 0, 0.1f * glm::sin(kTurn * real(i) / 6.0f)};
    tube(iron, {at, at + glm::vec3(0, 0.33f, 0)}, {0.009f, 0.009f}, 4);
  }
  lathe(lamp, {{0.01f, 0.035f}, {0.085f, 0.04f}, {0.085f, 0.04f}, {0.085f, 0.31f}, {0.085f, 0.31f}, {0.01f, 0.315f}},
        6);
  return level.mesh("lantern", {iron.finish(m.iron), lamp.finish(m.lamp)});
}

}  // namespace

void addHangings(LevelBuilder& level, const Materials& m) {
  const std::int32_t banners[] = {bannerMesh(level, m, m.bannerSun, 0.4f), bannerMesh(level, m, m.bannerCross, 2.1f)};
  for (int bay = 0; bay < kBays - 1; ++bay) {
    if (bay != kDoorBay)
      level.node("banner", banners[bay % 2], {-kHalfWidth + 0.18f, 7.3f, bayZ(bay)}, glm::half_pi<float>());
  }
  for (const float side : {-1.0f, 1.0f})
    level.node("banner", banners[1], {side * 2.9f, 6.3f, -kHalfLength + 0.2f}, 0, 1.15f);

  MeshBuilder runner;
  chamferBox(runner, {0, -0.02f, -15.8f}, {kRunnerTile, 0.018f, 13.0f}, 0.01f, Mapping::kUpright);
  level.node("runner", level.mesh("runner", {runner.finish(m.runner, kRunnerTile)}), {-0.5f * kRunnerTile, 0, 0});

  const std::int32_t chandelier = chandelierMesh(level, m);
  int index = 0;
  for (const float z : {-10.0f, 0.0f, 10.0f}) {  // under the tie beams
    const std::int32_t node = level.node("chandelier", chandelier, {0, kTieY - 0.2f, z});
    // The middle one swings visibly, the others just do not hang dead still; period of a pendulum of 4 m: 4 s.
    const glm::vec3 axis = glm::normalize(glm::vec3(0.3f + 0.3f * real(index), 0, 1.0f));
    level.animateSwing(node, axis, 0, index == 1 ? 0.16f : 0.03f, 4.0f, 6);
    ++index;
  }
  const std::int32_t lantern = lanternMesh(level, m);
  for (const float z : {-15.0f, -5.0f, 5.0f}) {
    for (const float side : {-1.0f, 1.0f})
      level.node("lantern", lantern, {side * (kPillarX - 0.40f), 3.0f, z}, -side * glm::half_pi<float>());
  }
}

}  // namespace tyndall::levels::hall
