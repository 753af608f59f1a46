// What stands out from the houses' faces: balconies, awnings, signs; and what hangs across the street.
#include <glm/gtc/constants.hpp>

#include "shapes.hpp"
#include "town_parts.hpp"

namespace tyndall::levels::town {
namespace {

/// A balcony at the middle of (s, y): deck of boards with gaps on brackets, and an iron railing.
void addBalcony(MeshBuilder& wood, MeshBuilder& iron, const glm::mat4& at, float half, float y) {
  wood.frame = iron.frame = at;
  constexpr float kOut = 1.15f;
  for (float z = 0.06f; z < kOut; z += 0.135f) beam(wood, {-half, y, z}, {half, y, z}, 0.095f, 0.04f, 0.006f);
  for (const float s : {-half + 0.15f, 0.0f, half - 0.15f}) {
    beam(wood, {s, y - 0.09f, -0.1f}, {s, y - 0.09f, kOut + 0.05f}, 0.09f, 0.13f, 0.012f);
    beam(wood, {s, y - 0.85f, 0.04f}, {s, y - 0.12f, 0.75f}, 0.07f, 0.08f, 0.01f);
  }
  const std::vector<glm::vec3> rail{
      {-half, y + 0.95f, 0.02f}, {-half, y + 0.95f, kOut}, {half, y + 0.95f, kOut}, {half, y + 0.95f, 0.02f}};
  for (const float drop : {0.0f, 0.84f}) {
    for (int i = 0; i < 3; ++i) {
      const glm::vec3 down(0, drop, 0);
      tube(iron, {rail[i] - down, rail[i + 1] - down}, {0.02f, 0.02f}, 6, true);
    }
  }
  const auto post = [&](float s, float z, float r) { tube(iron, {{s, y, z}, {s, y + 0.95f, z}}, {r, r}, 6); };
  for (float s = -half; s < half + 0.01f; s += 0.125f) post(s, kOut, 0.011f);
  for (float z = 0.15f; z < kOut; z += 0.125f)
    for (const float s : {-half, half}) post(s, z, 0.011f);
}

/// Laths with gaps on two rails that fall towards the street: the lamp above throws a comb of light through them.
void addLaths(MeshBuilder& wood, const glm::mat4& at, float half, float y) {
  wood.frame = at;
  for (const float s : {-half + 0.1f, half - 0.1f}) {
    beam(wood, {s, y, 0}, {s, y - 0.3f, 1.5f}, 0.07f, 0.09f, 0.01f);
    beam(wood, {s, y - 0.95f, 0.03f}, {s, y - 0.2f, 0.95f}, 0.05f, 0.05f, 0.008f);
  }
  for (int i = 0; i < 11; ++i) {
    const float t = (real(i) + 0.5f) / 11.0f;
    beam(wood, {-half, y + 0.06f - 0.3f * t, 1.5f * t}, {half, y + 0.06f - 0.3f * t, 1.5f * t}, 0.07f, 0.025f, 0.004f);
  }
}

void addCloth(MeshBuilder& cloth, MeshBuilder& iron, const glm::mat4& at, float half, float y) {
  cloth.frame = iron.frame = at;
  const auto point = [&](float u, float v) {  // v falls from the wall; the last part hangs
    const float out = glm::min(v / 0.86f, 1.0f), hang = glm::max(0.0f, v - 0.86f) / 0.14f;
    const float scallop = 0.5f + 0.5f * glm::cos(u * 2.0f * half / 0.3f * 2.0f * glm::pi<float>());
    return glm::vec3(glm::mix(-half, half, u),
                     y - 0.6f * out - hang * (0.16f + 0.09f * scallop) - 0.05f * glm::sin(glm::pi<float>() * out),
                     1.4f * out + 0.02f * hang);
  };
  surface(cloth, 40, 7, {2 * half, 1.8f}, [&](float u, float v) { return point(u, 1 - v); });
  surface(cloth, 40, 7, {2 * half, 1.8f}, [&](float u, float v) { return point(u, v) - glm::vec3(0, 0.012f, 0); });
  for (const float s : {-half, half}) tube(iron, {{s, y - 0.65f, 0}, {s, y - 0.62f, 1.4f}}, {0.015f, 0.015f}, 6, true);
}

/// A sign that hangs from a bracket: the arm at the node's origin, the board below it, across the street.
std::int32_t signMesh(LevelBuilder& level, const Materials& m, int kind) {
  MeshBuilder wood, gilt;
  for (const float x : {-0.3f, 0.3f}) {
    gilt.frame = placed({x, 0, 0});
    chain(gilt, 0.22f, 0.08f, 0.008f);
  }
  gilt.frame = placed({0, -0.6f, 0});
  if (kind == 0) {  // a boot-maker's oval with a hole pattern: rays through a star
    bar(wood, ringPath(0.38f, {0, -0.6f}, 28), {0, 0, 1}, 0.07f, 0.05f, true);
    for (int i = 0; i < 8; ++i) {
      const float angle = glm::pi<float>() * real(i) / 4.0f;
      const glm::vec3 out{glm::cos(angle), glm::sin(angle), 0};
      beam(gilt, 0.06f * out, 0.36f * out, i % 2 == 0 ? 0.07f : 0.035f, 0.03f, 0.006f, {0, 0, 1});
    }
    bar(gilt, ringPath(0.15f, {0, 0}, 20), {0, 0, 1}, 0.04f, 0.03f, true);
  } else {
    chamferBox(wood, {-0.42f, -0.78f, -0.025f}, {0.42f, -0.22f, 0.025f}, 0.01f);
    bar(gilt, {{-0.37f, -0.13f, 0.0f}, {0.37f, -0.13f, 0.0f}, {0.37f, 0.33f, 0.0f}, {-0.37f, 0.33f, 0.0f}}, {0, 0, 1},
        0.025f, 0.07f, true);
    for (int i = 0; i < 5; ++i)
      beam(gilt, {-0.26f + 0.11f * real(i), -0.02f, 0}, {-0.2f + 0.11f * real(i), 0.24f, 0}, 0.03f, 0.065f, 0.006f,
           {0, 0, 1});
  }
  return level.mesh("sign", {m.timber.finish(wood), gilt.finish(m.brass)});
}

}  // namespace

void addBalconies(LevelBuilder& level, const Materials& m) {
  MeshBuilder wood, iron;
  addBalcony(wood, iron, facing(-1, 4.0f, 0.2f), 2.4f, kGround + 0.05f);
  addBalcony(wood, iron, facing(1, -4.1f + kBay, 0.2f), 1.15f, kGround + 0.05f);
  addBalcony(wood, iron, facing(-1, -10.85f, 0.15f), 1.9f, kGround + kStorey + 0.05f);
  addBalcony(wood, iron, facing(1, 2.65f, -0.1f), 1.9f, kGround + kStorey + 0.05f);
  level.single("balconies", {m.timber.finish(wood), iron.finish(m.iron)});
}

void addAwnings(LevelBuilder& level, const Materials& m) {
  MeshBuilder wood, cloth, iron;
  addLaths(wood, facing(1, 2.65f, -0.1f), 2.3f, 2.9f);
  addLaths(wood, facing(-1, -4.1f, -0.1f), 2.6f, 2.95f);
  addCloth(cloth, iron, facing(-1, 4.9f, 0.2f), 1.5f, 2.75f);
  addCloth(cloth, iron, facing(1, -4.6f, 0.2f), 2.0f, 2.8f);
  addCloth(cloth, iron, facing(1, -12.2f, 0), 2.4f, 2.8f);
  level.single("awnings", {m.timber.finish(wood), m.stripes.finish(cloth), iron.finish(m.iron)});
}

void addSigns(LevelBuilder& level, const Materials& m) {
  MeshBuilder iron, rope, cloth;
  const std::int32_t signs[] = {signMesh(level, m, 0), signMesh(level, m, 1)};
  const auto hang = [&](const glm::vec3& at, float side, int kind, float period, int periods) {
    iron.frame = placed(at);
    tube(iron, {{side * 1.0f, 0.02f, 0}, {-side * 0.5f, 0.02f, 0}}, {0.018f, 0.018f}, 6, true);
    tube(iron, {{side * 1.0f, 0.55f, 0}, {-side * 0.1f, 0.03f, 0}}, {0.012f, 0.012f}, 6, true);
    const std::int32_t node = level.node("sign", signs[kind], at);
    level.animateSwing(node, {1, 0, 0}, 0, 0.35f, period, periods);
  };
  hang({-3.3f, 3.15f, -0.9f}, -1, 0, 3.0f, 8);
  hang({3.3f, 3.5f, -7.2f}, 1, 0, 4.0f, 6);
  hang({3.35f, 3.4f, 5.4f}, 1, 1, 4.0f, 6);
  hang({-3.3f, 3.3f, -14.2f}, -1, 1, 3.0f, 8);
  // Ropes across, one with the lantern's hook at its lowest point, one with washing.
  const auto across = [&](const glm::vec3& from, const glm::vec3& to, float sag) {
    std::vector<glm::vec3> path;
    for (int i = 0; i <= 16; ++i) {
      const float t = real(i) / 16.0f;
      path.push_back(glm::mix(from, to, t) - glm::vec3(0, 4 * sag * t * (1 - t), 0));
    }
    tube(rope, path, std::vector<float>(path.size(), 0.012f), 5);
  };
  across({-kFront, 5.45f, -4.2f}, {kFront + 0.7f, 5.6f, -4.2f}, 0.32f);
  across({-kFront, 6.6f, -9.0f}, {kFront, 6.5f, -8.4f}, 0.35f);
  Random random(551);
  for (int i = 0; i < 7; ++i) {
    const float t = 0.14f + 0.115f * real(i), wide = random.range(0.35f, 0.62f), tall = random.range(0.55f, 1.05f),
                phase = random.range(0, 6);
    const glm::vec3 top = glm::mix(glm::vec3(-kFront, 6.6f, -9.0f), glm::vec3(kFront, 6.5f, -8.4f), t) -
                          glm::vec3(0, 1.4f * t * (1 - t), 0);
    for (const float back : {0.0f, 1.0f}) {
      surface(cloth, 8, 8, {wide, tall}, [&](float u, float v) {
        const float s = back > 0 ? 1 - u : u;
        return top + glm::vec3(wide * (s - 0.5f), tall * (v - 1.0f),
                               0.06f * (1 - v) * glm::sin(9.0f * s + phase) - 0.012f * back);
      });
    }
  }
  level.single("ropes", {m.cloth.finish(rope)});
  level.single("washing", {m.cloth.finish(cloth)});
  level.single("sign arms", {iron.finish(m.iron)});
}

}  // namespace tyndall::levels::town
