// What the masons left: ribs, pilasters, columns, altar; the round window's ring and pane.
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>

#include "shapes.hpp"
#include "vault_parts.hpp"

namespace tyndall::levels::vault {
namespace {

constexpr float kColumnX = 2.5f;

void addRibs(LevelBuilder& level, const Materials& m) {
  MeshBuilder stone;
  for (const float z : {-kBay, 0.0f, kBay}) {
    std::vector<glm::vec3> arc;
    for (int i = 0; i <= 24; ++i) {
      const float x = glm::mix(-4.4f, 4.4f, real(i) / 24.0f);
      arc.emplace_back(x, vaultY(x) - 0.08f, z);
    }
    bar(stone, arc, {0, 0, 1}, 0.30f, 0.42f);
    for (glm::vec3& p : arc) p.y -= 0.17f;
    bar(stone, arc, {0, 0, 1}, 0.12f, 0.20f);
  }
  level.single("ribs", {m.dressed.finish(stone)});

  MeshBuilder pilaster;  // against a wall at z = 0, towards +z
  chamferBox(pilaster, {-0.36f, -0.1f, -0.2f}, {0.36f, 0.38f, 0.36f}, 0.04f, Mapping::kUpright);
  chamferBox(pilaster, {-0.26f, 0.3f, -0.2f}, {0.26f, 2.95f, 0.26f}, 0.04f, Mapping::kUpright);
  chamferBox(pilaster, {-0.31f, 2.93f, -0.2f}, {0.31f, 3.06f, 0.33f}, 0.03f, Mapping::kUpright);
  chamferBox(pilaster, {-0.36f, 3.05f, -0.2f}, {0.36f, 3.5f, 0.44f}, 0.07f, Mapping::kUpright);
  const std::int32_t mesh = level.mesh("pilaster", {m.dressed.finish(pilaster)});
  for (const float z : {-kBay, 0.0f, kBay}) {
    for (const float side : {-1.0f, 1.0f})
      level.node("pilaster", mesh, {side * kHalfWidth, 0, z}, -side * glm::half_pi<float>());
  }
  MeshBuilder course;  // the walls' foot
  for (const float side : {-1.0f, 1.0f}) {
    const float a = side * (kHalfWidth + 0.1f), c = side * (kHalfWidth - 0.07f);
    chamferBox(course, {glm::min(a, c), -0.1f, -7.1f}, {glm::max(a, c), 0.3f, 7.1f}, 0.03f, Mapping::kUpright);
  }
  level.single("courses", {m.dressed.finish(course)});
}

const std::vector<glm::vec2>& columnFoot() {
  static const std::vector<glm::vec2> foot{{0.34f, 0.2f},  {0.36f, 0.24f}, {0.35f, 0.29f}, {0.30f, 0.31f},
                                           {0.30f, 0.31f}, {0.29f, 0.34f}, {0.31f, 0.37f}, {0.31f, 0.40f},
                                           {0.25f, 0.43f}, {0.25f, 0.43f}};
  return foot;
}

void addColumns(LevelBuilder& level, const Materials& m) {
  const float high = vaultY(kColumnX) - 0.2f;
  MeshBuilder whole;
  chamferBox(whole, {-0.37f, -0.1f, -0.37f}, {0.37f, 0.2f, 0.37f}, 0.03f, Mapping::kUpright);
  std::vector<glm::vec2> profile = columnFoot();
  profile.insert(profile.end(), {{0.245f, 1.2f}, {0.24f, 2.2f}, {0.225f, 3.3f}, {0.225f, 3.3f}});
  profile.insert(profile.end(), {{0.26f, 3.32f}, {0.27f, 3.36f}, {0.26f, 3.40f}, {0.225f, 3.42f}, {0.225f, 3.42f}});
  profile.insert(profile.end(), {{0.23f, 3.56f}, {0.27f, 3.72f}, {0.34f, 3.84f}, {0.40f, 3.88f}, {0.40f, 3.94f}});
  lathe(whole, profile, 24);
  chamferBox(whole, {-0.43f, 3.92f, -0.43f}, {0.43f, high, 0.43f}, 0.05f, Mapping::kUpright);
  const std::int32_t column = level.mesh("column", {m.dressed.finish(whole)});
  for (const glm::vec2 at : {glm::vec2(-kColumnX, -kBay), {-kColumnX, kBay}, {kColumnX, -kBay}})
    level.node("column", column, {at.x, 0, at.y});

  // The fourth has fallen: a jagged stump, and drums on the floor.
  MeshBuilder stump, drum;
  chamferBox(stump, {-0.37f, -0.1f, -0.37f}, {0.37f, 0.2f, 0.37f}, 0.03f, Mapping::kUpright);
  profile = columnFoot();
  profile.insert(profile.end(), {{0.248f, 0.62f}, {0.248f, 0.62f}, {0.19f, 0.73f}, {0.11f, 0.70f}, {0.01f, 0.78f}});
  lathe(stump, profile, 20);
  level.node("stump", level.mesh("stump", {m.dressed.finish(stump)}), {kColumnX, 0, kBay});
  lathe(drum,
        {{0.01f, -0.45f},
         {0.13f, -0.43f},
         {0.235f, -0.38f},
         {0.235f, -0.38f},
         {0.24f, 0.42f},
         {0.24f, 0.42f},
         {0.12f, 0.40f},
         {0.01f, 0.44f}},
        22);
  const std::int32_t piece = level.mesh("drum", {m.dressed.finish(drum)});
  int index = 0;
  for (const glm::vec3 at : {glm::vec3(1.55f, 0.235f, 2.75f), {1.0f, 0.235f, 3.95f}}) {
    scene::Node n;
    n.name = "drum";
    n.mesh = piece;
    n.translation = at;
    n.rotation = glm::angleAxis(0.6f + 1.9f * real(index++), glm::vec3(0, 1, 0)) *
                 glm::angleAxis(glm::half_pi<float>(), glm::vec3(0, 0, 1));
    level.node(n);
  }
}

void addAltar(LevelBuilder& level, const Materials& m) {
  MeshBuilder stone, metal;
  for (int step = 0; step < 2; ++step) {
    const float grow = 0.4f * real(1 - step), top = 0.16f * real(step + 1);
    chamferBox(stone, {-1.5f - grow, -0.05f, -kHalfLength - 0.1f}, {1.5f + grow, top, -5.7f + grow}, 0.025f,
               Mapping::kUpright);
  }
  chamferBox(stone, {-0.95f, 0.3f, -6.75f}, {0.95f, 1.2f, -6.1f}, 0.03f, Mapping::kUpright);
  chamferBox(stone, {-1.08f, 1.18f, -6.85f}, {1.08f, 1.33f, -6.0f}, 0.03f, Mapping::kUpright);
  for (int i = 0; i < 4; ++i) {  // blind arches on the front
    const float x = -0.66f + 0.44f * real(i);
    std::vector<glm::vec3> arch{{x - 0.17f, 0.42f, -6.09f}};
    for (int k = 0; k <= 10; ++k) {
      const float angle = glm::pi<float>() * (1.0f - real(k) / 10.0f);
      arch.emplace_back(x + 0.17f * glm::cos(angle), 0.88f + 0.17f * glm::sin(angle), -6.09f);
    }
    arch.emplace_back(x + 0.17f, 0.42f, -6.09f);
    bar(stone, arch, {0, 0, 1}, 0.06f, 0.07f);
  }
  level.single("altar", {m.dressed.finish(stone)});
  chamferBox(metal, {-0.035f, 1.4f, -7.32f}, {0.035f, 2.55f, -7.25f}, 0.01f);
  chamferBox(metal, {-0.33f, 2.05f, -7.32f}, {0.33f, 2.12f, -7.25f}, 0.01f);
  std::vector<glm::vec3> ring = ringPath(0.2f, {0, 2.085f}, 24, -7.285f);
  bar(metal, ring, {0, 0, 1}, 0.035f, 0.05f, true);
  chamferBox(metal, {-0.2f, 0.3f, -7.4f}, {0.2f, 1.42f, -7.2f}, 0.02f);
  level.single("cross", {metal.finish(m.brass)});
}

/// The pane lies where the lamp's cone passes the window, its picture where the lamp throws it: blended, so that it
/// neither casts a shadow nor ends a ray; what it does to the light is the lamp's picture.
void addWindow(LevelBuilder& level, const Materials& m) {
  constexpr float kDepth = 0.28f;  // of the pane behind the wall's inner face
  const glm::vec3 axis = glm::vec3(kHalfWidth, kWindowY, kWindowZ) - kWindowLamp;
  const glm::mat3 turn = glm::mat3_cast(lookRotation(axis));
  const float reach = glm::tan(glm::radians(kWindowCone));
  const auto place = [&](const glm::vec2& p) {  // p: in the picture, its circle has radius 1
    const glm::vec3 d = turn * glm::vec3(p * reach, -1);
    return kWindowLamp + d * ((kHalfWidth + kDepth - kWindowLamp.x) / d.x);
  };
  MeshBuilder pane;
  constexpr int kSides = 48, kRings = 4;
  std::vector<std::uint32_t> index;
  for (int ring = 0; ring <= kRings; ++ring) {
    for (int side = 0; side < kSides; ++side) {
      const float angle = 2.0f * glm::pi<float>() * real(side) / kSides;
      const glm::vec2 p = 1.14f * real(ring) / real(kRings) * glm::vec2(glm::cos(angle), glm::sin(angle));
      index.push_back(pane.vertex(place(p), {-1, 0, 0}, {0.5f + 0.5f * p.x, 0.5f - 0.5f * p.y}));
    }
  }
  for (int ring = 0; ring < kRings; ++ring) {
    for (int side = 0; side < kSides; ++side) {
      const int a = ring * kSides + side, c = ring * kSides + (side + 1) % kSides;
      pane.quad(index[a], index[c], index[c + kSides], index[a + kSides]);  // the front faces the room
    }
  }
  level.single("rose window", {pane.finish(m.rose)});

  MeshBuilder stone;
  const glm::vec3 middle = place({0, 0});
  stone.frame = placed({kHalfWidth + kDepth, middle.y, kWindowZ}, -glm::half_pi<float>());
  bar(stone, ringPath(1.01f, {0, 0}, 40), {0, 0, 1}, 0.22f, 0.16f, true);
  stone.frame = placed({kHalfWidth, middle.y, kWindowZ}, -glm::half_pi<float>());
  bar(stone, ringPath(1.2f, {0, -0.04f}, 40), {0, 0, 1}, 0.17f, 0.12f, true);
  level.single("window ring", {m.dressed.finish(stone)});
}

}  // namespace

void addStone(LevelBuilder& level, const Materials& m) {
  addRibs(level, m);
  addColumns(level, m);
  addAltar(level, m);
  addWindow(level, m);
}

}  // namespace tyndall::levels::vault
