// The lattice tower with its gratings and lamp, and the stairs of grating to the landing.
#include <glm/gtc/constants.hpp>

#include "lattice_parts.hpp"
#include "shapes.hpp"

namespace tyndall::levels::lattice {

void grating(MeshBuilder& b, const glm::vec2& min, const glm::vec2& max, float y, float pitch) {
  for (float z = min.y + 0.5f * pitch; z < max.y; z += pitch)
    chamferBox(b, {min.x, y - 0.03f, z - 0.008f}, {max.x, y, z + 0.008f}, 0);
  for (float x = min.x + 1.5f * pitch; x < max.x; x += 3.0f * pitch)
    chamferBox(b, {x - 0.006f, y - 0.022f, min.y}, {x + 0.006f, y - 0.004f, max.y}, 0);
  for (const float x : {min.x, max.x}) chamferBox(b, {x - 0.02f, y - 0.07f, min.y}, {x + 0.02f, y + 0.01f, max.y}, 0);
  for (const float z : {min.y, max.y}) chamferBox(b, {min.x, y - 0.07f, z - 0.02f}, {max.x, y + 0.01f, z + 0.02f}, 0);
}

void addTower(LevelBuilder& level, const Materials& m) {
  MeshBuilder iron, deck, bulb, glass, hood;
  constexpr float h = kTowerHalf, kStep = 1.15f;
  iron.frame = deck.frame = placed(kTower);
  for (const float x : {-h, h})
    for (const float z : {-h, h}) beam(iron, {x, 0, z}, {x, kCeiling + 0.05f, z}, 0.12f, 0.12f, 0.01f, {0, 0, 1});
  for (int i = 0; i < 6; ++i) {
    const float y = kStep * real(i), top = glm::min(y + kStep, kCeiling);
    for (const float side : {-h, h}) {
      if (i > 0) beam(iron, {-h, y, side}, {h, y, side}, 0.06f, 0.06f, 0);
      if (i > 0) beam(iron, {side, y, -h}, {side, y, h}, 0.06f, 0.06f, 0);
      if (i == 0 && side > 0) continue;  // the way in
      beam(iron, {-h, y, side}, {h, top, side}, 0.04f, 0.04f, 0, {0, 0, 1});
      beam(iron, {h, y, side}, {-h, top, side}, 0.04f, 0.04f, 0, {0, 0, 1});
      beam(iron, {side, y, -h}, {side, top, h}, 0.04f, 0.04f, 0, {1, 0, 0});
      beam(iron, {side, y, h}, {side, top, -h}, 0.04f, 0.04f, 0, {1, 0, 0});
    }
  }
  grating(deck, {-h, -h}, {h, 0.15f}, 3.45f, 0.075f);  // with a hatch beside it, where the ladder comes up
  grating(deck, {-0.3f, 0.15f}, {h, h}, 3.45f, 0.075f);
  iron.frame = placed(kTower + glm::vec3(-0.65f, 0, 0.75f));
  ladder(iron, 4.4f);
  level.single("tower", {m.rust.finish(iron), deck.finish(m.galvanised)});
  // The lamp hangs from the roof on a cable, in a wire guard.
  hood.frame = bulb.frame = glass.frame = placed(kTowerLamp);
  lathe(hood, {{0.30f, 0.10f}, {0.305f, 0.10f}, {0.26f, 0.18f}, {0.10f, 0.26f}, {0.06f, 0.36f}, {0.01f, 0.38f}}, 20);
  lathe(hood, {{0.02f, 0.14f}, {0.30f, 0.105f}}, 20);
  tube(hood, {{0, 0.37f, 0}, {0, kCeiling - kTowerLamp.y, 0}}, {0.012f, 0.012f}, 6);
  for (int i = 0; i < 8; ++i) {
    const float angle = glm::pi<float>() * real(i) / 4.0f, c = glm::cos(angle), s = glm::sin(angle);
    tube(hood, {{0.2f * c, 0.12f, 0.2f * s}, {0.2f * c, -0.08f, 0.2f * s}, {0.1f * c, -0.2f, 0.1f * s}, {0, -0.23f, 0}},
         {0.006f, 0.006f, 0.006f, 0.006f}, 5);
  }
  lathe(bulb, {{0.004f, -0.10f}, {0.05f, -0.07f}, {0.07f, 0.0f}, {0.04f, 0.09f}, {0.03f, 0.13f}}, 14);
  level.single("tower lamp", {hood.finish(m.iron), bulb.finish(m.bulb)});
  level.point("tower lamp", kTowerLamp, {0.78f, 0.90f, 1.0f}, 110.0f, 9.0f);
}

void addStairs(LevelBuilder& level, const Materials& m) {
  MeshBuilder steel, tread, rail;
  constexpr float x0 = -8.6f, x1 = -7.4f, kTop = 3.0f, kFoot = 7.6f, kHead = 2.6f;
  constexpr int kSteps = 15;
  for (int i = 0; i < kSteps; ++i) {
    const float t = (real(i) + 1) / kSteps, z = glm::mix(kFoot, kHead, t);
    grating(tread, {x0, z - 0.02f}, {x1, z + 0.28f}, kTop * t, 0.05f);
  }
  for (const float x : {x0 - 0.04f, x1 + 0.04f})
    beam(steel, {x, 0, kFoot + 0.2f}, {x, kTop, kHead + 0.1f}, 0.05f, 0.26f, 0.006f);
  grating(tread, {x0, -2.4f}, {x1 + 1.0f, kHead}, kTop, 0.075f);
  for (const glm::vec2 at : {glm::vec2(x1 + 0.95f, -2.3f), {x1 + 0.95f, kHead - 0.1f}, {x0, -2.3f}, {x0, kHead}})
    beam(steel, {at.x, 0, at.y}, {at.x, kTop, at.y}, 0.1f, 0.1f, 0.01f, {0, 0, 1});
  const auto railing = [&](const glm::vec3& from, const glm::vec3& to, int posts) {
    for (const float y : {1.0f, 0.55f})
      tube(rail, {from + glm::vec3(0, y, 0), to + glm::vec3(0, y, 0)}, {0.022f, 0.022f}, 8, true);
    for (int i = 0; i <= posts; ++i) {
      const glm::vec3 p = glm::mix(from, to, real(i) / real(posts));
      tube(rail, {p, p + glm::vec3(0, 1.0f, 0)}, {0.02f, 0.02f}, 6);
    }
  };
  railing({x1 + 0.04f, 0.1f, kFoot}, {x1 + 0.04f, kTop, kHead}, 5);
  railing({x1 + 0.98f, kTop, kHead}, {x1 + 0.98f, kTop, -2.4f}, 5);
  railing({x0, kTop, -2.4f}, {x1 + 0.98f, kTop, -2.4f}, 2);
  level.single("stairs", {m.rust.finish(steel), tread.finish(m.galvanised), rail.finish(m.yellow)});
}

}  // namespace tyndall::levels::lattice
