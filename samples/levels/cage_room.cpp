// The room: slabs that overlap at every seam, so that no light leaks out; beams, posts, door, loft and stair.
#include <glm/gtc/constants.hpp>

#include "cage_parts.hpp"
#include "shapes.hpp"

namespace tyndall::levels::cage {
namespace {

constexpr float kBeamY = kCeiling - 0.17f;  // axis of the beams across

void addSlabs(LevelBuilder& level, const Materials& m) {
  MeshBuilder walls, floor, ceiling;
  const float x = kHalfWidth, z = kHalfLength, t = kThickness, low = -0.3f, high = kCeiling + 0.3f;
  for (const float side : {-1.0f, 1.0f}) {
    const float x0 = side < 0 ? -x - t : x, z0 = side < 0 ? -z - t : z;
    chamferBox(walls, {x0, low, -z - t}, {x0 + t, high, z + t}, 0.0f, Mapping::kUpright);
    chamferBox(walls, {-x - t, low, z0}, {x + t, high, z0 + t}, 0.0f, Mapping::kUpright);
  }
  chamferBox(floor, {-x - 0.3f, -t, -z - 0.3f}, {x + 0.3f, 0, z + 0.3f}, 0.0f, Mapping::kUpright);
  chamferBox(ceiling, {-x - 0.3f, kCeiling, -z - 0.3f}, {x + 0.3f, kCeiling + t, z + 0.3f}, 0.0f);
  level.single("shell", {m.brick.finish(walls), m.planks.finish(ceiling)});
  level.single("floor", {m.paving.finish(floor)});
}

void addFrame(LevelBuilder& level, const Materials& m) {
  MeshBuilder wood;
  Random random(401);
  const auto piece = [&](const glm::vec3& from, const glm::vec3& to, float width, float height,
                         const glm::vec3& up = {0, 1, 0}) {
    wood.uvOffset = {random.unit() * 2, random.unit() * 2};
    wood.color = glm::vec4(glm::vec3(random.range(0.72f, 1.0f)), 1);
    beam(wood, from, to, width, height, 0.025f, up);
  };
  const auto brace = [&](const glm::vec3& from, const glm::vec3& to) { piece(from, to, 0.13f, 0.14f); };
  const float wide = kHalfWidth + 0.1f, end = kHalfLength + 0.1f;
  for (const float z : {kLoftZ - 0.16f, 0.2f, 4.4f}) piece({-wide, kBeamY, z}, {wide, kBeamY, z}, 0.28f, 0.34f);
  for (float x = -5.4f; x < 5.5f; x += 0.9f)  // joists
    piece({x, kCeiling - 0.06f, -end}, {x, kCeiling - 0.06f, end}, 0.10f, 0.16f);
  // Posts in the room, with braces; and against the walls.
  for (const glm::vec2 at :
       {glm::vec2(-3.1f, 0.2f), {3.3f, 0.2f}, {-3.1f, 4.4f}, {3.3f, 4.4f}, {3.3f, kLoftZ - 0.16f}}) {
    piece({at.x, -0.05f, at.y}, {at.x, kBeamY - 0.1f, at.y}, 0.24f, 0.24f, {0, 0, 1});
    for (const float side : {-1.0f, 1.0f})
      brace({at.x + side * 0.06f, kBeamY - 0.95f, at.y}, {at.x + side * 0.85f, kBeamY - 0.1f, at.y});
  }
  for (const float z : {kLoftZ - 0.16f, 0.2f, 4.4f}) {
    for (const float side : {-1.0f, 1.0f})
      piece({side * (kHalfWidth - 0.08f), -0.05f, z}, {side * (kHalfWidth - 0.08f), kBeamY, z}, 0.24f, 0.24f,
            {0, 0, 1});
  }
  level.single("frame", {m.timber.finish(wood)});

  MeshBuilder stone;  // the walls' foot, and blocks below the posts
  for (const float side : {-1.0f, 1.0f}) {
    const float a = side * (kHalfWidth + 0.1f), c = side * (kHalfWidth - 0.09f);
    chamferBox(stone, {glm::min(a, c), -0.1f, -end}, {glm::max(a, c), 0.42f, end}, 0.03f, Mapping::kUpright);
    const float e = side * end, f = side * (kHalfLength - 0.09f);
    chamferBox(stone, {-wide, -0.1f, glm::min(e, f)}, {wide, 0.42f, glm::max(e, f)}, 0.03f, Mapping::kUpright);
  }
  for (const glm::vec2 at : {glm::vec2(-3.1f, 0.2f), {3.3f, 0.2f}, {-3.1f, 4.4f}, {3.3f, 4.4f}, {3.3f, kLoftZ - 0.16f}})
    chamferBox(stone, {at.x - 0.2f, -0.1f, at.y - 0.2f}, {at.x + 0.2f, 0.22f, at.y + 0.2f}, 0.03f, Mapping::kUpright);
  level.single("footing", {m.dressed.finish(stone)});
}

/// A double door in the +z wall, closed and barred.
void addDoor(LevelBuilder& level, const Materials& m) {
  MeshBuilder boards, wood, iron;
  const float z = kHalfLength;
  chamferBox(boards, {-1.3f, 0.02f, z - 0.06f}, {1.3f, 2.6f, z + 0.1f}, 0.0f);
  for (const float x : {-1.42f, 1.42f})
    chamferBox(wood, {x - 0.14f, -0.05f, z - 0.14f}, {x + 0.14f, 2.75f, z + 0.1f}, 0.025f);
  chamferBox(wood, {-1.7f, 2.6f, z - 0.16f}, {1.7f, 2.88f, z + 0.1f}, 0.025f);
  beam(wood, {-1.5f, 1.25f, z - 0.16f}, {1.5f, 1.25f, z - 0.16f}, 0.08f, 0.14f);
  for (const float y : {0.55f, 2.05f}) {
    for (const float side : {-1.0f, 1.0f}) {
      const float a = side * 1.28f, c = side * 0.3f;
      chamferBox(iron, {glm::min(a, c), y, z - 0.085f}, {glm::max(a, c), y + 0.07f, z}, 0.008f);
    }
  }
  level.single("door", {m.planks.finish(boards), m.timber.finish(wood), m.rust.finish(iron)});
}

constexpr int kSteps = 12;
constexpr float kRise = kDeck / kSteps, kRun = 0.34f, kStairX = -4.9f, kStairHalf = 0.5f;

void addRail(MeshBuilder& wood, const glm::vec3& from, const glm::vec3& to) {
  const glm::vec3 up{0, 0.95f, 0};
  beam(wood, from + up, to + up, 0.09f, 0.07f, 0.015f);
  beam(wood, from + 0.12f * up, to + 0.12f * up, 0.06f, 0.06f, 0.01f);
  const float length = glm::length(to - from);
  const int count = static_cast<int>(length / 0.19f);
  for (int i = 0; i <= count; ++i) {
    const glm::vec3 foot = glm::mix(from, to, real(i) / real(count));
    beam(wood, foot + glm::vec3(0, i % 6 == 0 ? -0.06f : 0.1f, 0), foot + up, i % 6 == 0 ? 0.08f : 0.035f,
         i % 6 == 0 ? 0.08f : 0.035f, 0.006f, {0, 0, 1});
  }
}

}  // namespace

void addRoom(LevelBuilder& level, const Materials& m) {
  addSlabs(level, m);
  addFrame(level, m);
  addDoor(level, m);
}

void addLoft(LevelBuilder& level, const Materials& m) {
  MeshBuilder boards, wood;
  Random random(402);
  const float back = -kHalfLength - 0.1f, left = -kHalfWidth - 0.1f;
  // Boards with gaps: light falls through between them.
  for (float z = kLoftZ - 0.24f; z > back; z -= 0.26f) {
    boards.uvOffset = {random.unit() * 2, random.unit() * 2};
    boards.color = glm::vec4(glm::vec3(random.range(0.75f, 1.0f)), 1);
    chamferBox(boards, {left, kDeck - 0.045f, z}, {kLoftX, kDeck, z + 0.238f}, 0.006f);
  }
  for (float x = -5.6f; x < kLoftX; x += 0.82f)
    beam(wood, {x, kDeck - 0.14f, kLoftZ}, {x, kDeck - 0.14f, back}, 0.1f, 0.18f);
  beam(wood, {left, kDeck - 0.28f, kLoftZ - 0.14f}, {kLoftX + 0.1f, kDeck - 0.28f, kLoftZ - 0.14f}, 0.22f, 0.26f);
  for (const float x : {-3.1f, kLoftX - 0.1f}) {
    beam(wood, {x, -0.05f, kLoftZ - 0.14f}, {x, kDeck - 0.3f, kLoftZ - 0.14f}, 0.2f, 0.2f, 0.025f, {0, 0, 1});
    for (const float side : {-1.0f, 1.0f}) {
      if (x > 0 && side > 0) continue;
      beam(wood, {x, kDeck - 1.15f, kLoftZ - 0.14f}, {x + side * 0.75f, kDeck - 0.4f, kLoftZ - 0.14f}, 0.11f, 0.12f);
    }
  }
  addRail(wood, {kStairX + kStairHalf + 0.1f, kDeck, kLoftZ - 0.08f}, {kLoftX - 0.06f, kDeck, kLoftZ - 0.08f});
  addRail(wood, {kLoftX - 0.06f, kDeck, kLoftZ - 0.08f}, {kLoftX - 0.06f, kDeck, -kHalfLength + 0.1f});

  // Open treads between two stringers, along the -x wall.
  const float foot = kLoftZ + kRun * kSteps;
  for (int i = 0; i < kSteps - 1; ++i) {
    const float y = kRise * real(i + 1), z = foot - kRun * real(i + 1);
    boards.uvOffset = {random.unit() * 2, random.unit() * 2};
    chamferBox(boards, {kStairX - kStairHalf, y - 0.05f, z}, {kStairX + kStairHalf, y, z + kRun - 0.04f}, 0.01f);
  }
  for (const float side : {-1.0f, 1.0f}) {
    const float x = kStairX + side * (kStairHalf + 0.02f);
    beam(wood, {x, -0.06f, foot - 0.05f}, {x, kDeck - 0.16f, kLoftZ}, 0.07f, 0.26f);
  }
  const float x = kStairX + kStairHalf + 0.04f;
  addRail(wood, {x, kRise, foot - 0.4f}, {x, kDeck - kRise, kLoftZ + 0.28f});
  level.single("loft", {m.planks.finish(boards), m.timber.finish(wood)});
}

}  // namespace tyndall::levels::cage
