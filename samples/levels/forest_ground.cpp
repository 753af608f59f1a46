// Terrain with a creek, and its cover of grass, fern and bushes.
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "forest_parts.hpp"
#include "forest_textures.hpp"
#include "noise.hpp"
#include "plants.hpp"
#include "shapes.hpp"

namespace tyndall::levels::forest {
namespace {

constexpr glm::ivec2 kNoPeriod{1024, 1024};

glm::vec2 onCircle(float angle) { return {glm::cos(angle), glm::sin(angle)}; }
glm::vec3 onGround(float x, float z) { return {x, groundY(x, z), z}; }

glm::vec3 groundNormal(float x, float z) {
  const float step = 0.3f;
  return glm::normalize(
      glm::vec3(groundY(x - step, z) - groundY(x + step, z), 2 * step, groundY(x, z - step) - groundY(x, z + step)));
}

/// Lush in the clearing and by the water, brown under the trees, dark and wet at the creek's edge.
glm::vec3 groundTint(float x, float z) {
  const float open = 1.0f - glm::smoothstep(7.0f, 14.0f, glm::length(glm::vec2(x, z)));
  const float wet = 1.0f - glm::smoothstep(0.9f, 1.9f, creekDistance(x, z));
  const glm::vec3 dry = glm::mix(glm::vec3(1.0f, 0.92f, 0.82f), glm::vec3(0.86f, 1.08f, 0.72f), open);
  return dry * glm::mix(1.0f, 0.42f, wet);
}

}  // namespace

float creekZ(float x) { return 3.6f + 2.2f * glm::sin(0.13f * x + 0.4f) + 0.9f * glm::sin(0.31f * x); }

float creekDistance(float x, float z) {
  const float slope = 2.2f * 0.13f * glm::cos(0.13f * x + 0.4f) + 0.9f * 0.31f * glm::cos(0.31f * x);
  return glm::abs(z - creekZ(x)) / glm::sqrt(1.0f + slope * slope);  // first order: the creek bends slowly
}

float groundY(float x, float z) {
  const glm::vec2 p{x, z};
  const float far = glm::length(p);
  const float hills = 3.2f * (fbm(p * 0.06f + 100.0f, kNoPeriod, 3, 7) - 0.45f) * glm::smoothstep(5.0f, 20.0f, far);
  const float bumps = 0.25f * (fbm(p * 0.45f + 100.0f, kNoPeriod, 2, 8) - 0.5f);
  const float rim = 6.5f * glm::smoothstep(24.0f, 41.0f, far);  // hides the terrain's end
  const float creek = creekDistance(x, z), dry = glm::smoothstep(1.0f, 8.0f, creek + glm::max(0.0f, far - 30.0f));
  const float bed = -1.05f * (1.0f - glm::smoothstep(0.5f, 2.3f, creek)) * (1.0f - glm::smoothstep(32.0f, 38.0f, far));
  return bumps + bed + dry * (hills + rim);
}

void addTerrain(LevelBuilder& level, const Materials& m) {
  MeshBuilder ground;
  const float size = 2 * kHalfSize;
  // v runs to -z, so that the front is above.
  surface(ground, kCells, kCells, {size, size},
          [&](float u, float v) { return onGround(size * u - kHalfSize, kHalfSize - size * v); });
  scene::Primitive primitive = ground.finish(m.litter, kGroundTile);
  for (scene::Vertex& v : primitive.vertices)
    v.color = glm::min(glm::vec4(groundTint(v.position.x, v.position.z), 1), glm::vec4(1));
  MeshBuilder water;
  surface(water, 64, 1, {64, 4}, [&](float u, float v) {
    const float x = 68.0f * u - 34.0f;
    return glm::vec3(x, kWaterY, creekZ(x) + 2.2f - 4.4f * v);
  });
  level.single("terrain", {primitive});
  level.single("water", {water.finish(m.water, 4.0f)});
}

void addUndergrowth(LevelBuilder& level, const Materials& m, const std::vector<Place>& trees) {
  Random random(404);
  const auto isFree = [&](const glm::vec2& p, float margin) {
    if (creekDistance(p.x, p.y) < 1.25f + margin) return false;
    if (glm::abs(p.x - kBridgeX) < 1.1f && creekDistance(p.x, p.y) < 3.4f) return false;
    for (const Place& tree : trees) {
      if (glm::length(tree.at - p) < tree.radius + margin) return false;
    }
    return true;
  };
  // Quarters, so that a view culls what it does not see.
  MeshBuilder quarter[4];
  const auto within = [&](float reach) {
    return reach * glm::sqrt(random.unit()) * onCircle(random.range(0, 2.0f * glm::pi<float>()));
  };
  const auto builderAt = [&](const glm::vec2& p) -> MeshBuilder& {
    return quarter[(p.x > 0 ? 1 : 0) + (p.y > 0 ? 2 : 0)];
  };
  for (int i = 0; i < 2600; ++i) {
    const glm::vec2 p = within(20.0f);
    const float thick = valueNoise(p * 0.5f + 300.0f, kNoPeriod, 5) - 0.02f * glm::length(p);
    if (thick < 0.22f || !isFree(p, 0.0f)) continue;
    MeshBuilder& b = builderAt(p);
    b.color = glm::vec4(glm::vec3(random.range(0.65f, 1.1f)), 1);
    grassTuft(b, random, onGround(p.x, p.y), groundNormal(p.x, p.y), random.range(0.35f, 0.6f));
  }
  for (int i = 0; i < 420; ++i) {
    const glm::vec2 p = within(27.0f);
    if (valueNoise(p * 0.35f + 500.0f, kNoPeriod, 6) < 0.5f || glm::length(p) < 4.0f || !isFree(p, 0.3f)) continue;
    MeshBuilder& b = builderAt(p);
    b.color = glm::vec4(glm::vec3(random.range(0.75f, 1.1f)), 1);
    fern(b, random, onGround(p.x, p.y), random.range(0.8f, 1.3f));
  }
  for (const MeshBuilder& b : quarter) level.single("undergrowth", {b.finish(m.undergrowth)});

  const Coat bark{m.bark, kBarkTile};
  const std::int32_t bushes[] = {bushMesh(level, bark, m.leaves, 31), bushMesh(level, bark, m.leaves, 32)};
  for (int i = 0, placed = 0; i < 400 && placed < 34; ++i) {
    const glm::vec2 p = within(30.0f);
    if (glm::length(p) < 8.5f || !isFree(p, 0.8f)) continue;
    level.node("bush", bushes[i % 2], onGround(p.x, p.y), random.range(0, 6), random.range(0.8f, 1.5f));
    ++placed;
  }
}

}  // namespace tyndall::levels::forest
