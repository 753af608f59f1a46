// The open roof: trusses, purlins, rafters.
#include <glm/gtc/constants.hpp>

#include "hall_parts.hpp"
#include "hall_textures.hpp"
#include "shapes.hpp"

namespace tyndall::levels::hall {
namespace {

/// A quarter of an ellipse from `from` (leaves upwards) to `to` (arrives level): a curved brace.
std::vector<glm::vec3> bracePath(const glm::vec3& from, const glm::vec3& to) {
  std::vector<glm::vec3> path;
  for (int i = 0; i <= 8; ++i) {
    const float angle = glm::half_pi<float>() * real(i) / 8.0f;
    const float out = 1.0f - glm::cos(angle), up = glm::sin(angle);
    path.emplace_back(glm::mix(from.x, to.x, out), glm::mix(from.y, to.y, up), glm::mix(from.z, to.z, out));
  }
  return path;
}

std::int32_t trussMesh(LevelBuilder& level, const Materials& m) {
  MeshBuilder wood;
  Random random(71);
  const auto piece = [&](const glm::vec3& from, const glm::vec3& to, float width, float height) {
    wood.uvOffset = {random.unit() * 2, random.unit() * 2};
    wood.color = glm::vec4(glm::vec3(random.range(0.75f, 1.1f)), 1);
    beam(wood, from, to, width, height, 0.03f,
         glm::abs(glm::normalize(to - from).y) > 0.9f ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0));
  };
  piece({-kHalfWidth - 0.2f, kTieY, 0}, {kHalfWidth + 0.2f, kTieY, 0}, 0.34f, 0.42f);
  piece({0, kTieY, 0}, {0, kRidge - 0.1f, 0}, 0.28f, 0.28f);
  for (const float side : {-1.0f, 1.0f}) {
    piece({side * 7.2f, roofY(7.2f) - 0.14f, 0}, {0, kRidge - 0.14f, 0}, 0.3f, 0.32f);
    piece({side * kPillarX, 6.7f, 0}, {side * kPillarX, roofY(kPillarX) - 0.1f, 0}, 0.32f, 0.32f);
    piece({side * 0.1f, kTieY + 0.9f, 0}, {side * 2.2f, roofY(2.2f) - 0.25f, 0}, 0.2f, 0.2f);
    bar(wood, bracePath({side * (kPillarX - 0.12f), 6.9f, 0}, {side * 1.5f, kTieY - 0.16f, 0}), {0, 0, 1}, 0.24f,
        0.18f);
    bar(wood, bracePath({side * (kPillarX + 0.12f), 6.9f, 0}, {side * 6.2f, kTieY - 0.16f, 0}), {0, 0, 1}, 0.22f,
        0.18f);
    for (const float along : {-1.0f, 1.0f}) {
      bar(wood,
          bracePath({side * kPillarX, 8.2f, along * 0.12f}, {side * kPillarX, roofY(kPillarX) - 0.32f, along * 1.7f}),
          {1, 0, 0}, 0.2f, 0.16f);
    }
  }
  return level.mesh("truss", {wood.finish(m.timber, kWoodTile)});
}

}  // namespace

void addTimber(LevelBuilder& level, const Materials& m) {
  const std::int32_t truss = trussMesh(level, m);
  for (int i = 1; i < kBays; ++i) level.node("truss", truss, {0, 0, -kHalfLength + kBay * real(i)});
  MeshBuilder wood;
  Random random(72);
  const auto piece = [&](const glm::vec3& from, const glm::vec3& to, float width, float height, float chamfer) {
    wood.uvOffset = {random.unit() * 2, random.unit() * 2};
    wood.color = glm::vec4(glm::vec3(random.range(0.7f, 1.05f)), 1);
    beam(wood, from, to, width, height, chamfer);
  };
  const float end = kHalfLength + 0.2f;
  for (const float x : {-kPillarX, -2.0f, 0.0f, 2.0f, kPillarX}) {
    const float size = glm::abs(x) == 2.0f ? 0.2f : 0.3f;
    piece({x, roofY(x) - 0.16f, -end}, {x, roofY(x) - 0.16f, end}, size, size, 0.03f);
  }
  for (int i = -19; i <= 19; ++i) {  // a rafter a metre on both slopes
    for (const float side : {-1.0f, 1.0f})
      piece({side * 7.2f, roofY(7.2f) - 0.03f, real(i)}, {0, kRidge - 0.03f, real(i)}, 0.12f, 0.16f, 0);
  }
  level.single("purlins and rafters", {wood.finish(m.darkTimber, kWoodTile)});
}

}  // namespace tyndall::levels::hall
