// Gabled houses with timber frames about the square.
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "hall_textures.hpp"
#include "props.hpp"
#include "shapes.hpp"
#include "tower_parts.hpp"

namespace tyndall::levels::tower {
namespace {

struct Measures {
  float half, depth, eaves, rise;  // half its width; behind the front at z = 0
  int windows;                     // across the front
};

/// Both slopes of a roof along z, 20 cm thick.
void roof(MeshBuilder& slate, const Measures& h) {
  const float slope = glm::atan(h.rise, h.half), length = h.half / glm::cos(slope) + 0.5f;
  const glm::mat4 before = slate.frame;
  for (const float side : {-1.0f, 1.0f}) {
    // u level, v down the slope: the box's -z is turned to the side and down.
    slate.frame = before * glm::translate(glm::mat4(1), {0, h.eaves + h.rise + 0.12f, -0.5f * h.depth}) *
                  glm::rotate(glm::mat4(1), -side * glm::half_pi<float>(), glm::vec3(0, 1, 0)) *
                  glm::rotate(glm::mat4(1), -slope, glm::vec3(1, 0, 0));
    const float reach = 0.5f * h.depth + 0.45f;
    chamferBox(slate, {-reach, -0.2f, -length}, {reach, 0, 0.06f}, 0.0f, Mapping::kUpright);
  }
  slate.frame = before;
}

void frame(MeshBuilder& wood, const Measures& h) {
  const auto piece = [&](const glm::vec3& a, const glm::vec3& c, float size) {
    beam(wood, a, c, size, 0.14f, 0.015f, {0, 0, 1});
  };
  const float z = 0.02f;
  const int posts = 2 * h.windows + 1;
  for (int i = 0; i < posts; ++i) {
    const float x = glm::mix(-h.half + 0.09f, h.half - 0.09f, real(i) / real(posts - 1));
    piece({x, 0.3f, z}, {x, h.eaves, z}, 0.17f);
  }
  for (const float y : {0.35f, 2.55f, h.eaves - 0.08f}) piece({-h.half, y, z}, {h.half, y, z}, 0.19f);
  for (const float s : {-1.0f, 1.0f}) {
    piece({s * h.half, h.eaves, z}, {0, h.eaves + h.rise - 0.1f, z}, 0.17f);
    piece({s * (h.half - 0.1f), 2.65f, z}, {s * (h.half - 1.0f), h.eaves - 0.15f, z}, 0.15f);
    piece({s * 0.5f * h.half, h.eaves, z}, {s * 0.5f * h.half, h.eaves + 0.5f * h.rise - 0.1f, z}, 0.15f);
  }
  piece({0, h.eaves, z}, {0, h.eaves + h.rise - 0.2f, z}, 0.16f);
}

void openings(MeshBuilder& wood, MeshBuilder& glow, MeshBuilder& dark, const Measures& h, Random& random) {
  const float bay = 2 * (h.half - 0.09f) / real(h.windows);
  for (int storey = 0; storey < 2; ++storey) {
    for (int i = 0; i < h.windows; ++i) {
      const float x = -h.half + 0.09f + bay * (real(i) + 0.25f), y = storey == 0 ? 1.1f : 3.3f;
      const bool door = storey == 0 && i == h.windows / 2;
      const float w = 0.42f, top = door ? 2.3f : y + 1.05f, low = door ? 0.1f : y;
      MeshBuilder& pane = door ? wood : random.unit() < 0.45f ? glow : dark;
      chamferBox(pane, {x - w, low, -0.1f}, {x + w, top, 0.03f}, 0.0f);
      if (door) continue;
      for (const float s : {-1.0f, 0.0f, 1.0f})
        chamferBox(wood, {x + s * w - 0.04f, low, -0.1f}, {x + s * w + 0.04f, top, 0.07f}, 0.0f);
      for (const float yy : {low, 0.5f * (low + top), top})
        chamferBox(wood, {x - w - 0.06f, yy - 0.035f, -0.1f}, {x + w + 0.06f, yy + 0.035f, 0.08f}, 0.0f);
    }
  }
}

std::int32_t houseMesh(LevelBuilder& level, const Materials& m, const Measures& h, std::uint64_t seed) {
  MeshBuilder walls, wood, slate, glow, dark, stone;
  Random random(seed);
  chamferBox(walls, {-h.half, -0.5f, -h.depth}, {h.half, h.eaves, 0}, 0.0f, Mapping::kUpright);
  for (const float z : {0.0f, -h.depth}) {
    std::vector<glm::vec3> gable{{-h.half, h.eaves - 0.05f, z}, {h.half, h.eaves - 0.05f, z}, {0, h.eaves + h.rise, z}};
    if (z < 0) std::swap(gable[0], gable[1]);
    walls.flatPolygon(gable, {{gable[0].x, -h.eaves}, {gable[1].x, -h.eaves}, {0, -h.eaves - h.rise}});
  }
  roof(slate, h);
  frame(wood, h);
  openings(wood, glow, dark, h, random);
  chamferBox(stone, {-h.half - 0.06f, -0.5f, -h.depth - 0.06f}, {h.half + 0.06f, 0.4f, 0.06f}, 0.03f,
             Mapping::kUpright);
  const float x = random.range(-0.4f, 0.4f) * h.half, z = -h.depth * random.range(0.4f, 0.8f), ridge = h.eaves + h.rise;
  chamferBox(stone, {x - 0.45f, h.eaves, z - 0.4f}, {x + 0.45f, ridge + 1.3f, z + 0.4f}, 0.03f, Mapping::kUpright);
  chamferBox(stone, {x - 0.55f, ridge + 1.2f, z - 0.5f}, {x + 0.55f, ridge + 1.38f, z + 0.5f}, 0.03f,
             Mapping::kUpright);
  for (const float pot : {x - 0.2f, x + 0.2f}) {
    stone.frame = placed({pot, ridge + 1.3f, z});
    lathe(stone, {{0.13f, 0}, {0.11f, 0.5f}, {0.11f, 0.5f}, {0.06f, 0.5f}}, 8);
  }
  return level.mesh("house", {walls.finish(m.plaster, kPlasterTile), wood.finish(m.timber, hall::kWoodTile),
                              slate.finish(m.slates, kSlateTile), glow.finish(m.glow), dark.finish(m.iron),
                              stone.finish(m.dressed, hall::kPillarTile)});
}

}  // namespace

void addHouses(LevelBuilder& level, const Materials& m) {
  const std::int32_t houses[] = {
      houseMesh(level, m, {3.6f, 9.0f, 5.0f, 3.8f, 3}, 1), houseMesh(level, m, {4.4f, 10.0f, 5.3f, 4.4f, 4}, 2),
      houseMesh(level, m, {3.0f, 8.0f, 4.9f, 3.6f, 2}, 3), houseMesh(level, m, {3.9f, 9.0f, 5.6f, 4.8f, 3}, 4)};
  const auto put = [&](int kind, float x, float z, float degrees) {
    level.node("house", houses[kind], {x, groundY(x, z) - 0.05f, z}, glm::radians(degrees));
  };
  // Rows along both sides of the square, fronts towards it; more behind, for the roofs' line.
  put(0, -12.5f, 18.0f, 96), put(1, -13.0f, 9.2f, 92), put(2, -13.4f, 1.0f, 88), put(3, -14.2f, -6.8f, 84),
      put(1, -17.0f, -16.5f, 66);
  put(1, 12.0f, 21.0f, -93), put(3, 12.4f, 12.0f, -96), put(2, 13.4f, 4.4f, -88), put(0, 14.6f, -3.4f, -80),
      put(3, 18.5f, -13.0f, -60);
  put(3, -26.0f, -24.0f, 40), put(2, 26.0f, -24.0f, -42), put(0, -13.2f, 27.5f, 88), put(2, 12.6f, 29.5f, -90);
  put(1, -8.5f, 46.0f, 170), put(0, 1.0f, 47.5f, 182), put(3, 10.0f, 45.0f, 192), put(1, -27.0f, 4.0f, 90),
      put(0, 28.0f, 8.0f, -90);
}

}  // namespace tyndall::levels::tower
