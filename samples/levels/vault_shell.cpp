// Floor, walls, vault: closed, with the well above and the chamber beside it. Neighbours overlap, so that no light
// leaks in at an edge.
#include <glm/gtc/constants.hpp>

#include "shapes.hpp"
#include "vault_parts.hpp"
#include "wall.hpp"

namespace tyndall::levels::vault {
namespace {

constexpr float kBottom = -0.2f;  // of the walls, inside the floor slab
const float kQuarter = glm::half_pi<float>();

/// The vault as strips between the same seams in x and z, so that neighbours share their vertices; the middle one is
/// left out for the well.
void addVault(MeshBuilder& b) {
  const float reach = kHalfWidth + 0.12f, end = kHalfLength + 0.15f;
  const float xs[] = {-reach, -kWellHalf, kWellHalf, reach};
  const float zs[] = {-end, kWellZ - kWellHalf, kWellZ + kWellHalf, end};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      if (i == 1 && k == 1) continue;
      const glm::vec2 size(xs[i + 1] - xs[i], zs[k + 1] - zs[k]);
      b.uvOffset = {xs[i], -zs[k]};
      surface(b, i == 1 ? 8 : 14, k == 0 ? 12 : 8, size, [&](float u, float v) {
        const float x = glm::mix(xs[i], xs[i + 1], u);
        return glm::vec3(x, vaultY(x), glm::mix(zs[k], zs[k + 1], v));
      });
    }
  }
  b.uvOffset = {0, 0};
}

void addWalls(MeshBuilder& face, MeshBuilder& reveal) {
  const WallShape side{.halfWidth = 0.5f * kBay,
                       .bottom = kBottom,
                       .topMiddle = kSpring + 0.3f,
                       .topEnds = kSpring + 0.3f,
                       .thickness = kThickness};
  for (int bay = 0; bay < 4; ++bay) {
    const float z = -kHalfLength + kBay * (real(bay) + 0.5f);
    face.uvOffset = {real(bay) * kBay, 0};
    face.frame = reveal.frame = placed({kHalfWidth, 0, z}, -kQuarter);
    if (z == kWindowZ) {
      wall(face, reveal, side, circle(kWindowRadius + 0.12f, kWindowY, 16), circle(kWindowRadius, kWindowY, 16));
    } else {
      wall(face, side);
    }
    face.uvOffset = {-real(bay) * kBay, 0};
    face.frame = placed({-kHalfWidth, 0, z}, kQuarter);
    wall(face, side);
  }
  face.uvOffset = {0, 0};
  // The end walls reach over the long walls' ends and above the vault; one has a niche, closed by a slab behind it.
  const WallShape end{.halfWidth = kHalfWidth + kThickness,
                      .bottom = kBottom,
                      .topMiddle = kApex + 0.3f,
                      .topEnds = kApex + 0.3f,
                      .thickness = kThickness};
  face.frame = reveal.frame = placed({0, 0, -kHalfLength});
  wall(face, reveal, end, pointedArch(1.15f, 0.35f, 1.7f, 10), pointedArch(1.05f, 0.4f, 1.7f, 10));
  face.frame = placed({0, 0, kHalfLength}, 2.0f * kQuarter);
  wall(face, end);
  face.frame = glm::mat4(1);
  for (const float z : {-1.0f, 1.0f}) {  // the corners
    for (const float x : {-1.0f, 1.0f}) {
      const glm::vec3 a{x * kHalfWidth, kBottom, z * kHalfLength},
          c{x * (kHalfWidth + kThickness + 0.05f), kSpring + 0.35f, z * (kHalfLength + kThickness + 0.05f)};
      chamferBox(face, glm::min(a, c), glm::max(a, c), 0.0f, Mapping::kUpright);
    }
  }
  const float back = -kHalfLength - kThickness;
  chamferBox(face, {-1.7f, kBottom, back - 0.3f}, {1.7f, 4.2f, back + 0.05f}, 0.0f, Mapping::kUpright);
}

/// Four slabs about the well, from a curb below the vault to the lid.
void addWell(MeshBuilder& b) {
  const float h = kWellHalf, out = h + 0.35f, low = vaultY(out) - 0.07f, top = kWellTop + 0.05f;
  for (const float side : {-1.0f, 1.0f}) {
    const float x0 = side < 0 ? -out : h, z0 = kWellZ + (side < 0 ? -out : h);
    chamferBox(b, {x0, low, kWellZ - out}, {x0 + 0.35f, top, kWellZ + out}, 0.0f, Mapping::kUpright);
    chamferBox(b, {-out, low, z0}, {out, top, z0 + 0.35f}, 0.0f, Mapping::kUpright);
  }
  chamferBox(b, {-out, kWellTop, kWellZ - out}, {out, kWellTop + 0.3f, kWellZ + out}, 0.0f, Mapping::kUpright);
}

/// The closed chamber outside the round window, in which the second lamp stands.
void addChamber(MeshBuilder& b) {
  const float x0 = kHalfWidth + kThickness - 0.05f, x1 = 8.6f, half = 1.5f, low = 0.9f, high = 4.9f, t = 0.3f;
  const auto box = [&](const glm::vec3& min, const glm::vec3& max) {
    chamferBox(b, min + glm::vec3(0, 0, kWindowZ), max + glm::vec3(0, 0, kWindowZ), 0.0f, Mapping::kUpright);
  };
  box({x0, low - t, -half - t}, {x1 + t, low, half + t});
  box({x0, high, -half - t}, {x1 + t, high + t, half + t});
  box({x0, low - t, -half - t}, {x1 + t, high + t, -half});
  box({x0, low - t, half}, {x1 + t, high + t, half + t});
  box({x1, low - t, -half - t}, {x1 + t, high + t, half + t});
  // Above the long wall's top the chamber needs a front of its own.
  box({x0, kSpring + 0.1f, -half - t}, {x0 + t, high + t, half + t});
}

}  // namespace

void addShell(LevelBuilder& level, const Materials& m) {
  MeshBuilder walls, reveal, ceiling, floor, well, chamber;
  addWalls(walls, reveal);
  addVault(ceiling);
  addWell(well);
  addChamber(chamber);
  const float x = kHalfWidth + kThickness + 0.2f, z = kHalfLength + kThickness + 0.2f;
  chamferBox(floor, {-x, -0.4f, -z}, {x, 0.0f, z}, 0.0f, Mapping::kUpright);
  level.single("shell", {m.rubble.finish(walls), m.dressed.finish(reveal), m.brick.finish(ceiling)});
  level.single("well", {m.brick.finish(well)});
  level.single("chamber", {m.brick.finish(chamber)});
  level.single("floor", {m.paving.finish(floor)});
}

}  // namespace tyndall::levels::vault
