// The lamp in its cage, and the stove.
#include <glm/gtc/constants.hpp>

#include "cage_parts.hpp"
#include "shapes.hpp"

namespace tyndall::levels::cage {
namespace {

constexpr float kTurn = 2.0f * glm::pi<float>();

/// Radius of the cage at height y above the light: a lantern's belly.
float cageRadius(float y) {
  const float k = y / kCageHalf;
  return glm::mix(0.15f, kCageRadius, glm::sqrt(glm::max(0.0f, 1.0f - 0.92f * k * k)));
}

void addWires(MeshBuilder& wire) {
  constexpr int kUprights = 14;
  for (int i = 0; i < kUprights; ++i) {
    const float angle = kTurn * (real(i) + 0.5f) / kUprights;
    std::vector<glm::vec3> path;
    for (int k = 0; k <= 14; ++k) {
      const float y = glm::mix(-kCageHalf, kCageHalf, real(k) / 14.0f), r = cageRadius(y);
      path.emplace_back(r * glm::cos(angle), y, r * glm::sin(angle));
    }
    tube(wire, path, std::vector<float>(path.size(), 0.012f), 6);
  }
  for (const auto& [y, thick] : {std::pair{-0.29f, 0.010f},
                                 {-0.15f, 0.010f},
                                 {0.0f, 0.010f},
                                 {0.15f, 0.010f},
                                 {0.29f, 0.010f},
                                 {-kCageHalf, 0.016f},
                                 {kCageHalf, 0.016f}}) {
    std::vector<glm::vec3> ring;
    for (int i = 0; i <= 40; ++i) {
      const float angle = -kTurn * real(i % 40) / 40.0f;
      ring.emplace_back(cageRadius(y) * glm::cos(angle), y, cageRadius(y) * glm::sin(angle));
    }
    tube(wire, ring, std::vector<float>(ring.size(), thick), 6);
  }
}

}  // namespace

void addLamp(LevelBuilder& level, const Materials& m) {
  MeshBuilder iron, wire, glass, filament;
  // The node's origin is the hook; the light hangs kDrop below, in the cage.
  const float chainEnd = kDrop - kCageHalf - 0.30f;
  chain(iron, chainEnd, 0.09f, 0.009f);
  const glm::mat4 about = placed({0, -kDrop, 0});
  iron.frame = wire.frame = glass.frame = filament.frame = about;
  addWires(wire);
  const float top = kCageHalf;
  lathe(iron,  // the hood, thin, with its underside
        {{0.02f, top + 0.10f},
         {0.10f, top + 0.07f},
         {0.27f, top - 0.03f},
         {0.27f, top - 0.03f},
         {0.28f, top - 0.02f},
         {0.28f, top - 0.02f},
         {0.17f, top + 0.06f},
         {0.09f, top + 0.16f},
         {0.04f, top + 0.20f},
         {0.03f, top + 0.30f},
         {0.005f, top + 0.31f}},
        28);
  lathe(iron,
        {{0.005f, -top - 0.05f},
         {0.07f, -top - 0.03f},
         {0.16f, -top},
         {0.16f, -top},
         {0.15f, -top + 0.015f},
         {0.005f, -top + 0.015f}},
        28);
  lathe(iron, {{0.005f, -top - 0.14f}, {0.03f, -top - 0.11f}, {0.012f, -top - 0.05f}}, 12);
  lathe(iron, {{0.035f, 0.2f}, {0.035f, 0.2f}, {0.045f, 0.22f}, {0.045f, 0.36f}, {0.03f, 0.40f}, {0.02f, top + 0.1f}},
        14);
  // Glass and glow are blended: they neither cast a shadow nor end a ray, so the light may stand within them.
  lathe(glass,
        {{0.005f, -0.13f},
         {0.06f, -0.115f},
         {0.10f, -0.06f},
         {0.115f, 0},
         {0.10f, 0.07f},
         {0.06f, 0.15f},
         {0.04f, 0.21f}},
        20);
  lathe(filament, {{0.004f, -0.06f}, {0.035f, -0.045f}, {0.05f, 0}, {0.035f, 0.05f}, {0.004f, 0.08f}}, 14);
  scene::Node n;
  n.name = "caged lamp";
  n.translation = kPivot;
  n.mesh = level.mesh("caged lamp",
                      {m.rust.finish(iron), m.rustyBars.finish(wire), filament.finish(m.bulb), glass.finish(m.glass)});
  const std::int32_t lamp = level.node(n);
  level.point("lamp", {0, -kDrop, 0}, {1.0f, 0.80f, 0.52f}, 70.0f, 16.0f, lamp);
  level.animateSwing(lamp, glm::normalize(glm::vec3(0.45f, 0, 1.0f)), 0, 0.17f, 4.0f, 6);

  MeshBuilder hook;  // its bend's lowest point carries the chain
  std::vector<glm::vec3> bend{{-0.05f, 0.32f, 0}};
  for (int i = 0; i <= 14; ++i) {
    const float angle = glm::pi<float>() * (1.0f + 1.3f * real(i) / 14.0f);
    bend.emplace_back(0.05f * glm::cos(angle), 0.05f + 0.05f * glm::sin(angle), 0);
  }
  tube(hook, bend, std::vector<float>(bend.size(), 0.014f), 8, true);
  level.node("hook", level.mesh("hook", {hook.finish(m.iron)}), kPivot - glm::vec3(0, 0.02f, 0));
}

void addStove(LevelBuilder& level, const Materials& m) {
  MeshBuilder iron, bars, embers;
  constexpr float w = 0.42f, t = 0.05f, low = 0.22f, high = 1.12f, sill = 0.44f, lintel = 0.92f;
  // In the node's frame the door looks to +z. Five plates and the frame of the door.
  chamferBox(iron, {-w, low, -w}, {w, low + t, w}, 0.012f);
  chamferBox(iron, {-w - 0.04f, high - t, -w - 0.04f}, {w + 0.04f, high, w + 0.04f}, 0.012f);
  chamferBox(iron, {-w, low, -w}, {w, high - 0.01f, -w + t}, 0.0f);
  for (const float side : {-1.0f, 1.0f}) {
    const float a = side * w, c = side * (w - t), jamb = side * (w - 0.14f);
    chamferBox(iron, {glm::min(a, c), low, -w}, {glm::max(a, c), high - 0.01f, w}, 0.0f);
    chamferBox(iron, {glm::min(a, jamb), low, w - t}, {glm::max(a, jamb), high - 0.01f, w + 0.005f}, 0.0f);
    for (const float z : {-0.34f, 0.34f}) {
      iron.frame = placed({side * 0.34f, 0, z});
      lathe(iron, {{0.05f, -0.02f}, {0.03f, 0.04f}, {0.035f, 0.14f}, {0.06f, 0.24f}}, 12);
      iron.frame = glm::mat4(1);
    }
  }
  chamferBox(iron, {-w, low, w - t}, {w, sill, w + 0.005f}, 0.0f);
  chamferBox(iron, {-w, lintel, w - t}, {w, high - 0.01f, w + 0.005f}, 0.0f);
  for (int i = -3; i <= 3; ++i)
    bentRod(bars, {0.075f * real(i), sill - 0.03f, w - 0.02f}, {0.075f * real(i), lintel + 0.03f, w - 0.02f}, 0.011f,
            i == 1 ? glm::vec3(0.02f, 0, 0.03f) : glm::vec3(0));
  bentRod(bars, {-w + 0.1f, 0.68f, w + 0.005f}, {w - 0.1f, 0.68f, w + 0.005f}, 0.010f, {0, 0, 0});
  // Flue: up, a knee, and through the ceiling.
  tube(iron,
       {{0, high - 0.02f, -0.18f},
        {0, 2.3f, -0.18f},
        {0, 2.62f, -0.26f},
        {0, 2.95f, -0.5f},
        {0, 3.3f, -0.6f},
        {0, kCeiling + 0.1f, -0.6f}},
       {0.10f, 0.10f, 0.10f, 0.10f, 0.10f, 0.10f}, 16);
  for (const float y : {1.5f, 2.2f, 3.6f, 4.6f}) {
    iron.frame = placed({0, y, y < 3 ? -0.18f : -0.6f});
    lathe(iron, {{0.10f, -0.03f}, {0.115f, -0.03f}, {0.115f, -0.03f}, {0.115f, 0.03f}, {0.115f, 0.03f}, {0.10f, 0.03f}},
          16);
  }
  iron.frame = glm::mat4(1);
  // Embers lie below the light.
  Random random(403);
  for (int i = 0; i < 26; ++i) {
    const glm::vec3 at{random.range(-0.28f, 0.28f), low + t + 0.01f, random.range(-0.28f, 0.28f)};
    const glm::vec3 half{random.range(0.03f, 0.06f), random.range(0.02f, 0.05f), random.range(0.03f, 0.06f)};
    chamferBox(embers, at - half + glm::vec3(0, half.y, 0), at + half + glm::vec3(0, half.y, 0), 0.012f);
  }
  const float yaw = -0.55f;  // the door looks into the room
  level.node("stove", level.mesh("stove", {m.rust.finish(iron), m.rustyBars.finish(bars), embers.finish(m.embers)}),
             kStove, yaw);
  level.point("embers", kStove + glm::vec3(0, kEmbers, 0), {1.0f, 0.26f, 0.06f}, 42.0f, 9.0f);
  MeshBuilder hearth;
  chamferBox(hearth, {-0.85f, -0.05f, -0.8f}, {0.85f, 0.09f, 0.95f}, 0.02f, Mapping::kUpright);
  level.node("hearth", level.mesh("hearth", {m.brick.finish(hearth)}), kStove, yaw);
}

}  // namespace tyndall::levels::cage
