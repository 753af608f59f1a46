// Pillars, pilasters, dais; bars and glass of the windows.
#include <glm/gtc/constants.hpp>

#include "hall_parts.hpp"
#include "hall_textures.hpp"
#include "props.hpp"
#include "shapes.hpp"

namespace tyndall::levels::hall {
namespace {

constexpr float kGlassDepth = -0.33f;  // of the windows' bars in the wall

std::vector<glm::vec3> arcPath(const Outline& outline, float depth, bool withJambs) {
  std::vector<glm::vec3> path;
  if (withJambs) path.emplace_back(outline.front().x, outline.front().y, depth);
  for (const glm::vec3& p : outline) path.emplace_back(p.x, p.z, depth);
  if (withJambs) path.emplace_back(outline.back().x, outline.back().y, depth);
  return path;
}

std::int32_t windowMesh(LevelBuilder& level, const Materials& m) {
  MeshBuilder stone, iron;
  const glm::vec3 facing{0, 0, 1};
  const float d = kGlassDepth;
  bar(stone, arcPath(pointedArch(kWindowHalf - 0.02f, kSill - 0.1f, kSpring, 10), d, true), facing, 0.14f, 0.22f);
  bar(stone, {{0, kSill - 0.15f, d}, {0, kSpring + 0.25f, d}}, facing, 0.13f, 0.2f);
  for (const float s : {-0.5f, 0.5f}) {
    auto arch = arcPath(pointedArch(0.35f, kSill, kSpring - 0.12f, 7), d, false);
    for (glm::vec3& p : arch) p.x += s * kWindowHalf;
    bar(stone, arch, facing, 0.09f, 0.16f);
  }
  bar(stone, ringPath(0.26f, {0, kSpring + 0.66f}, 20, d), facing, 0.08f, 0.16f, true);
  for (int i = 1; i <= 5; ++i) {
    const float y = kSill + 0.72f * real(i);
    bar(iron, {{-kWindowHalf - 0.05f, y, d}, {kWindowHalf + 0.05f, y, d}}, facing, 0.028f, 0.028f);
  }
  return level.mesh("window bars", {stone.finish(m.dressed, kPillarTile), iron.finish(m.iron)});
}

std::int32_t roseMesh(LevelBuilder& level, const Materials& m) {
  MeshBuilder stone;
  const glm::vec3 facing{0, 0, 1};
  bar(stone, ringPath(kRoseRadius, {0, 0}, 36, 0), facing, 0.16f, 0.24f, true);
  bar(stone, ringPath(0.42f, {0, 0}, 20, 0), facing, 0.1f, 0.18f, true);
  for (int i = 0; i < 10; ++i) {
    const float angle = 2.0f * glm::pi<float>() * real(i) / 10.0f;
    const glm::vec2 ray{glm::cos(angle), glm::sin(angle)};
    bar(stone, {{0.42f * ray, 0}, {1.12f * ray, 0}}, facing, 0.08f, 0.14f);
    const glm::vec2 between{glm::cos(angle + 0.314f), glm::sin(angle + 0.314f)};
    bar(stone, ringPath(0.3f, 1.18f * between, 14, 0), facing, 0.07f, 0.14f, true);
  }
  return level.mesh("rose bars", {stone.finish(m.dressed, kPillarTile)});
}

std::int32_t pillarMesh(LevelBuilder& level, const Materials& m) {
  MeshBuilder stone;
  chamferBox(stone, {-0.56f, -0.1f, -0.56f}, {0.56f, 0.26f, 0.56f}, 0.03f, Mapping::kUpright);
  const std::vector<glm::vec2> base{{0.55f, 0.26f}, {0.57f, 0.31f},  {0.56f, 0.36f}, {0.53f, 0.39f}, {0.48f, 0.40f},
                                    {0.48f, 0.40f}, {0.465f, 0.43f}, {0.47f, 0.47f}, {0.49f, 0.49f}, {0.49f, 0.52f},
                                    {0.46f, 0.55f}, {0.41f, 0.55f},  {0.41f, 0.55f}};
  std::vector<glm::vec2> profile = base;
  profile.insert(profile.end(), {{0.41f, 2.0f}, {0.40f, 3.8f}, {0.375f, 5.72f}, {0.375f, 5.72f}});
  profile.insert(profile.end(), {{0.42f, 5.74f}, {0.435f, 5.78f}, {0.42f, 5.82f}, {0.375f, 5.84f}, {0.375f, 5.84f}});
  profile.insert(
      profile.end(),
      {{0.38f, 6.02f}, {0.41f, 6.2f}, {0.48f, 6.36f}, {0.57f, 6.46f}, {0.57f, 6.46f}, {0.60f, 6.47f}, {0.60f, 6.52f}});
  lathe(stone, profile, 24);
  chamferBox(stone, {-0.64f, 6.5f, -0.64f}, {0.64f, 6.72f, 0.64f}, 0.04f, Mapping::kUpright);
  return level.mesh("pillar", {stone.finish(m.dressed, kPillarTile)});
}

std::int32_t pilasterMesh(LevelBuilder& level, const Materials& m) {
  MeshBuilder stone;  // against a wall at z = 0, towards +z
  chamferBox(stone, {-0.5f, -0.1f, -0.2f}, {0.5f, 0.55f, 0.42f}, 0.04f, Mapping::kUpright);
  chamferBox(stone, {-0.36f, 0.5f, -0.2f}, {0.36f, 7.4f, 0.30f}, 0.05f, Mapping::kUpright);
  chamferBox(stone, {-0.42f, 7.38f, -0.2f}, {0.42f, 7.6f, 0.42f}, 0.05f, Mapping::kUpright);
  chamferBox(stone, {-0.46f, 7.58f, -0.2f}, {0.46f, 8.12f, 0.62f}, 0.10f, Mapping::kUpright);
  return level.mesh("pilaster", {stone.finish(m.dressed, kPillarTile)});
}

/// Skirting and sill course along both walls; the north wall's leave the door free.
void addCourses(LevelBuilder& level, const Materials& m) {
  MeshBuilder stone;
  const float door = bayZ(kDoorBay), gap = kDoorHalf + 0.55f, end = kHalfLength + 0.1f;
  const auto run = [&](float side, float z0, float z1, float y0, float y1, float reach) {
    const float a = side * (kHalfWidth + 0.1f), c = side * (kHalfWidth - reach);
    chamferBox(stone, {glm::min(a, c), y0, z0}, {glm::max(a, c), y1, z1}, 0.03f, Mapping::kUpright);
  };
  for (const auto& [y0, y1, reach] : {std::tuple{-0.1f, 0.42f, 0.09f}, std::tuple{2.08f, 2.26f, 0.12f}}) {
    run(1, -end, end, y0, y1, reach);
    run(-1, -end, door - gap, y0, y1, reach);
    run(-1, door + gap, end, y0, y1, reach);
  }
  // The door's frame.
  auto arch = arcPath(pointedArch(kDoorHalf + 0.3f, 0, kDoorSpring, 10), 0.05f, true);
  stone.frame = placed({-kHalfWidth, 0, door}, glm::half_pi<float>());
  bar(stone, arch, {0, 0, 1}, 0.3f, 0.22f);
  level.single("courses", {stone.finish(m.dressed, kPillarTile)});
}

void addDais(LevelBuilder& level, const Materials& m) {
  MeshBuilder stone;
  for (int step = 0; step < 3; ++step) {
    const float grow = 0.42f * real(2 - step), top = 0.17f * real(step + 1);
    chamferBox(stone, {-2.8f - grow, -0.05f, -kHalfLength - 0.1f}, {2.8f + grow, top, -16.9f + grow}, 0.025f,
               Mapping::kUpright);
  }
  level.single("dais", {stone.finish(m.dressed, kPillarTile)});
}

}  // namespace

void addTracery(LevelBuilder& level, const Materials& m) {
  const std::int32_t bars = windowMesh(level, m);
  for (int bay = 0; bay < kWindows; ++bay)
    level.node("window bars", bars, {kHalfWidth, 0, bayZ(bay)}, -glm::half_pi<float>());
  level.node("rose bars", roseMesh(level, m), {0, kRoseY, -kHalfLength - 0.3f});
  // One window has glass: a pane that is blended, and so neither casts a shadow nor ends a view ray.
  MeshBuilder pane;
  const Outline hole = pointedArch(kWindowHalf, kSill - 0.1f, kSpring, 10);
  pane.frame = placed({kHalfWidth, 0, bayZ(kStainedBay)}, -glm::half_pi<float>());
  std::vector<glm::vec3> corners{{hole.back().x, hole.back().y, kGlassDepth}};
  for (auto p = hole.rbegin(); p != hole.rend(); ++p) corners.emplace_back(p->x, p->z, kGlassDepth);
  corners.emplace_back(hole.front().x, hole.front().y, kGlassDepth);
  std::vector<glm::vec2> uv;
  // One image a lancet, left edge at the mullion's middle; six metres high.
  for (const glm::vec3& p : corners) uv.emplace_back(p.x / kWindowHalf, (8.6f - p.y) / 6.1f);
  pane.flatPolygon(corners, uv);
  level.single("stained glass", {pane.finish(m.glass)});
}

void addPillars(LevelBuilder& level, const Materials& m) {
  const std::int32_t pillar = pillarMesh(level, m), pilaster = pilasterMesh(level, m);
  for (int i = 1; i < kBays; ++i) {
    const float z = -kHalfLength + kBay * real(i);
    for (const float side : {-1.0f, 1.0f}) {
      level.node("pillar", pillar, {side * kPillarX, 0, z});
      level.node("pilaster", pilaster, {side * kHalfWidth, 0, z}, -side * glm::half_pi<float>());
    }
  }
  addCourses(level, m);
  addDais(level, m);
}

}  // namespace tyndall::levels::hall
