// A tower mill whose sails turn.
#include <glm/gtc/constants.hpp>

#include "hall_textures.hpp"
#include "props.hpp"
#include "shapes.hpp"
#include "terrain_parts.hpp"

namespace tyndall::levels::terrain {
namespace {

constexpr float kShaftY = 9.2f;  // of the sails' axis above the mill's foot
constexpr glm::vec2 kMill{20.0f, -41.0f};

/// One sail along +y in the plane z = 0: a stock, a lattice, and canvas over part of it, torn.
void sail(MeshBuilder& wood, MeshBuilder& canvas, float torn) {
  const float root = 1.0f, tip = 7.4f, width = 1.75f;
  beam(wood, {0, -0.2f, 0}, {0, tip + 0.1f, 0}, 0.24f, 0.2f, 0.03f, {0, 0, 1});
  for (int i = 0; i <= 12; ++i) {
    const float y = glm::mix(root, tip, real(i) / 12.0f);
    beam(wood, {-0.45f, y, 0.05f}, {width, y, 0.05f}, 0.08f, 0.08f, 0.0f, {0, 1, 0});
  }
  for (const float x : {-0.42f, 0.6f, 1.18f, width - 0.05f})
    beam(wood, {x, root, 0.08f}, {x, tip, 0.08f}, 0.08f, 0.07f, 0.0f, {0, 0, 1});
  const float cell = (tip - root) / 12.0f;
  for (int i = 0; i < 12; ++i) {
    const float y = root + cell * real(i);
    if (real(i) / 12.0f > torn) continue;
    const float out = real(i) / 12.0f > torn - 0.2f ? 1.18f : width;  // a rent edge
    chamferBox(canvas, {0.08f, y, 0.095f}, {out, y + cell + 0.001f, 0.135f}, 0.0f);
  }
}

}  // namespace

void addWindmill(LevelBuilder& level, const Materials& m) {
  MeshBuilder body, wood, stone;
  lathe(stone, {{3.1f, -2.5f}, {3.05f, 0.9f}, {3.05f, 0.9f}, {2.8f, 1.0f}}, 20);
  lathe(body, {{2.8f, 0.95f}, {2.5f, 4.0f}, {2.05f, 8.1f}, {2.05f, 8.1f}, {2.3f, 8.1f}}, 20);
  lathe(wood, {{2.3f, 8.1f}, {2.3f, 8.1f}, {2.32f, 8.5f}, {2.1f, 9.6f}, {1.5f, 10.6f}, {0.75f, 11.3f}, {0.02f, 11.6f}},
        20);
  chamferBox(wood, {-0.6f, 0.9f, 2.3f}, {0.6f, 3.1f, 2.78f}, 0.04f);  // door, windows
  for (const float y : {4.6f, 6.6f})
    chamferBox(wood, {-0.35f, y, 2.0f}, {0.35f, y + 0.8f, 2.5f - 0.09f * (y - 4)}, 0.03f);
  beam(wood, {0, kShaftY, 1.0f}, {0, kShaftY, 3.05f}, 0.4f, 0.4f, 0.05f);
  // The tail pole and its stays, behind.
  beam(wood, {0, 8.8f, -2.0f}, {0, 1.2f, -5.6f}, 0.2f, 0.2f, 0.03f);
  for (const float side : {-1.0f, 1.0f}) beam(wood, {side * 1.9f, 8.4f, -0.8f}, {0, 1.6f, -5.4f}, 0.12f, 0.12f, 0.02f);
  const Coat planks{m.planks, 2.0f};
  const std::int32_t mill = level.mesh(
      "windmill", {stone.finish(m.ashlar, hall::kAshlarTile), body.finish(m.plaster, 4.0f), planks.finish(wood)});
  // The sails face the valley, a bit across the light: their shadows are broad.
  const std::int32_t root =
      level.node("windmill", mill, onGround(kMill.x, kMill.y) - glm::vec3(0, 0.3f, 0), -glm::half_pi<float>() + 0.5f);
  MeshBuilder lattice, canvas;
  for (int i = 0; i < 4; ++i) {
    lattice.frame = canvas.frame =
        glm::mat4_cast(glm::angleAxis(glm::half_pi<float>() * real(i) + 0.3f, glm::vec3(0, 0, 1)));
    sail(lattice, canvas, i == 1 ? 0.45f : i == 3 ? 0.75f : 1.0f);
  }
  lattice.frame = glm::mat4(1);
  chamferBox(lattice, {-0.4f, -0.4f, -0.25f}, {0.4f, 0.4f, 0.3f}, 0.08f);
  const std::int32_t sails =
      level.node("sails", level.mesh("sails", {planks.finish(lattice), canvas.finish(m.canvas, 2.0f)}),
                 {0, kShaftY, 3.1f}, 0, 1, root);
  level.animateSpin(sails, {0, 0, 1}, 3, 24.0f);
}

}  // namespace tyndall::levels::terrain
