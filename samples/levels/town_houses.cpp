// The rows of houses: faces with windows, rooms behind the lit ones, and the lights that shine out of them.
#include <glm/gtc/constants.hpp>

#include "shapes.hpp"
#include "town_parts.hpp"
#include "wall.hpp"

namespace tyndall::levels::town {
namespace {

constexpr float kThick = 0.35f, kHalf = 0.5f;           // of the faces; half a window's width
constexpr float kSill = 0.9f, kLintel = 2.3f;           // above the floor
constexpr float kRoomDepth = 2.7f, kLampDepth = 1.75f;  // behind the face
constexpr float kCone = 31.0f;                          // degrees: the image just covers the window from kLampDepth

enum class Fill { kDark, kLeaded, kPaned, kDoor };

/// A window whose room holds a light; `slant` along the street towards +z and `fall`, metres per metre out.
struct Lit {
  int house, bay, floor;
  Fill fill;
  float candela, slant, fall;
  glm::vec3 color;
};
constexpr Lit kLit[] = {{7, 1, 1, Fill::kLeaded, 900, 0.62f, 0.50f, {1.0f, 0.74f, 0.42f}},
                        {1, 1, 1, Fill::kPaned, 1000, 0.30f, 0.55f, {1.0f, 0.68f, 0.36f}},
                        {3, 1, 1, Fill::kLeaded, 1700, 0.52f, 0.42f, {1.0f, 0.78f, 0.46f}}};

struct Builders {
  MeshBuilder face, reveal, wood, glass, leaded, paned, room, door;
};

/// What a bay without a light holds: the same every time, by its place.
Fill fillOf(int house, int bay, int floor) {
  for (const Lit& lit : kLit)
    if (lit.house == house && lit.bay == bay && lit.floor == floor) return lit.fill;
  if (floor == 0 && bay == (house % 2 == 0 ? 0 : kHouses[house].bays - 1)) return Fill::kDoor;
  const int dice = (house * 7 + bay * 5 + floor * 11) % 8;
  return dice == 2 ? Fill::kLeaded : dice == 5 ? Fill::kPaned : Fill::kDark;
}

void addRoom(MeshBuilder& b, float s, float base) {
  const float w = 1.25f, high = base + 2.7f;
  chamferBox(b, {s - w, base, -kRoomDepth - 0.05f}, {s + w, high, -kRoomDepth}, 0, Mapping::kUpright);
  for (const float side : {-w, w})
    chamferBox(b, {s + side - 0.03f, base, -kRoomDepth}, {s + side + 0.03f, high, -kThick}, 0);
  chamferBox(b, {s - w, base, -kRoomDepth}, {s + w, base + 0.05f, -kThick}, 0);
  chamferBox(b, {s - w, high - 0.05f, -kRoomDepth}, {s + w, high, -kThick}, 0);
}

void addBay(Builders& b, const House& house, float s, float base, float top, Fill fill) {
  const bool door = fill == Fill::kDoor;
  const float low = base + (door ? 0.02f : kSill), high = base + kLintel, h = door ? 0.55f : kHalf;
  const WallShape shape{.halfWidth = 0.5f * kBay,
                        .bottom = base - (base > 0 ? 0.0f : 0.2f),
                        .topMiddle = top,
                        .topEnds = top,
                        .thickness = kThick};
  const Outline hole{{-h, low, high - 0.08f}, {0, low, high}, {h, low, high - 0.08f}};
  const glm::mat4 at = facing(house.side, house.z, house.forward) * placed({s, 0, 0});
  b.face.uvOffset = {s + house.z, 0};
  b.face.frame = b.reveal.frame = b.wood.frame = b.glass.frame = b.leaded.frame = b.paned.frame = b.door.frame = at;
  wall(b.face, b.reveal, shape, hole, hole);
  const float z = -0.2f;  // where panes and leaves stand in the reveal
  if (door) {
    chamferBox(b.door, {-h, low, z - 0.06f}, {h, high + 0.02f, z}, 0);
    for (const float y : {0.5f, 1.1f, 1.75f})
      chamferBox(b.door, {-h + 0.05f, base + y, z - 0.02f}, {h - 0.05f, base + y + 0.12f, z + 0.03f}, 0.01f);
    chamferBox(b.reveal, {-0.8f, base - 0.1f, -0.1f}, {0.8f, base + 0.12f, 0.32f}, 0.02f, Mapping::kUpright);
  } else if (fill == Fill::kDark) {
    chamferBox(b.glass, {-h, low, z - 0.03f}, {h, high + 0.01f, z}, 0);
    for (const float x : {-h + 0.03f, 0.0f, h - 0.03f})
      chamferBox(b.wood, {x - 0.03f, low, z - 0.01f}, {x + 0.03f, high, z + 0.04f}, 0);
    for (const float y : {low + 0.03f, glm::mix(low, high, 0.5f), high - 0.06f})
      chamferBox(b.wood, {-h, y - 0.025f, z - 0.01f}, {h, y + 0.025f, z + 0.03f}, 0);
  } else {  // the image's middle, as the cookie's middle falls into the window
    MeshBuilder& pane = fill == Fill::kLeaded ? b.leaded : b.paned;
    card(pane, {0, low, z}, {2 * h, 0, 0}, {0, high - low, 0}, {0, 0, 1}, {0.24f, 0.14f}, {0.76f, 0.86f});
  }
  if (door) return;
  chamferBox(b.reveal, {-h - 0.12f, low - 0.1f, -0.1f}, {h + 0.12f, low, 0.12f}, 0.015f, Mapping::kUpright);
  chamferBox(b.wood, {-h - 0.1f, high, -0.05f}, {h + 0.1f, high + 0.14f, 0.06f}, 0.015f);
}

/// Shutters with real slats beside the upper windows.
void addShutters(MeshBuilder& wood, const House& house, float s, float base) {
  const float low = base + kSill, high = base + kLintel - 0.04f;
  for (const float side : {-1.0f, 1.0f}) {
    wood.frame = facing(house.side, house.z, house.forward) *
                 placed({s + side * (kHalf + 0.04f), 0, 0.03f}, side > 0 ? -0.35f : 0.35f) *
                 placed({side * 0.25f, 0, 0});
    for (const float x : {-0.22f, 0.22f}) chamferBox(wood, {x - 0.03f, low, 0}, {x + 0.03f, high, 0.04f}, 0);
    for (const float y : {low, 0.5f * (low + high), high - 0.06f})
      chamferBox(wood, {-0.22f, y, 0.002f}, {0.22f, y + 0.06f, 0.038f}, 0);
    for (float y = low + 0.1f; y < high - 0.08f; y += 0.1f)
      beam(wood, {-0.2f, y, 0.02f}, {0.2f, y, 0.02f}, 0.045f, 0.012f, 0, glm::normalize(glm::vec3(0, 1, 0.9f)));
  }
}

/// What closes a house behind its face: back, party walls and floors, so that no light passes through.
void addBody(MeshBuilder& b, const House& house) {
  const float h = house.halfWidth(), top = house.top();
  b.frame = facing(house.side, house.z, house.forward);
  chamferBox(b, {-h, -0.2f, -kDepth - 0.3f}, {h, top, -kDepth}, 0, Mapping::kUpright);
  for (const float s : {-h, h - 0.25f})
    chamferBox(b, {s, -0.2f, -kDepth}, {s + 0.25f, top, -kThick}, 0, Mapping::kUpright);
  for (const float s : {-h, h - 0.02f})
    chamferBox(b, {s, -0.2f, -kThick}, {s + 0.02f, top, -0.002f}, 0, Mapping::kUpright);
  for (int floor = 0; floor <= house.floors; ++floor) {
    const float y = kGround + kStorey * real(floor);
    chamferBox(b, {-h, y - 0.12f, -kDepth}, {h, y + 0.06f, -0.01f}, 0);
  }
}

/// Posts, rails and braces on the face of a plastered house.
void addFraming(MeshBuilder& wood, const House& house) {
  wood.frame = facing(house.side, house.z, house.forward);
  const float h = house.halfWidth();
  for (int floor = 0; floor <= house.floors; ++floor) {
    const float y = kGround + kStorey * real(floor);
    beam(wood, {-h, y, 0.0f}, {h, y, 0.0f}, 0.14f, 0.24f, 0.02f);
    if (floor == house.floors) continue;
    for (int i = 0; i <= house.bays; ++i) {
      const float s = glm::clamp(kBay * real(i) - h, -h + 0.1f, h - 0.1f);
      beam(wood, {s, y, 0}, {s, y + kStorey, 0}, 0.18f, 0.10f, 0.015f, {0, 0, 1});
      if (i == house.bays) continue;
      const float lean = i % 2 == 0 ? 1.0f : -1.0f, mid = s + 0.5f * kBay;
      beam(wood, {mid - lean * 1.18f, y + 0.1f, 0}, {mid - lean * 0.72f, y + 1.0f, 0}, 0.14f, 0.08f, 0.012f, {0, 0, 1});
    }
    beam(wood, {-h, y + 0.86f, 0}, {h, y + 0.86f, 0}, 0.08f, 0.12f, 0.012f);
  }
}

}  // namespace

glm::mat4 facing(float side, float z, float forward) {
  return placed({side * (kFront - forward), 0, z}, -side * glm::half_pi<float>());
}

void addHouses(LevelBuilder& level, const Materials& m, const Cookies& cookies) {
  const Coat coats[] = {m.plaster, m.ochre, m.rose, m.brick};
  for (int i = 0; i < static_cast<int>(std::size(kHouses)); ++i) {
    const House& house = kHouses[i];
    Builders b;
    MeshBuilder shutters;
    for (int floor = 0; floor <= house.floors; ++floor) {
      const float base = floor == 0 ? 0.0f : kGround + kStorey * real(floor - 1), top = kGround + kStorey * real(floor);
      for (int bay = 0; bay < house.bays; ++bay) {
        const float s = kBay * (real(bay) + 0.5f) - house.halfWidth();
        const Fill fill = fillOf(i, bay, floor);
        addBay(b, house, s, base, top, fill);
        b.room.frame = facing(house.side, house.z, house.forward);
        if (fill == Fill::kLeaded || fill == Fill::kPaned) addRoom(b.room, s, base);
        if (floor > 0 && house.coat != 3) addShutters(shutters, house, s, base);
      }
    }
    addBody(b.face, house);
    if (house.coat != 3) addFraming(b.wood, house);
    level.single("house", {coats[house.coat].finish(b.face), m.dressed.finish(b.reveal), m.timber.finish(b.wood),
                           b.glass.finish(m.darkGlass), b.room.finish(m.litRoom), m.planks.finish(b.door),
                           m.shutter.finish(shutters), b.leaded.finish(m.leaded), b.paned.finish(m.paned)});
  }
  for (const Lit& lit : kLit) {
    const House& house = kHouses[lit.house];
    const glm::mat4 at = facing(house.side, house.z, house.forward);
    const float s = kBay * (real(lit.bay) + 0.5f) - house.halfWidth();
    const float y = kGround + kStorey * real(lit.floor - 1) + 0.5f * (kSill + kLintel);
    const glm::vec3 out(house.side * lit.slant, -lit.fall, 1.0f), middle(s, y, -0.2f);
    const auto world = [&](const glm::vec3& p) { return glm::vec3(at * glm::vec4(p, 1)); };
    level.spot("window light", world(middle - kLampDepth * out), world(middle), lit.color, lit.candela, kCone - 2,
               kCone, 15.0f, lit.fill == Fill::kLeaded ? cookies.leaded : cookies.paned);
  }
}

}  // namespace tyndall::levels::town
