// What stands in the well's light: the grating, some of its bars bent or gone, a turning fan, a swinging chain.
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "shapes.hpp"
#include "vault_parts.hpp"

namespace tyndall::levels::vault {
namespace {

void addBars(LevelBuilder& level, const Materials& m) {
  constexpr float kPitch = 0.2f, kRadius = 0.021f, kFlat = 0.03f;
  const float h = kWellHalf + 0.05f;
  MeshBuilder iron;
  iron.frame = placed({0, kGratingY, kWellZ});
  const glm::vec3 none{0};
  for (int i = -4; i <= 4; ++i) {
    const float at = kPitch * real(i);
    // Someone has been through here: two bars are gone, their neighbours pushed aside.
    if (i != 1)
      bentRod(iron, {at, 0, -h}, {at, 0, h}, kRadius,
              i == 2    ? glm::vec3(0.11f, -0.09f, 0)
              : i == 0  ? glm::vec3(-0.07f, -0.05f, 0)
              : i == -3 ? glm::vec3(0.02f, 0.06f, 0)
                        : none);
    if (i != -1)
      bentRod(iron, {-h, kFlat, at}, {h, kFlat, at}, kRadius,
              i == -2  ? glm::vec3(0, -0.10f, -0.08f)
              : i == 3 ? glm::vec3(0, 0.05f, 0.03f)
                       : none);
  }
  // The stub that is left of one of them.
  bentRod(iron, {kPitch, 0, -h}, {kPitch + 0.05f, -0.16f, -h + 0.34f}, kRadius, {0, 0.03f, 0});
  for (const float side : {-1.0f, 1.0f}) {  // the frame
    beam(iron, {side * (kWellHalf - 0.03f), 0, -h}, {side * (kWellHalf - 0.03f), 0, h}, 0.07f, 0.09f, 0.01f);
    beam(iron, {-h, 0, side * (kWellHalf - 0.03f)}, {h, 0, side * (kWellHalf - 0.03f)}, 0.07f, 0.09f, 0.01f);
  }
  level.single("grating", {m.rustyBars.finish(iron)});
}

void addFan(LevelBuilder& level, const Materials& m) {
  // The hub stands on the light's axis, or the cone would only meet one side of the wheel.
  const glm::vec3 axis = (kWellAim - kWellLamp) / (kWellAim.y - kWellLamp.y);
  const glm::vec3 hub = kWellLamp + axis * (kFanY - kWellLamp.y) + glm::vec3(0.10f, 0, -0.04f);
  MeshBuilder wheel, stand;
  constexpr int kBlades = 4;
  for (int blade = 0; blade < kBlades; ++blade) {
    const float middle = 2.0f * glm::pi<float>() * real(blade) / kBlades;
    for (const bool upper : {true, false}) {
      surface(wheel, 10, 6, {0.42f, 0.3f}, [&](float u, float v) {
        const float r = glm::mix(0.075f, 0.50f, u), wide = glm::mix(0.30f, 0.36f, u);  // radians either side
        const float turn = middle + wide * (upper ? 1.0f - 2.0f * v : 2.0f * v - 1.0f);
        const float pitch = 0.12f * r * glm::sin(turn - middle) / 0.36f;  // the blade is set against the air
        return glm::vec3(r * glm::cos(turn), pitch + (upper ? 0.003f : -0.003f), r * glm::sin(turn));
      });
    }
  }
  lathe(wheel, {{0.01f, -0.09f}, {0.06f, -0.06f}, {0.075f, 0}, {0.075f, 0.05f}, {0.075f, 0.05f}, {0.01f, 0.05f}}, 16);
  const std::int32_t node = level.node("fan", level.mesh("fan", {m.rust.finish(wheel)}), hub);
  level.animateSpin(node, {0, 1, 0}, 2, 24.0f);

  stand.frame = placed(hub);
  const float w = kWellHalf + 0.05f;
  lathe(stand, {{0.05f, 0.05f}, {0.05f, 0.2f}, {0.05f, 0.2f}, {0.01f, 0.2f}}, 12);
  beam(stand, {-w - hub.x, 0.17f, 0}, {w - hub.x, 0.17f, 0}, 0.045f, 0.06f, 0.008f);
  beam(stand, {0, 0.17f, -w - hub.z + kWellZ}, {0, 0.17f, w - hub.z + kWellZ}, 0.045f, 0.06f, 0.008f);
  level.single("fan stand", {m.rustyBars.finish(stand)});
}

void addChain(LevelBuilder& level, const Materials& m) {
  constexpr float kLength = 2.5f;
  MeshBuilder links;
  chain(links, kLength, 0.11f, 0.011f);
  std::vector<glm::vec3> hook{{0, -kLength, 0}};
  for (int i = 0; i <= 12; ++i) {
    const float angle = glm::half_pi<float>() - 1.45f * glm::pi<float>() * real(i) / 12.0f;
    hook.emplace_back(0.085f * glm::cos(angle), -kLength - 0.13f + 0.085f * glm::sin(angle), 0);
  }
  tube(links, hook, std::vector<float>(hook.size(), 0.016f), 8, true);
  const std::int32_t node = level.node("chain", level.mesh("chain", {m.rustyBars.finish(links)}),
                                       {-0.17f, kGratingY - 0.03f, kWellZ - 0.17f});
  level.animateSwing(node, glm::normalize(glm::vec3(0.5f, 0, 1.0f)), 0, 0.15f, 3.0f, 8);
}

/// A reflector above the light: the light itself hangs free below the bulb.
void addLamp(LevelBuilder& level, const Materials& m) {
  MeshBuilder shade, bulb;
  const glm::vec3 back = glm::normalize(kWellLamp - kWellAim);
  // The lamp's +Y looks back along the light.
  const glm::mat4 turn =
      glm::translate(glm::mat4(1), kWellLamp) *
      glm::mat4_cast(lookRotation(-back) * glm::angleAxis(glm::half_pi<float>(), glm::vec3(1, 0, 0)));
  shade.frame = bulb.frame = turn;
  lathe(
      shade,
      {{0.20f, 0.03f}, {0.205f, 0.03f}, {0.17f, 0.16f}, {0.09f, 0.25f}, {0.05f, 0.27f}, {0.05f, 0.36f}, {0.01f, 0.37f}},
      20);
  lathe(bulb, {{0.01f, 0.05f}, {0.19f, 0.05f}}, 20);  // a disc that looks down
  tube(shade, {{0, 0.36f, 0}, {0, 0.8f, 0}}, {0.02f, 0.02f}, 6);
  level.single("well lamp", {m.rust.finish(shade), bulb.finish(m.bulb)});
}

}  // namespace

void addGrating(LevelBuilder& level, const Materials& m) {
  addBars(level, m);
  addFan(level, m);
  addChain(level, m);
  addLamp(level, m);
}

}  // namespace tyndall::levels::vault
