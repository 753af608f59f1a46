// Roofs with eaves over the street, gables and chimneys; the gate tower at the street's end.
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "shapes.hpp"
#include "town_parts.hpp"
#include "wall.hpp"

namespace tyndall::levels::town {
namespace {

constexpr float kEaves = 0.55f, kRise = 2.6f;  // metres out over the face; from the eaves to the ridge
constexpr float kMiddle = 0.5f * kDepth;       // the ridge stands behind the face by this

/// A slab from the line (y, z) = `low` up to `high` in a house's frame, courses of tiles level.
void addSlope(MeshBuilder& tiles, const glm::mat4& house, float halfWidth, const glm::vec2& low,
              const glm::vec2& high) {
  const glm::vec2 along = high - low;
  const float pitch = glm::atan(along.x, -along.y);  // about s; the slope climbs towards -z
  tiles.frame = house * glm::rotate(glm::translate(glm::mat4(1), {0, 0.5f * (low.x + high.x), 0.5f * (low.y + high.y)}),
                                    pitch, glm::vec3(1, 0, 0));
  const float half = 0.5f * glm::length(along);
  chamferBox(tiles, {-halfWidth, -0.07f, -half}, {halfWidth, 0.07f, half}, 0, Mapping::kUpright);
}

void addChimney(MeshBuilder& brick, const glm::vec3& at) {
  chamferBox(brick, at + glm::vec3(-0.3f, -2.0f, -0.4f), at + glm::vec3(0.3f, 1.0f, 0.4f), 0.0f, Mapping::kUpright);
  chamferBox(brick, at + glm::vec3(-0.36f, 0.8f, -0.46f), at + glm::vec3(0.36f, 0.95f, 0.46f), 0.02f,
             Mapping::kUpright);
  const glm::mat4 before = brick.frame;
  for (const float z : {-0.2f, 0.2f}) {
    brick.frame = before * placed(at + glm::vec3(0, 1.0f, z));
    lathe(brick, {{0.13f, 0}, {0.11f, 0.35f}, {0.13f, 0.4f}, {0.09f, 0.4f}}, 10);
  }
  brick.frame = before;
}

}  // namespace

void addRoofs(LevelBuilder& level, const Materials& m) {
  const Coat coats[] = {m.plaster, m.ochre, m.rose, m.brick};
  MeshBuilder tiles, wood, brick, gutter;
  for (const House& house : kHouses) {
    MeshBuilder gables;
    const glm::mat4 at = facing(house.side, house.z, house.forward);
    const float top = house.top() + 0.05f, h = house.halfWidth(), slope = kRise / (kMiddle + kEaves);
    addSlope(tiles, at, h + 0.04f, {top - slope * kEaves + 0.25f, kEaves},
             {top + kRise - slope * kEaves + 0.29f, -kMiddle - 0.03f});
    addSlope(tiles, at, h + 0.04f, {top - slope * kEaves + 0.25f, -2 * kMiddle - kEaves},
             {top + kRise - slope * kEaves + 0.29f, -kMiddle + 0.03f});
    wood.frame = at;
    for (float s = -h + 0.15f; s < h; s += 0.6f)  // rafters' ends below the eaves
      beam(wood, {s, top - slope * kEaves + 0.14f, kEaves - 0.04f}, {s, top + 0.16f, -0.1f}, 0.09f, 0.13f, 0);
    gutter.frame = at;
    tube(gutter,
         {{-h, top - slope * kEaves + 0.19f, kEaves + 0.06f}, {h, top - slope * kEaves + 0.19f, kEaves + 0.06f}},
         {0.07f, 0.07f}, 8, true);
    tube(gutter,
         {{h - 0.12f, top - slope * kEaves + 0.16f, kEaves + 0.04f},
          {h - 0.12f, top - 0.75f, 0.09f},
          {h - 0.12f, 0.1f, 0.09f}},
         {0.05f, 0.05f, 0.05f}, 8, true);
    const WallShape gable{.halfWidth = kMiddle + 0.1f,
                          .bottom = top - 0.2f,
                          .topMiddle = top + kRise - slope * kEaves + 0.2f,
                          .topEnds = top + 0.12f,
                          .thickness = 0.25f};
    for (const float end : {-1.0f, 1.0f}) {
      gables.frame = at * placed({end * (h - 0.01f), 0, -kMiddle}, end * glm::half_pi<float>());
      wall(gables, gable);
    }
    brick.frame = at;
    addChimney(brick, {0.45f * h * (house.bays % 2 == 0 ? 1.0f : -1.0f), top + kRise - 0.5f, -kMiddle + 0.1f});
    level.single("gable", {coats[house.coat].finish(gables)});
  }
  level.single("roofs", {m.tiles.finish(tiles), m.timber.finish(wood), m.brick.finish(brick), gutter.finish(m.iron)});
}

void addGate(LevelBuilder& level, const Materials& m) {
  MeshBuilder stone, trim, tiles, wood;
  constexpr float kHalf = 3.4f, kTop = 14.4f, kThick = 2.0f;
  // Three storeys of wall, each with its opening: the gateway, a slit, the belfry.
  const auto storey = [&](float low, float high, float half, const Outline& hole) {
    const WallShape shape{.halfWidth = half, .bottom = low, .topMiddle = high, .topEnds = high, .thickness = kThick};
    stone.frame = trim.frame = placed({0, 0, kGateZ});
    wall(stone, trim, shape, hole, hole);
  };
  storey(-0.2f, 5.4f, 5.2f, pointedArch(1.75f, 0.0f, 2.3f, 10));
  storey(5.4f, 9.2f, kHalf, pointedArch(0.32f, 6.6f, 7.7f, 6));
  storey(9.2f, kTop, kHalf, {{-2.3f, 10.3f, 13.2f}, {2.3f, 10.3f, 13.2f}});
  for (const float side : {-1.0f, 1.0f}) {  // the wall's ends
    const float a = side * kHalf, c = side * (kHalf - 0.4f);
    chamferBox(stone, {glm::min(a, c), 5.2f, -kThick + 0.01f}, {glm::max(a, c) + 0.01f, kTop, -0.01f}, 0,
               Mapping::kUpright);
    chamferBox(stone, {side < 0 ? -9.0f : 5.0f, -0.2f, -kThick}, {side < 0 ? -5.0f : 9.0f, 7.5f, -0.3f}, 0,
               Mapping::kUpright);
  }
  for (const float y : {5.4f, 9.2f, kTop})
    chamferBox(trim, {-kHalf - 0.2f, y - 0.12f, -kThick - 0.2f}, {kHalf + 0.2f, y + 0.12f, 0.2f}, 0.03f,
               Mapping::kUpright);
  for (const float x : {-1.2f, 0.0f, 1.2f})
    chamferBox(trim, {x - 0.19f, 10.2f, -1.3f}, {x + 0.19f, 13.3f, -0.7f}, 0.04f, Mapping::kUpright);
  chamferBox(trim, {-5.25f, 5.25f, -kThick - 0.1f}, {5.25f, 5.55f, 0.1f}, 0.03f, Mapping::kUpright);
  for (float x = -kHalf; x < kHalf; x += 0.97f)
    chamferBox(stone, {x, kTop, -0.5f}, {x + 0.55f, kTop + 0.8f, 0.05f}, 0.02f, Mapping::kUpright);
  wood.frame = placed({0, 0, kGateZ});
  for (int i = 0; i < 4; ++i) {  // louvres between the belfry's posts
    const float x0 = i == 0 ? -2.3f : -1.01f + 1.2f * real(i - 1), x1 = i == 3 ? 2.3f : -1.39f + 1.2f * real(i);
    for (float y = 10.6f; y < 11.6f; y += 0.28f)
      beam(wood, {x0, y, -1.0f}, {x1, y, -1.0f}, 0.25f, 0.03f, 0, glm::normalize(glm::vec3(0, 1, 0.7f)));
  }
  MeshBuilder bell;
  bell.frame = placed({0.6f, 11.75f, kGateZ - 0.35f});
  lathe(bell, {{0.42f, 0}, {0.45f, 0.02f}, {0.34f, 0.2f}, {0.27f, 0.5f}, {0.2f, 0.66f}, {0.05f, 0.72f}, {0.04f, 1.0f}},
        20);
  for (const float x : {-0.75f, -0.25f, 0.25f, 0.75f})  // a portcullis, half drawn up
    for (const float y : {0.0f})
      beam(wood, {1.9f * x, 2.75f + y, -0.9f}, {1.9f * x, 5.0f, -0.9f}, 0.09f, 0.09f, 0.01f, {0, 0, 1});
  for (const float y : {3.1f, 3.7f, 4.3f}) beam(wood, {-1.75f, y, -0.9f}, {1.75f, y, -0.9f}, 0.08f, 0.1f, 0.01f);
  level.single("gate tower",
               {m.rubble.finish(stone), m.dressed.finish(trim), m.timber.finish(wood), bell.finish(m.brass)});
}

}  // namespace tyndall::levels::town
