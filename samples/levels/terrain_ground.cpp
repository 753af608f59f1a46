// The height field: a valley before a ridge with a gap, and mountains about them.
#include "terrain_parts.hpp"

#include "noise.hpp"
#include "shapes.hpp"

namespace tyndall::levels::terrain {
namespace {

constexpr glm::ivec2 kNoPeriod{4096, 4096};
constexpr int kCells = 134;  // a side

/// Ridged multifractal (Musgrave, in Ebert et al. 2003, "Texturing and Modeling", ch. 16): sharp crests, and detail on
/// crests only, which is what water leaves of mountains. In [0, 1].
float crests(glm::vec2 p, int octaves, std::uint32_t seed) {
  float sum = 0, weight = 0, strength = 1, gate = 1;
  for (int i = 0; i < octaves; ++i) {
    float n = 1.0f - glm::abs(2.0f * valueNoise(p + 300.0f, kNoPeriod, seed + static_cast<std::uint32_t>(i)) - 1.0f);
    n *= n;
    sum += strength * gate * n, weight += strength;
    gate = glm::clamp(1.6f * n, 0.0f, 1.0f), strength *= 0.5f, p *= 2.03f;
  }
  return sum / weight;
}

/// 1 on the ridge's crest, 0 at its feet; steeper towards the valley.
float ridge(float x, float z) {
  const float off = x - kRidgeX - 5.0f * glm::sin(0.035f * z + 0.6f);
  const float width = off < 0 ? 19.0f : 32.0f, t = glm::clamp(1.0f - glm::abs(off) / width, 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

/// Dry grass, greener in the valley; bare rock where it is steep; a trodden track.
glm::vec3 tint(const glm::vec3& p, const glm::vec3& normal) {
  const float patches = fbm(glm::vec2(p.x, p.z) * 0.07f + 300.0f, kNoPeriod, 4, 61);
  const glm::vec3 gold{0.80f, 0.62f, 0.34f}, green{0.44f, 0.50f, 0.20f}, stone{0.60f, 0.56f, 0.52f};
  glm::vec3 c = glm::mix(green, gold, glm::smoothstep(0.35f, 0.65f, patches + 0.012f * p.y));
  c = glm::mix(c, stone, glm::smoothstep(0.20f, 0.40f, 1.0f - normal.y + 0.25f * (patches - 0.5f)));
  const float track = 1.0f - glm::smoothstep(0.7f, 1.7f, trackDistance(p.x, p.z) + 0.8f * (patches - 0.5f));
  return glm::mix(c, glm::vec3(0.62f, 0.50f, 0.38f), 0.85f * track);
}

/// Cells of 0.8 m in the middle, of 5 m at the border.
float spread(float u) {
  const float t = 2.0f * u - 1.0f;
  return kHalfSize * t * (0.35f + 0.65f * t * t);
}

}  // namespace

float groundY(float x, float z) {
  const glm::vec2 p{x, z};
  const glm::vec2 bent =
      p +
      9.0f * (glm::vec2(fbm(p * 0.025f + 300.0f, kNoPeriod, 3, 11), fbm(p * 0.025f + 300.0f, kNoPeriod, 3, 21)) - 0.5f);
  const float far = glm::length(p);
  const float gap = glm::smoothstep(kBay * 0.5f * kBays - 10.0f, kBay * 0.5f * kBays + 6.0f, glm::abs(z));
  const float crest = 17.0f + 9.0f * (crests(bent * 0.03f, 4, 31) - 0.4f);
  const float before = ridge(x, z) * glm::mix(2.2f, crest, gap);
  const float behind = 15.0f * glm::smoothstep(-38.0f, -80.0f, x + 6.0f * glm::sin(0.05f * z)) *
                       (0.6f + 0.8f * crests(bent * 0.02f, 4, 41));
  const float rim = 62.0f * glm::smoothstep(75.0f, 190.0f, far) * (0.35f + crests(bent * 0.011f, 6, 51));
  // The mountains stand back before the sun, or their shadow would fill the arches.
  const float pass = glm::smoothstep(0.55f, 0.97f, glm::dot(p, glm::vec2(toSun().x, toSun().z)) / (far + 1.0f));
  const float bumps = 0.7f * (fbm(p * 0.16f + 300.0f, kNoPeriod, 3, 71) - 0.5f);
  const float broken =
      2.4f * glm::max(ridge(x, z) * gap, glm::smoothstep(60.0f, 100.0f, far)) * (crests(bent * 0.11f, 3, 81) - 0.4f);
  return before + behind + rim * (1.0f - 0.8f * pass) + bumps + broken;
}

float trackX(float z) { return -7.0f + 7.0f * glm::sin(0.045f * z + 0.4f) + 2.0f * glm::sin(0.13f * z); }

float trackDistance(float x, float z) { return glm::abs(x - trackX(z)); }

glm::vec3 onGround(float x, float z) { return {x, groundY(x, z), z}; }

glm::vec3 groundNormal(float x, float z) {
  const float step = 0.4f;
  return glm::normalize(
      glm::vec3(groundY(x - step, z) - groundY(x + step, z), 2 * step, groundY(x, z - step) - groundY(x, z + step)));
}

void addGround(LevelBuilder& level, const Materials& m) {
  MeshBuilder ground;
  // v runs to -z, so that the front is above.
  surface(ground, kCells, kCells, {1, 1}, [](float u, float v) { return onGround(spread(u), -spread(v)); });
  scene::Primitive primitive = ground.finish(m.ground);
  for (scene::Vertex& v : primitive.vertices) {
    v.uv = glm::vec2(v.position.x, v.position.z) / kHeathTile;  // even, though the cells are not
    v.color = glm::vec4(tint(v.position, v.normal), 1);
  }
  level.single("ground", {primitive});
}

}  // namespace tyndall::levels::terrain
