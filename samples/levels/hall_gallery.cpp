// The gallery at the +z end and its stairs along the north wall.
#include "hall_parts.hpp"
#include "hall_textures.hpp"
#include "shapes.hpp"

namespace tyndall::levels::hall {
namespace {

constexpr float kStairOuter = -kHalfWidth + 0.02f, kStairInner = -5.6f;
constexpr int kSteps = 16;
constexpr float kRise = kGalleryY / static_cast<float>(kSteps), kRun = 0.3f;

void baluster(MeshBuilder& wood, const glm::vec3& foot, float height) {
  const glm::mat4 before = wood.frame;
  wood.frame = before * placed(foot);
  const float h = height;
  lathe(wood,
        {{0.03f, 0},
         {0.03f, 0.1f * h},
         {0.022f, 0.14f * h},
         {0.045f, 0.34f * h},
         {0.04f, 0.45f * h},
         {0.02f, 0.78f * h},
         {0.03f, 0.9f * h},
         {0.03f, h}},
        8);
  wood.frame = before;
}

void addDeck(MeshBuilder& boards, MeshBuilder& wood) {
  const float end = kHalfLength + 0.1f, wide = kHalfWidth + 0.1f;
  chamferBox(boards, {-wide, kGalleryY - 0.08f, kGalleryZ}, {wide, kGalleryY, end}, 0.0f);
  beam(wood, {-wide, kGalleryY - 0.26f, kGalleryZ + 0.18f}, {wide, kGalleryY - 0.26f, kGalleryZ + 0.18f}, 0.3f, 0.36f);
  for (float x = -6.4f; x < 6.5f; x += 0.8f)
    beam(wood, {x, kGalleryY - 0.18f, kGalleryZ + 0.1f}, {x, kGalleryY - 0.18f, end}, 0.12f, 0.2f, 0.01f);
  for (const float x : {-5.3f, -1.8f, 1.8f, 5.3f}) {
    wood.uvOffset = {x, 0.3f * x};
    chamferBox(wood, {x - 0.14f, -0.05f, kGalleryZ + 0.04f}, {x + 0.14f, kGalleryY - 0.1f, kGalleryZ + 0.32f}, 0.03f);
    for (const float side : {-1.0f, 1.0f}) {
      beam(wood, {x, kGalleryY - 1.3f, kGalleryZ + 0.18f}, {x + side * 0.95f, kGalleryY - 0.35f, kGalleryZ + 0.18f},
           0.14f, 0.14f);
    }
  }
}

void addRail(MeshBuilder& wood) {
  const float from = kStairInner + 0.05f, to = kHalfWidth, z = kGalleryZ + 0.12f;
  beam(wood, {from, kGalleryY + 0.98f, z}, {to, kGalleryY + 0.98f, z}, 0.12f, 0.08f, 0.02f);
  beam(wood, {from, kGalleryY + 0.08f, z}, {to, kGalleryY + 0.08f, z}, 0.1f, 0.08f, 0.01f);
  for (const float x : {from, -1.8f, 1.8f, to - 0.1f})
    chamferBox(wood, {x - 0.07f, kGalleryY - 0.1f, z - 0.07f}, {x + 0.07f, kGalleryY + 1.12f, z + 0.07f}, 0.015f);
  for (float x = from + 0.25f; x < to - 0.2f; x += 0.25f) baluster(wood, {x, kGalleryY + 0.1f, z}, 0.86f);
}

void addStairs(MeshBuilder& boards, MeshBuilder& wood) {
  Random random(55);
  const float foot = kGalleryZ - kRun * real(kSteps);
  for (int i = 0; i < kSteps; ++i) {
    const float y = kRise * real(i + 1), z = foot + kRun * real(i);
    boards.uvOffset = {random.unit() * 2, random.unit() * 2};
    chamferBox(boards, {kStairOuter, y - 0.06f, z - 0.03f}, {kStairInner, y, z + kRun + 0.02f}, 0.012f);
  }
  const glm::vec3 low{0, -0.05f, foot - 0.1f}, high{0, kGalleryY - 0.25f, kGalleryZ};
  for (const float x : {kStairOuter + 0.05f, kStairInner - 0.05f})
    beam(wood, low + glm::vec3(x, 0, 0), high + glm::vec3(x, 0, 0), 0.1f, 0.34f);
  const glm::vec3 up{kStairInner - 0.05f, 1.0f, 0};
  beam(wood, glm::vec3(0, kRise, foot + 0.1f) + up, glm::vec3(0, kGalleryY, kGalleryZ) + up, 0.09f, 0.08f);
  for (int i = 0; i <= kSteps; i += 2) {
    const float y = kRise * real(i), z = foot + kRun * real(i);
    if (i == 0 || i == kSteps) {
      chamferBox(wood, {kStairInner - 0.12f, y - 0.05f, z - 0.07f + 0.1f}, {kStairInner + 0.02f, y + 1.2f, z + 0.17f},
                 0.015f);
    } else {
      baluster(wood, {kStairInner - 0.05f, y + 0.05f, z + 0.1f}, 0.98f);
    }
  }
}

}  // namespace

void addGallery(LevelBuilder& level, const Materials& m) {
  MeshBuilder boards, wood;
  addDeck(boards, wood);
  addRail(wood);
  addStairs(boards, wood);
  level.single("gallery", {boards.finish(m.planks, kWoodTile), wood.finish(m.timber, kWoodTile)});
}

}  // namespace tyndall::levels::hall
