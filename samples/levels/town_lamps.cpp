// The lamps: on brackets, shining down, and the caged lantern that swings over the street, shining all ways.
#include <glm/gtc/constants.hpp>

#include "shapes.hpp"
#include "town_parts.hpp"

namespace tyndall::levels::town {
namespace {

constexpr float kArm = 0.95f;  // from the face to the lamp

/// Lamp and bracket; the light is at the origin, the face behind it at z = -kArm.
std::int32_t bracketMesh(LevelBuilder& level, const Materials& m) {
  MeshBuilder iron, glass, bulb;
  lathe(iron,
        {{0.20f, 0.06f},
         {0.205f, 0.06f},
         {0.205f, 0.06f},
         {0.205f, 0.085f},
         {0.205f, 0.085f},
         {0.08f, 0.22f},
         {0.05f, 0.26f},
         {0.06f, 0.29f},
         {0.02f, 0.34f},
         {0.005f, 0.42f}},
        20);
  lathe(iron, {{0.02f, 0.07f}, {0.2f, 0.062f}}, 20);  // its underside
  lathe(iron, {{0.005f, -0.42f}, {0.04f, -0.38f}, {0.10f, -0.34f}, {0.10f, -0.34f}, {0.09f, -0.32f}, {0.01f, -0.32f}},
        16);
  for (int i = 0; i < 6; ++i) {
    const float angle = glm::pi<float>() * (real(i) + 0.5f) / 3.0f;
    const glm::vec3 out{glm::cos(angle), 0, glm::sin(angle)};
    tube(iron, {0.095f * out - glm::vec3(0, 0.33f, 0), 0.18f * out + glm::vec3(0, 0.06f, 0)}, {0.010f, 0.010f}, 5);
  }
  lathe(glass, {{0.09f, -0.32f}, {0.17f, 0.06f}}, 12);
  lathe(bulb, {{0.004f, -0.05f}, {0.04f, -0.03f}, {0.055f, 0.0f}, {0.04f, 0.04f}, {0.03f, 0.07f}}, 12);
  std::vector<glm::vec3> arm;
  for (int i = 0; i <= 12; ++i) {
    const float t = real(i) / 12.0f;
    arm.emplace_back(0, 0.42f + 0.25f * glm::sin(glm::pi<float>() * t) - 0.45f * t * t, -kArm * t);
  }
  tube(iron, arm, std::vector<float>(arm.size(), 0.02f), 8, true);
  tube(iron, {{0, -0.30f, -kArm}, {0, 0.05f, -0.8f * kArm}, {0, 0.5f, -0.55f * kArm}}, {0.013f, 0.013f, 0.013f}, 6,
       true);
  chamferBox(iron, {-0.06f, -0.4f, -kArm - 0.02f}, {0.06f, 0.15f, -kArm + 0.03f}, 0.01f);
  return level.mesh("lamp", {iron.finish(m.iron), bulb.finish(m.bulb), glass.finish(m.lampGlass)});
}

void addLantern(LevelBuilder& level, const Materials& m) {
  MeshBuilder iron, glass, bulb;
  constexpr float w = 0.19f, top = 0.26f, low = -0.28f;
  chain(iron, kLanternDrop - 0.52f, 0.08f, 0.008f);
  iron.frame = glass.frame = bulb.frame = placed({0, -kLanternDrop, 0});
  lathe(iron,
        {{0.02f, top},
         {0.26f, top},
         {0.26f, top},
         {0.26f, top + 0.03f},
         {0.26f, top + 0.03f},
         {0.1f, top + 0.16f},
         {0.04f, top + 0.2f},
         {0.04f, top + 0.27f},
         {0.005f, top + 0.28f}},
        8);
  lathe(iron,
        {{0.005f, low - 0.06f},
         {0.08f, low - 0.03f},
         {0.2f, low},
         {0.2f, low},
         {0.19f, low + 0.02f},
         {0.005f, low + 0.02f}},
        8);
  for (int i = 0; i < 8; ++i) {
    const float angle = glm::pi<float>() * (real(i) + 0.5f) / 4.0f, c = w * glm::cos(angle), s = w * glm::sin(angle);
    tube(iron, {{c, low, s}, {1.2f * c, top, 1.2f * s}}, {0.011f, 0.011f}, 5);
    const float next = angle + glm::pi<float>() / 4.0f;
    for (const float y : {-0.12f, 0.1f}) {
      const float r = glm::mix(1.0f, 1.2f, (y - low) / (top - low));
      tube(iron, {{r * c, y, r * s}, {r * w * glm::cos(next), y, r * w * glm::sin(next)}}, {0.009f, 0.009f}, 5);
    }
  }
  lathe(glass, {{0.17f, low}, {0.21f, top}}, 8);
  lathe(bulb, {{0.004f, -0.07f}, {0.04f, -0.05f}, {0.055f, 0.0f}, {0.03f, 0.06f}, {0.004f, 0.1f}}, 12);
  scene::Node n;
  n.name = "lantern";
  n.translation = kLanternHook;
  n.mesh = level.mesh("lantern", {iron.finish(m.iron), bulb.finish(m.bulb), glass.finish(m.lampGlass)});
  const std::int32_t lantern = level.node(n);
  level.point("lantern light", {0, -kLanternDrop, 0}, {1.0f, 0.66f, 0.34f}, 62.0f, 12.0f, lantern);
  level.animateSwing(lantern, glm::normalize(glm::vec3(1.0f, 0, 0.4f)), 0, 0.14f, 4.0f, 6);
}

}  // namespace

void addLamps(LevelBuilder& level, const Materials& m) {
  const std::int32_t mesh = bracketMesh(level, m);
  struct Place {
    float side, z, y, forward;
  };
  // Above the laths, and beside the balconies.
  for (const Place& p :
       {Place{1, 2.2f, 4.0f, -0.1f}, {-1, -3.6f, 4.0f, -0.1f}, {1, -11.0f, 3.9f, 0.0f}, {-1, -16.2f, 3.9f, 0.0f}}) {
    const glm::mat4 at = facing(p.side, p.z, p.forward) * placed({0, p.y, kArm});
    level.node("lamp", mesh, glm::vec3(at[3]), -p.side * glm::half_pi<float>());
    const glm::vec3 light(at * glm::vec4(0, -0.02f, 0, 1)), aim(at * glm::vec4(0, -3.0f, 0.7f, 1));
    level.spot("lamp light", light, aim, {1.0f, 0.72f, 0.40f}, 95.0f, 46.0f, 60.0f, 8.5f);
  }
  addLantern(level, m);
}

}  // namespace tyndall::levels::town
