// The tower's closed parts: shaft, buttresses, portal, cornice, spire; and the church behind.
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "hall_textures.hpp"
#include "props.hpp"
#include "shapes.hpp"
#include "tower_parts.hpp"
#include "wall.hpp"

namespace tyndall::levels::tower {
namespace {

constexpr float kQuarter = glm::half_pi<float>();

/// A pyramid over a regular polygon; v of the texture runs down its sides.
void pyramid(MeshBuilder& b, float radius, float y0, float y1, int sides) {
  for (int i = 0; i < sides; ++i) {
    const auto at = [&](int k) {
      const float angle = 2.0f * glm::pi<float>() * (real(k) + 0.5f) / real(sides);
      return glm::vec3(radius * glm::sin(angle), y0, radius * glm::cos(angle));
    };
    const glm::vec3 a = at(i), c = at(i + 1), tip{0, y1, 0};
    const float half = 0.5f * glm::length(c - a), high = glm::length(tip - 0.5f * (a + c));
    b.flatPolygon({a, c, tip}, {{-half, high}, {half, high}, {0, 0}});
  }
}

void buttress(MeshBuilder& b) {  // against a wall at z = 0, towards +z
  const float steps[][3] = {{-1.0f, 4.6f, 1.0f}, {4.5f, 8.0f, 0.72f}, {7.9f, 9.7f, 0.46f}};
  for (const auto& [y0, y1, reach] : steps) {
    chamferBox(b, {-0.45f, y0, -0.3f}, {0.45f, y1, reach}, 0.05f, Mapping::kUpright);
    beam(b, {0, y1 + 0.02f, reach - 0.06f}, {0, y1 + 0.34f, -0.25f}, 1.0f, 0.14f, 0.03f);
  }
}

void pinnacle(MeshBuilder& stone) {
  chamferBox(stone, {-0.3f, 15.7f, -0.3f}, {0.3f, 17.1f, 0.3f}, 0.05f, Mapping::kUpright);
  chamferBox(stone, {-0.36f, 17.05f, -0.36f}, {0.36f, 17.2f, 0.36f}, 0.04f, Mapping::kUpright);
  pyramid(stone, 0.38f, 17.2f, 18.9f, 4);
  lathe(stone, {{0.02f, 18.6f}, {0.13f, 18.75f}, {0.13f, 18.85f}, {0.02f, 19.0f}}, 8);
}

void portal(MeshBuilder& stone, MeshBuilder& wood, MeshBuilder& iron) {
  for (int ring = 0; ring < 3; ++ring) {
    std::vector<glm::vec3> path;
    const Outline arch = pointedArch(1.0f + 0.22f * real(ring), -0.2f, 1.9f, 9);
    path.emplace_back(arch.front().x, -0.2f, 0.02f);
    for (const glm::vec3& p : arch) path.emplace_back(p.x, p.z, 0.02f);
    path.emplace_back(arch.back().x, -0.2f, 0.02f);
    bar(stone, path, {0, 0, 1}, 0.24f, 0.22f + 0.22f * real(ring));
  }
  chamferBox(wood, {-0.95f, 0, -0.1f}, {0.95f, 2.9f, 0.08f}, 0.02f);
  for (const float y : {0.6f, 1.8f}) chamferBox(iron, {-0.9f, y, 0.06f}, {0.9f, y + 0.1f, 0.1f}, 0.01f);
  for (int i = 0; i < 3; ++i)
    chamferBox(stone, {-1.9f - 0.3f * real(i), -0.5f, 0},
               {1.9f + 0.3f * real(i), 0.12f - 0.13f * real(i), 0.9f + 0.4f * real(i)}, 0.03f);
}

/// A recess with louvres in a wall at z = 0.
void blindWindow(MeshBuilder& trim, MeshBuilder& wood) {
  std::vector<glm::vec3> path;
  for (const glm::vec3& p : pointedArch(0.5f, 6.6f, 8.0f, 6)) path.emplace_back(p.x, p.z, 0.0f);
  path.insert(path.begin(), {path.front().x, 6.6f, 0.0f}), path.emplace_back(path.back().x, 6.6f, 0.0f);
  bar(trim, path, {0, 0, 1}, 0.2f, 0.3f);
  for (int i = 0; i < 9; ++i)
    beam(wood, {-0.42f, 6.7f + 0.17f * real(i), 0.05f}, {0.42f, 6.7f + 0.17f * real(i), 0.05f}, 0.14f, 0.03f, 0.0f,
         {0, 1, 0.7f});
}

/// A clock with its hands at twenty to five, flat on a wall at z = 0.
void clock(MeshBuilder& dial, MeshBuilder& gold) {
  const glm::vec3 middle{0, 8.1f, 0.1f};
  std::vector<glm::vec3> disc = ringPath(1.0f, {middle.x, middle.y}, 24, 0.1f);
  std::vector<glm::vec2> uv;
  for (const glm::vec3& p : disc) uv.emplace_back(p.x, -p.y);
  dial.flatPolygon(disc, uv);
  for (const float radius : {1.0f, 0.66f})
    bar(gold, ringPath(radius, {middle.x, middle.y}, 28, 0.1f), {0, 0, 1}, radius == 1.0f ? 0.12f : 0.03f, 0.1f, true);
  const auto ray = [&](float hours, float from, float to, float width) {
    const float angle = hours * glm::pi<float>() / 6.0f;
    const glm::vec3 out{glm::sin(angle), glm::cos(angle), 0};
    bar(gold, {middle + from * out + glm::vec3(0, 0, 0.03f), middle + to * out + glm::vec3(0, 0, 0.03f)}, {0, 0, 1},
        width, 0.05f);
  };
  for (int hour = 0; hour < 12; ++hour) ray(real(hour), 0.70f, 0.90f, hour % 3 == 0 ? 0.1f : 0.06f);
  ray(4.67f, -0.12f, 0.5f, 0.08f), ray(8.0f, -0.15f, 0.82f, 0.05f);
}

void weathercock(MeshBuilder& iron) {
  tube(iron, {{0, kSpire - 0.4f, 0}, {0, kSpire + 1.9f, 0}}, {0.07f, 0.04f}, 8, true);
  lathe(iron, {{0.02f, kSpire - 0.05f}, {0.22f, kSpire + 0.12f}, {0.22f, kSpire + 0.24f}, {0.02f, kSpire + 0.4f}}, 12);
  beam(iron, {-0.55f, kSpire + 1.1f, 0}, {0.55f, kSpire + 1.1f, 0}, 0.09f, 0.09f, 0.02f);
}

}  // namespace

void addTower(LevelBuilder& level, const Materials& m) {
  MeshBuilder face, trim, wood, iron, gold, slate;
  chamferBox(face, {-kHalf, -1.0f, -kHalf}, {kHalf, kBelfry, kHalf}, 0.0f, Mapping::kUpright);
  chamferBox(trim, {-kHalf - 0.22f, -1.0f, -kHalf - 0.22f}, {kHalf + 0.22f, 0.7f, kHalf + 0.22f}, 0.1f,
             Mapping::kUpright);
  for (const float y : {5.6f, kBelfry - 0.15f, kBelfryTop - 0.1f}) {
    const float reach = kHalf + (y > 15 ? 0.32f : 0.16f);
    chamferBox(trim, {-reach, y, -reach}, {reach, y + 0.34f, reach}, 0.1f, Mapping::kUpright);
  }
  for (int side = 0; side < 4; ++side) {
    const glm::mat4 turn = glm::rotate(glm::mat4(1), kQuarter * real(side), glm::vec3(0, 1, 0));
    trim.frame = wood.frame = iron.frame = turn * placed({0, 0, kHalf});
    for (const float end : {-1.0f, 1.0f}) {
      trim.frame = turn * placed({end * (kHalf - 0.5f), 0, kHalf});
      buttress(trim);
    }
    trim.frame = turn * placed({0, 0, kHalf});
    if (side == 0) {
      iron.frame = gold.frame = turn * placed({0, 0, kHalf});
      portal(trim, wood, iron);
      clock(iron, gold);
    } else {
      blindWindow(trim, wood);
    }
    for (int i = -2; i <= 2; ++i) {
      const float x = 0.95f * real(i);
      chamferBox(trim, {x - 0.28f, 16.0f, -0.12f}, {x + 0.28f, 16.9f, 0.2f}, 0.04f, Mapping::kUpright);
    }
    chamferBox(trim, {-kHalf, 16.0f, -0.1f}, {kHalf, 16.45f, 0.18f}, 0.03f, Mapping::kUpright);
    trim.frame = turn * placed({kHalf, 0, kHalf});
    pinnacle(trim);
  }
  trim.frame = iron.frame = glm::mat4(1);
  chamferBox(trim, {-kHalf, kBelfryTop, -kHalf}, {kHalf, 16.2f, kHalf}, 0.0f, Mapping::kUpright);
  pyramid(slate, 2.45f, 16.1f, kSpire, 8);
  weathercock(iron);
  level.single("tower", {face.finish(m.ashlar, hall::kAshlarTile), trim.finish(m.dressed, hall::kPillarTile),
                         wood.finish(m.planks, 2.0f), iron.finish(m.iron), gold.finish(m.gold),
                         slate.finish(m.slates, kSlateTile)});
}

void addChurch(LevelBuilder& level, const Materials& m) {
  MeshBuilder face, trim, slate;
  const float half = 5.2f, eaves = 5.4f, ridge = 9.4f, from = -2.4f, to = -25.0f;
  chamferBox(face, {-half, -1, to}, {half, eaves, from}, 0.0f, Mapping::kUpright);
  for (const float z : {from, to}) {
    std::vector<glm::vec3> gable{{-half, eaves - 0.1f, z}, {half, eaves - 0.1f, z}, {0, ridge, z}};
    if (z == to) std::swap(gable[0], gable[1]);
    face.flatPolygon(gable, {{gable[0].x, -eaves}, {gable[1].x, -eaves}, {0, -ridge}});
  }
  const float slope = glm::atan(ridge - eaves, half), length = half / glm::cos(slope) + 0.6f;
  for (const float side : {0.0f, 2.0f * kQuarter}) {
    slate.frame = glm::translate(glm::mat4(1), {0, ridge + 0.12f, 0.5f * (from + to)}) *
                  glm::rotate(glm::mat4(1), side, glm::vec3(0, 1, 0)) *
                  glm::rotate(glm::mat4(1), -slope, glm::vec3(0, 0, 1));
    slate.frame = slate.frame * glm::rotate(glm::mat4(1), -kQuarter, glm::vec3(0, 1, 0));  // u level, v down the slope
    const float long2 = 0.5f * (from - to) + 0.3f;
    chamferBox(slate, {-long2, -0.25f, -length}, {long2, 0, 0.05f}, 0.0f, Mapping::kUpright);
  }
  for (int i = 0; i < 5; ++i) {
    for (const float side : {-1.0f, 1.0f}) {
      trim.frame = placed({side * half, 0, from - 3.0f - 4.6f * real(i)}, side * kQuarter);
      chamferBox(trim, {-0.4f, -1, -0.2f}, {0.4f, 3.6f, 0.9f}, 0.05f, Mapping::kUpright);
      chamferBox(trim, {-0.35f, 3.5f, -0.2f}, {0.35f, 4.8f, 0.5f}, 0.05f, Mapping::kUpright);
    }
  }
  level.single("church", {face.finish(m.ashlar, hall::kAshlarTile), trim.finish(m.dressed, hall::kPillarTile),
                          slate.finish(m.slates, kSlateTile)});
}

}  // namespace tyndall::levels::tower
