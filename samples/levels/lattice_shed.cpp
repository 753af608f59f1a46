// The shed: slabs that overlap at every seam; the sunny end with its fence, louvres and fans; girders below the roof.
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "lattice_parts.hpp"
#include "shapes.hpp"
#include "wall.hpp"

namespace tyndall::levels::lattice {
namespace {

constexpr float kThick = 0.25f;
constexpr float kEnd = -kHalfLength;

float bayX(int bay) { return kBay * (real(bay) - 2.0f); }

void addLouvres(MeshBuilder& iron, float x, float half, float low, float high) {
  for (float y = low + 0.12f; y < high; y += 0.21f)
    beam(iron, {x - half, y, kEnd - 0.12f}, {x + half, y, kEnd - 0.12f}, 0.2f, 0.02f, 0,
         glm::normalize(glm::vec3(0, 1, 0.75f)));
  chamferBox(iron, {x - 0.04f, low, kEnd - 0.2f}, {x + 0.04f, high, kEnd - 0.04f}, 0);
}

}  // namespace

void addShed(LevelBuilder& level, const Materials& m) {
  MeshBuilder walls, floor, roof, reveal, iron, wood, yard;
  const float x = kHalfWidth, z = kHalfLength, t = kThick, high = kCeiling + 0.2f;
  for (const float side : {-1.0f, 1.0f}) {
    const float x0 = side < 0 ? -x - t : x;
    chamferBox(walls, {x0, -0.3f, -z - t}, {x0 + t, high, z + t}, 0, Mapping::kUpright);
    for (float at = -z; at <= z; at += 3.0f)
      beam(iron, {side * (x - 0.09f), 0, at}, {side * (x - 0.09f), high, at}, 0.16f, 0.2f, 0.01f, {0, 0, 1});
  }
  chamferBox(walls, {-x - t, -0.3f, z}, {x + t, high, z + t}, 0, Mapping::kUpright);
  chamferBox(floor, {-x - 0.2f, -0.4f, -z - 0.6f}, {x + 0.2f, 0, z + 0.2f}, 0, Mapping::kUpright);
  chamferBox(yard, {-60, -0.6f, -70}, {60, -0.05f, -z - 0.6f}, 0, Mapping::kUpright);
  chamferBox(roof, {-x - 0.4f, kCeiling, -z - 0.5f}, {x + 0.4f, kCeiling + 0.12f, z + 0.4f}, 0, Mapping::kUpright);
  for (int bay = 0; bay < 5; ++bay) {
    const WallShape shape{
        .halfWidth = 0.5f * kBay, .bottom = kFenceTop, .topMiddle = high, .topEnds = high, .thickness = t};
    walls.frame = reveal.frame = placed({bayX(bay), 0, kEnd});
    if (bay % 2 == 1) {
      wall(walls, reveal, shape, circle(kFanRadius, kFanY, 14), circle(kFanRadius, kFanY, 14));
    } else {
      const Outline hole{{-1.3f, 4.55f, 6.3f}, {1.3f, 4.55f, 6.3f}};
      wall(walls, reveal, shape, hole, hole);
      addLouvres(iron, bayX(bay), 1.3f, 4.55f, 6.3f);
    }
  }
  walls.frame = glm::mat4(1);
  for (const int bay : {0})
    chamferBox(walls, {bayX(bay) - 0.5f * kBay, -0.2f, kEnd - t}, {bayX(bay) + 0.5f * kBay, kFenceTop + 0.1f, kEnd}, 0,
               Mapping::kUpright);
  for (int i = 0; i <= 5; ++i) {
    const float at = kBay * (real(i) - 2.5f);
    beam(iron, {at, 0, kEnd + 0.06f}, {at, high, kEnd + 0.06f}, 0.18f, 0.2f, 0.01f, {0, 0, 1});
  }
  for (const float y : {kFenceTop, kCeiling - 0.15f})
    beam(iron, {-x, y, kEnd + 0.03f}, {x, y, kEnd + 0.03f}, 0.2f, 0.16f, 0.01f);
  // A gate of boards with gaps, half open.
  for (float s = 0.05f; s < 2.0f; s += 0.165f)
    chamferBox(wood, {bayX(3) - 1.7f + s, 0.12f, kEnd + 0.1f}, {bayX(3) - 1.6f + s, 3.3f, kEnd + 0.14f}, 0.006f);
  for (const float y : {0.5f, 2.8f})
    beam(wood, {bayX(3) - 1.75f, y, kEnd + 0.17f}, {bayX(3) + 0.4f, y, kEnd + 0.17f}, 0.06f, 0.14f, 0.01f);
  beam(wood, {bayX(3) - 1.65f, 0.55f, kEnd + 0.17f}, {bayX(3) + 0.3f, 2.75f, kEnd + 0.17f}, 0.05f, 0.12f, 0.01f);
  level.single("shell", {m.sheet.finish(walls), m.sheet.finish(reveal), m.roof.finish(roof)});
  level.single("floor", {m.concrete.finish(floor)});
  level.single("yard", {m.concrete.finish(yard)});
  level.single("frame", {m.rust.finish(iron), m.timber.finish(wood)});
}

void addFans(LevelBuilder& level, const Materials& m) {
  MeshBuilder wheel, stand;
  for (int blade = 0; blade < 5; ++blade) {
    wheel.frame = glm::rotate(glm::mat4(1), 2.0f * glm::pi<float>() * real(blade) / 5.0f, glm::vec3(0, 0, 1));
    for (const bool front : {true, false}) {
      surface(wheel, 8, 6, {0.9f, 0.5f}, [&](float u, float v) {
        const float r = glm::mix(0.14f, kFanRadius - 0.08f, u), turn = 0.34f * (front ? 2 * v - 1 : 1 - 2 * v);
        return glm::vec3(r * glm::cos(turn), r * glm::sin(turn), 0.45f * r * turn + (front ? 0.004f : -0.004f));
      });
    }
  }
  wheel.frame = glm::rotate(glm::mat4(1), glm::half_pi<float>(), glm::vec3(1, 0, 0));
  lathe(wheel, {{0.01f, -0.12f}, {0.12f, -0.10f}, {0.16f, 0}, {0.16f, 0.1f}, {0.01f, 0.12f}}, 16);
  for (const float r : {0.35f, 0.7f, kFanRadius})
    bar(stand, ringPath(r, {0, 0}, 36, 0.2f), {0, 0, 1}, r < 1 ? 0.014f : 0.06f, r < 1 ? 0.014f : 0.08f, true);
  for (int i = 0; i < 4; ++i) {
    const float angle = glm::pi<float>() * (real(i) + 0.5f) / 4.0f;
    const glm::vec3 out{kFanRadius * glm::cos(angle), kFanRadius * glm::sin(angle), 0.2f};
    tube(stand, {out, {-out.x, -out.y, 0.2f}}, {0.016f, 0.016f}, 6);
  }
  const std::int32_t wheelMesh = level.mesh("fan", {m.rust.finish(wheel)}),
                     standMesh = level.mesh("fan guard", {stand.finish(m.iron)});
  for (const int bay : {1, 3}) {
    const glm::vec3 hub(bayX(bay), kFanY, kEnd - 0.1f);
    const std::int32_t node = level.node("fan", wheelMesh, hub);
    level.animateSpin(node, {0, 0, bay == 1 ? 1.0f : -1.0f}, bay == 1 ? 3 : 1, 24.0f);
    level.node("fan guard", standMesh, hub);
  }
}

void girder(MeshBuilder& b, const glm::vec3& from, const glm::vec3& to, float depth, float thick, int panels,
            const glm::vec3& up) {
  const glm::vec3 half = 0.5f * depth * up;
  const auto piece = [&](const glm::vec3& a, const glm::vec3& c, float width) {
    beam(b, a, c, width, width, 0, glm::abs(up.y) > 0.9f ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0));
  };
  piece(from + half, to + half, thick);
  piece(from - half, to - half, thick);
  for (int i = 0; i < panels; ++i) {
    const glm::vec3 a = glm::mix(from, to, real(i) / real(panels)), c = glm::mix(from, to, real(i + 1) / real(panels));
    const float side = i % 2 == 0 ? 1.0f : -1.0f;
    piece(a - side * half, c + side * half, 0.6f * thick);
    piece(c + half, c - half, 0.6f * thick);
  }
}

void addGirders(LevelBuilder& level, const Materials& m) {
  MeshBuilder iron;
  for (const float z : {-9.0f, -6.0f, -3.0f, 0.0f, 3.0f, 6.0f, 9.0f})
    girder(iron, {-kHalfWidth, kCeiling - 0.55f, z}, {kHalfWidth, kCeiling - 0.55f, z}, 0.8f, 0.1f, 18);
  for (const float x : {-4.6f, 0.0f, 4.6f})
    girder(iron, {x, kCeiling - 0.5f, -kHalfLength}, {x, kCeiling - 0.5f, kHalfLength}, 0.6f, 0.08f, 24);
  level.single("girders", {m.rust.finish(iron)});
}

}  // namespace tyndall::levels::lattice
