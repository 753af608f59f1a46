// Where trees stand; rocks, the fallen trunk, the bridge, the swaying bough.
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "forest_parts.hpp"
#include "forest_textures.hpp"
#include "props.hpp"
#include "shapes.hpp"

namespace tyndall::levels::forest {
namespace {

glm::vec3 onGround(const glm::vec2& p) { return {p.x, groundY(p.x, p.y), p.y}; }

}  // namespace

std::vector<Place> addTrees(LevelBuilder& level, const Materials& m) {
  const Trees meshes = makeTrees(level, m);
  Random random(1234);
  std::vector<Place> places;
  const auto put = [&](const glm::vec2& p, std::int32_t mesh, float scale, float radius) {
    level.node("tree", mesh, onGround(p), random.range(0, 6.28f), scale);
    places.push_back({p, radius});
  };
  const auto isFree = [&](const glm::vec2& p, float distance) {
    if (creekDistance(p.x, p.y) < 2.6f) return false;
    for (const Place& other : places) {
      if (glm::length(other.at - p) < distance) return false;
    }
    return true;
  };
  // The trees that frame the views stand where they are wanted; chance fills the rest.
  const std::pair<glm::vec2, int> chosen[] = {
      {{-7.0f, -5.5f}, 0},  {{9.5f, -3.0f}, 2},   {{11.0f, -8.5f}, 0}, {{6.5f, -13.0f}, 1},  {{-1.5f, -14.0f}, 4},
      {{-9.5f, -11.5f}, 1}, {{14.5f, 0.5f}, 3},   {{-10.5f, 1.5f}, 2}, {{12.5f, -14.0f}, 4}, {{3.0f, -18.5f}, 3},
      {{17.5f, -6.5f}, 1},  {{-4.8f, -10.0f}, 5}, {{14.8f, -9.6f}, 3}, {{18.6f, -11.5f}, 4}};
  for (const auto& [at, kind] : chosen)
    put(at, meshes.full[static_cast<std::size_t>(kind)], random.range(0.92f, 1.1f), 0.5f);
  for (int i = 0, count = 0; i < 4000 && count < 20; ++i) {
    const float angle = random.range(0, 2.0f * glm::pi<float>()), far = random.range(10.0f, 24.0f);
    const glm::vec2 p = far * glm::vec2(glm::cos(angle), glm::sin(angle));
    if (p.y > 6.0f && glm::abs(p.x + 2.0f) < 5.0f && p.y < 17.0f) continue;  // where camera 0 stands
    if (!isFree(p, 4.4f)) continue;
    put(p, meshes.full[static_cast<std::size_t>(random.below(6))], random.range(0.85f, 1.15f), 0.5f);
    ++count;
  }
  for (int i = 0, count = 0; i < 6000 && count < 46; ++i) {
    const float angle = random.range(0, 2.0f * glm::pi<float>()), far = random.range(23.0f, 38.0f);
    const glm::vec2 p = far * glm::vec2(glm::cos(angle), glm::sin(angle));
    if (!isFree(p, 4.0f)) continue;
    put(p, meshes.spare[static_cast<std::size_t>(random.below(2))], random.range(0.85f, 1.2f), 0.5f);
    ++count;
  }
  return places;
}

void addRocks(LevelBuilder& level, const Materials& m) {
  const Coat coat{m.rock, kRockTile};
  const std::int32_t rocks[] = {rockMesh(level, coat, 61), rockMesh(level, coat, 62), rockMesh(level, coat, 63)};
  Random random(606);
  const auto put = [&](const glm::vec2& p, float scale, int kind) {
    level.node("rock", rocks[kind], onGround(p) - glm::vec3(0, 0.22f * scale, 0), random.range(0, 6), scale);
  };
  put({-4.6f, -1.2f}, 1.05f, 0), put({-5.7f, 0.1f}, 0.6f, 1), put({5.6f, -0.4f}, 0.8f, 2), put({6.4f, -1.5f}, 0.45f, 0),
      put({-0.5f, -8.4f}, 1.5f, 1);
  for (int i = 0; i < 22; ++i) {  // along the creek
    const float x = random.range(-16.0f, 16.0f);
    if (glm::abs(x - kBridgeX) < 1.6f) continue;
    put({x, creekZ(x) + (random.below(2) == 0 ? -1.0f : 1.0f) * random.range(0.3f, 1.9f)}, random.range(0.16f, 0.5f),
        random.below(3));
  }
}

void addFallenTrunk(LevelBuilder& level, const Materials& m) {
  MeshBuilder wood;
  Random random(70);
  tube(wood,
       {{-3.4f, 0.0f, 0}, {-2.2f, 0.03f, 0.05f}, {-0.5f, 0.05f, 0.1f}, {1.4f, 0.0f, 0.0f}, {3.4f, -0.08f, -0.16f}},
       {0.46f, 0.40f, 0.37f, 0.33f, 0.27f}, 14, true);
  for (int i = 0; i < 5; ++i) {  // stubs of branches
    const float x = -1.6f + 1.05f * real(i);
    const glm::vec3 out =
        glm::normalize(glm::vec3(random.range(0.1f, 0.6f), random.range(0.4f, 1.0f), random.range(-0.9f, 0.9f)));
    tube(wood, {glm::vec3(x, 0.1f, 0) + 0.15f * out, glm::vec3(x, 0.1f, 0) + random.range(0.5f, 1.1f) * out},
         {0.085f, 0.03f}, 6, true);
  }
  scene::Primitive primitive = wood.finish(m.bark, kBarkTile);
  for (scene::Vertex& v : primitive.vertices)
    v.color = glm::vec4(glm::mix(glm::vec3(1), glm::vec3(0.65f, 1.0f, 0.43f), glm::clamp(v.normal.y, 0.0f, 1.0f)),
                        1);  // moss above
  level.node("fallen trunk", level.mesh("fallen trunk", {primitive}), onGround({-2.6f, -4.2f}) + glm::vec3(0, 0.26f, 0),
             0.42f);
}

void addBridge(LevelBuilder& level, const Materials& m) {
  MeshBuilder wood;
  Random random(80);
  const float middle = creekZ(kBridgeX), half = 2.9f;
  const auto deckY = [&](float z) { return 0.42f - 0.4f * (z / half) * (z / half); };  // a shallow arch
  const auto piece = [&](const glm::vec3& from, const glm::vec3& to, float width, float height,
                         const glm::vec3& up = {0, 1, 0}) {
    wood.uvOffset = {random.unit() * 2, random.unit() * 2};
    wood.color = glm::vec4(glm::vec3(random.range(0.75f, 1.1f)), 1);
    beam(wood, from, to, width, height, 0.012f, up);
  };
  const int planks = 24;
  for (int i = 0; i < planks; ++i) {
    const float z = -half + 2 * half * (real(i) + 0.5f) / real(planks), reach = 0.78f + random.range(-0.03f, 0.03f);
    const glm::vec3 up = glm::normalize(glm::vec3(0, 1, 0.8f * z / (half * half)));
    piece({-reach, deckY(z), z}, {reach, deckY(z) + random.range(-0.008f, 0.008f), z}, 0.215f, 0.05f, up);
  }
  for (const float x : {-0.62f, 0.62f}) {
    std::vector<glm::vec3> stringer;
    for (int i = 0; i <= 8; ++i) {
      const float z = -half - 0.15f + (2 * half + 0.3f) * real(i) / 8.0f;
      stringer.emplace_back(x, deckY(z) - 0.14f, z);
    }
    wood.color = glm::vec4(0.8f, 0.8f, 0.8f, 1);
    bar(wood, stringer, {1, 0, 0}, 0.2f, 0.14f);
    glm::vec3 last{0};
    for (int i = 0; i < 5; ++i) {
      const float z = -half + 0.3f + (2 * half - 0.6f) * real(i) / 4.0f;
      const glm::vec3 top{1.18f * x, deckY(z) + 1.0f, z};
      piece({1.18f * x, deckY(z) - 0.2f, z}, top + glm::vec3(0, 0.06f, 0), 0.09f, 0.09f, {0, 0, 1});
      if (i > 0) {
        piece(last, top, 0.07f, 0.1f);
        piece(last - glm::vec3(0, 0.45f, 0), top - glm::vec3(0, 0.45f, 0), 0.05f, 0.08f);
      }
      last = top;
    }
  }
  level.node("footbridge", level.mesh("footbridge", {wood.finish(m.planks, 2.0f)}), {kBridgeX, 0.02f, middle});
}

void addBough(LevelBuilder& level, const Materials& m) {
  MeshBuilder wood, leaves;
  Random random(90);
  const std::vector<glm::vec3> path{{0, 0, 0}, {1.3f, 0.25f, 0.1f}, {2.6f, 0.3f, -0.1f}, {3.9f, 0.05f, 0.1f}};
  tube(wood, path, {0.09f, 0.065f, 0.04f, 0.012f}, 6);
  for (int i = 0; i < 46; ++i) {
    const float x = random.range(1.0f, 3.9f);
    const glm::vec3 at{x, 0.2f, random.range(-0.5f, 0.5f) * (x - 0.6f) * 0.4f},
        out = glm::normalize(glm::vec3(0.6f, -0.2f, at.z) + 0.8f * random.direction());
    const glm::vec3 right = glm::normalize(glm::cross(out, random.direction()));
    const float size = random.range(0.6f, 0.85f);
    leaves.color = glm::vec4(glm::vec3(random.range(0.8f, 1.1f)), 1);
    card(leaves, at, right * size, out * size, glm::normalize(glm::vec3(0, 1, 0) + 0.4f * random.direction()));
  }
  const std::int32_t mesh = level.mesh("bough", {wood.finish(m.bark, kBarkTile), leaves.finish(m.leaves)});
  // From the birch east of the clearing, out into the light.
  const glm::vec2 tree{9.5f, -3.0f};
  const std::int32_t root = level.node("bough's root", scene::kNone, {tree.x, groundY(tree.x, tree.y) + 4.6f, tree.y},
                                       glm::pi<float>() + 0.25f);
  const std::int32_t node = level.node("bough", mesh, {0, 0, 0}, 0, 1, root);
  level.animateSwing(node, glm::normalize(glm::vec3(0.2f, 0.25f, 1.0f)), 0.05f, 0.09f, 4.0f, 6);
}

}  // namespace tyndall::levels::forest
