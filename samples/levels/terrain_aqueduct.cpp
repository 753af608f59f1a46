// The aqueduct: two tiers of arches that the sun shines through, the upper one broken.
#include "hall_textures.hpp"
#include "props.hpp"
#include "shapes.hpp"
#include "terrain_parts.hpp"
#include "wall.hpp"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace tyndall::levels::terrain {
namespace {

constexpr float kLowerThick = 2.6f, kUpperThick = 1.7f, kFoot = -4.0f;
constexpr int kFirstGone = 11, kLastGone = 12;  // bays of the upper tier that have fallen

float bayZ(int bay, int bays) { return (real(bay) + 0.5f - 0.5f * real(bays)) * kBay * real(kBays) / real(bays); }

/// One bay about the middle of the aqueduct's thickness.
void bayOf(MeshBuilder& face, MeshBuilder& reveal, float z, float thickness, const WallShape& shape,
           const Outline& hole) {
  face.frame = reveal.frame = placed({kAqueductX - 0.5f * thickness, 0, z}, -glm::half_pi<float>());
  face.uvOffset = {z, 0};
  wall(face, reveal, shape, hole, hole);
}

/// Blocks left standing on `z0..z1` above `y0`, higher on the side of `high` (-1: low z).
void brokenEdge(MeshBuilder& b, Random& random, float z0, float z1, float y0, float y1, float high) {
  constexpr int kColumns = 4;
  for (int i = 0; i < kColumns; ++i) {
    const float share = (real(i) + 0.5f) / real(kColumns), rest = high < 0 ? 1.0f - share : share;
    const float top = glm::mix(y0, y1, glm::clamp(rest * rest + random.range(-0.12f, 0.12f), 0.08f, 1.0f));
    const float a = glm::mix(z0, z1, real(i) / real(kColumns)) - 0.02f,
                c = glm::mix(z0, z1, real(i + 1) / real(kColumns)) + 0.02f, w = 0.5f * kUpperThick;
    chamferBox(b, {kAqueductX - w + random.range(0, 0.15f), y0 - 0.2f, a},
               {kAqueductX + w - random.range(0, 0.15f), top, c}, 0.05f, Mapping::kUpright);
  }
}

}  // namespace

void addAqueduct(LevelBuilder& level, const Materials& m) {
  MeshBuilder face, reveal, trim;
  Random random(505);
  const float length = 0.5f * kBay * real(kBays) + 0.3f;
  for (int i = 0; i < kBays; ++i) {
    const WallShape shape{0.5f * kBay, kFoot, kLowerTop, kLowerTop, kLowerThick};
    bayOf(face, reveal, bayZ(i, kBays), kLowerThick, shape, roundArch(2.45f, kFoot, 5.6f, 9));
  }
  for (int i = 0; i <= kBays; ++i) {  // footings and imposts of the piers
    const float z = (real(i) - 0.5f * real(kBays)) * kBay, w = 0.5f * kLowerThick;
    const float y = groundY(kAqueductX, z);
    chamferBox(trim, {kAqueductX - w - 0.35f, kFoot, z - 1.35f}, {kAqueductX + w + 0.35f, y + 0.9f, z + 1.35f}, 0.12f,
               Mapping::kUpright);
    chamferBox(trim, {kAqueductX - w - 0.18f, 5.25f, z - 1.2f}, {kAqueductX + w + 0.18f, 5.6f, z + 1.2f}, 0.06f,
               Mapping::kUpright);
  }
  const float ledge = 0.5f * kLowerThick + 0.2f;
  chamferBox(trim, {kAqueductX - ledge, kLowerTop - 0.05f, -length}, {kAqueductX + ledge, kLowerTop + 0.4f, length},
             0.1f, Mapping::kUpright);
  const int upper = 2 * kBays;
  const float floor = kLowerTop + 0.35f, half = 0.25f * kBay;
  for (int i = 0; i < upper; ++i) {
    if (i >= kFirstGone && i <= kLastGone) continue;
    const WallShape shape{half, floor, kUpperTop, kUpperTop, kUpperThick};
    bayOf(face, reveal, bayZ(i, upper), kUpperThick, shape, roundArch(1.12f, floor, floor + 1.5f, 7));
  }
  // The channel on top: its floor, two sides, broken where the tier is.
  const float from = bayZ(kFirstGone, upper) - half, to = bayZ(kLastGone, upper) + half, w = 0.5f * kUpperThick;
  for (const auto& [a, c] : {std::pair{-length, from - 0.4f}, std::pair{to + 0.2f, length}}) {
    chamferBox(trim, {kAqueductX - w - 0.15f, kUpperTop - 0.05f, a}, {kAqueductX + w + 0.15f, kUpperTop + 0.3f, c},
               0.08f, Mapping::kUpright);
    for (const float side : {-1.0f, 1.0f}) {
      const float x = kAqueductX + side * (w - 0.1f);
      chamferBox(trim, {x - 0.2f, kUpperTop + 0.25f, a + 0.4f}, {x + 0.2f, kUpperTop + 0.95f, c - 0.5f}, 0.06f,
                 Mapping::kUpright);
    }
  }
  trim.frame = face.frame = glm::mat4(1);
  face.uvOffset = {0, 0};
  brokenEdge(face, random, from - 0.05f, from + 1.6f, floor, kUpperTop - 0.3f, -1);
  brokenEdge(face, random, to - 1.3f, to + 0.05f, floor, kUpperTop - 0.9f, 1);
  level.single("aqueduct", {face.finish(m.ashlar, hall::kAshlarTile), reveal.finish(m.dressed, hall::kPillarTile),
                            trim.finish(m.dressed, hall::kPillarTile)});
  // What fell lies below.
  MeshBuilder rubble;
  for (int i = 0; i < 40; ++i) {
    const float z = 0.5f * (from + to) + random.range(-7, 7),
                x = kAqueductX - 2.0f - 9.0f * random.unit() * random.unit();
    const glm::vec3 half3{random.range(0.2f, 0.55f), random.range(0.15f, 0.4f), random.range(0.25f, 0.75f)};
    const glm::vec3 axis = random.direction();
    rubble.frame = glm::translate(glm::mat4(1), onGround(x, z) + glm::vec3(0, 0.1f, 0)) *
                   glm::rotate(glm::mat4(1), random.range(-0.6f, 0.6f), axis) * placed({0, 0, 0}, random.range(0, 6));
    chamferBox(rubble, -half3, half3, 0.05f, Mapping::kUpright);
  }
  level.single("rubble", {rubble.finish(m.dressed, hall::kPillarTile)});
}

}  // namespace tyndall::levels::terrain
