// Floor, walls, roof: closed but for the openings. Neighbours overlap, so that no light leaks in at an edge.
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "hall_parts.hpp"
#include "hall_textures.hpp"
#include "shapes.hpp"

namespace tyndall::levels::hall {
namespace {

constexpr float kBottom = -0.2f;  // of the walls, inside the floor slab

/// From a wall's frame (wall.hpp) to the hall: the middle of its inner face's foot at `at`, the room towards `yaw`.
glm::mat4 standing(const glm::vec3& at, float yaw) { return placed(at, yaw); }

Opening openingOf(const Outline& outline, const glm::mat4& frame) {
  scene::Bounds box;
  for (const glm::vec3& p : outline) {
    for (const float z : {0.0f, -kThickness}) {
      box.add(glm::vec3(frame * glm::vec4(p.x, p.y, z, 1)));
      box.add(glm::vec3(frame * glm::vec4(p.x, p.z, z, 1)));
    }
  }
  return {box.min, box.max};
}

const float kQuarter = glm::half_pi<float>();
glm::mat4 southBay(int bay) { return standing({kHalfWidth, 0, bayZ(bay)}, -kQuarter); }
glm::mat4 northBay(int bay) { return standing({-kHalfWidth, 0, bayZ(bay)}, kQuarter); }
glm::mat4 headEnd() { return standing({0, 0, -kHalfLength}, 0); }
glm::mat4 footEnd() { return standing({0, 0, kHalfLength}, 2.0f * kQuarter); }

void addWalls(MeshBuilder& face, MeshBuilder& reveal) {
  const WallShape side{
      .halfWidth = 0.5f * kBay, .bottom = kBottom, .topMiddle = kWallTop, .topEnds = kWallTop, .thickness = kThickness};
  for (int bay = 0; bay < kBays; ++bay) {
    // Shift the courses by the bay's place: the stones run on from panel to panel.
    face.uvOffset = {real(bay) * kBay, 0};
    face.frame = reveal.frame = southBay(bay);
    wall(face, reveal, side, windowOutline(true), windowOutline(false));
    face.uvOffset = {-real(bay) * kBay, 0};
    face.frame = reveal.frame = northBay(bay);
    bay == kDoorBay ? wall(face, reveal, side, doorOutline(true), doorOutline(false)) : wall(face, side);
  }
  face.uvOffset = {0, 0};
  // The end walls reach over the long walls' ends and up into the roof.
  const float half = kHalfWidth + kThickness;
  const WallShape end{.halfWidth = half,
                      .bottom = kBottom,
                      .topMiddle = kRidge + 0.15f,
                      .topEnds = roofY(half) + 0.15f,
                      .thickness = kThickness};
  face.frame = reveal.frame = headEnd();
  wall(face, reveal, end, roseOutline(true), roseOutline(false));
  face.frame = footEnd();
  wall(face, end);
  face.frame = glm::mat4(1);
  // The corners from outside: the end walls' open sides.
  for (const float z : {-1.0f, 1.0f}) {
    for (const float x : {-1.0f, 1.0f}) {
      const glm::vec3 a{x * kHalfWidth, kBottom, z * kHalfLength},
          c{x * (half + 0.05f), kWallTop, z * (kHalfLength + kThickness + 0.05f)};
      chamferBox(face, glm::min(a, c), glm::max(a, c), 0.0f, Mapping::kUpright);
    }
  }
}

/// One slope of the roof as a thick slab from the ridge to beyond the wall; both slopes overlap at the ridge.
void addRoof(MeshBuilder& boards) {
  const float fall = glm::atan(kRoofSlope), run = (kHalfWidth + kThickness + 0.35f) / glm::cos(fall), thick = 0.45f;
  for (const float side : {-1.0f, 1.0f}) {
    boards.frame = glm::rotate(glm::translate(glm::mat4(1), glm::vec3(0, kRidge, 0)), -side * fall, glm::vec3(0, 0, 1));
    const float from = side > 0 ? -0.2f : -run, to = side > 0 ? run : 0.2f;
    chamferBox(boards, {from, 0, -kHalfLength - 1.0f}, {to, thick, kHalfLength + 1.0f}, 0.0f);
  }
  boards.frame = glm::mat4(1);
}

}  // namespace

Outline windowOutline(bool inner) {
  return inner ? pointedArch(kWindowHalf + 0.18f, kSill - 0.25f, kSpring, 10)
               : pointedArch(kWindowHalf, kSill, kSpring, 10);
}
Outline roseOutline(bool inner) { return circle(kRoseRadius + (inner ? 0.15f : 0.0f), kRoseY, 12); }
Outline doorOutline(bool inner) { return pointedArch(kDoorHalf + (inner ? 0.15f : 0.0f), 0.03f, kDoorSpring, 8); }

std::vector<Opening> openings() {
  std::vector<Opening> list;
  for (int bay = 0; bay < kBays; ++bay) list.push_back(openingOf(windowOutline(true), southBay(bay)));
  list.push_back(openingOf(doorOutline(true), northBay(kDoorBay)));
  list.push_back(openingOf(roseOutline(true), headEnd()));
  return list;
}

void addShell(LevelBuilder& level, const Materials& m) {
  MeshBuilder face, reveal, floor, boards, earth;
  addWalls(face, reveal);
  addRoof(boards);
  const float x = kHalfWidth + kThickness + 0.4f, z = kHalfLength + kThickness + 0.4f;
  chamferBox(floor, {-x, -0.4f, -z}, {x, 0.0f, z}, 0.0f, Mapping::kUpright);
  // Some ground outside, so that the windows and the door look onto something; small, because a shadow map that is
  // fitted to the level would waste texels on it.
  chamferBox(earth, {-x - 7, -0.7f, -z - 6}, {x + 7, -0.25f, z + 6}, 0.0f, Mapping::kUpright);
  level.single("shell", {face.finish(m.ashlar, kAshlarTile), reveal.finish(m.dressed, kPillarTile),
                         boards.finish(m.planks, kWoodTile)});
  level.single("floor", {floor.finish(m.flags, kFloorTile)});
  level.single("ground outside", {earth.finish(m.earth, 4.0f)});
}

}  // namespace tyndall::levels::hall
