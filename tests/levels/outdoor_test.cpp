// Terrain and tower: the ground has no holes, and masonry keeps the sun out everywhere but at its openings.
#include <gtest/gtest.h>

#include "levels/levels.hpp"
#include "levels/terrain_plan.hpp"
#include "levels/tower_plan.hpp"
#include "triangles.hpp"

namespace tyndall::levels {
namespace {

std::vector<Triangle> named(const scene::Scene& scene, const std::string& name) {
  return trianglesOf(scene, 0, [&](const scene::Node& node) { return node.name == name; });
}

glm::vec3 toSun(const scene::Scene& scene) { return -scene::placedLights(scene, 0).at(0).direction; }

TEST(Terrain, HasGroundEverywhereWhereItsPlanSays) {
  const std::vector<Triangle> ground = named(makeTerrain(), "ground");
  TestRandom random(1);
  const float half = terrain::kHalfSize - 0.5f;
  for (int i = 0; i < 400; ++i) {
    const float reach = i % 2 == 0 ? half : 30.0f;
    const glm::vec3 above = random.inside({-reach, 300, -reach}, {reach, 301, reach});
    const std::optional<float> drop = nearest(ground, above, {0, -1, 0});
    ASSERT_TRUE(drop) << above.x << ' ' << above.z;
    if (i % 2 == 0) continue;
    EXPECT_NEAR(above.y - *drop, terrain::groundY(above.x, above.z), 0.4f) << above.x << ' ' << above.z;
  }
}

/// Bays meet at the piers' middles: rays along the sun within 2 mm of the seams, and anywhere in a pier, are stopped,
/// and so are those straight across; rays through an arch are not.
TEST(Terrain, AqueductIsTightButForItsArches) {
  using namespace terrain;
  const scene::Scene scene = makeTerrain();
  const std::vector<Triangle> stone = named(scene, "aqueduct");
  const glm::vec3 sun = toSun(scene);
  TestRandom random(2);
  for (int i = 0; i < 1500; ++i) {
    const float seam = (static_cast<float>(i % (kBays - 1) + 1) - 0.5f * kBays) * kBay;
    const glm::vec3 at(kAqueductX, random.range(1.0f, kLowerTop),
                       seam + (i % 2 == 0 ? 0.002f : 0.6f) * random.range(-1, 1));
    ASSERT_TRUE(blocked(stone, at - 20.0f * sun, sun)) << at.y << ' ' << at.z;
    const glm::vec3 across{1, 0, 0};  // straight through: the slanting sun would hit the next bay's side
    ASSERT_TRUE(blocked(stone, at - 20.0f * across, across)) << at.y << ' ' << at.z;
  }
  int open = 0;
  for (int i = 0; i < 500; ++i) {
    const float middle = (static_cast<float>(i % kBays) + 0.5f - 0.5f * kBays) * kBay;
    const glm::vec3 at(kAqueductX, random.range(3.0f, 6.5f), middle + random.range(-1.2f, 1.2f));
    open += blocked(stone, at - 20.0f * sun, sun) ? 0 : 1;
  }
  EXPECT_GT(open, 490);
}

TEST(Tower, IsSolidBelowTheBelfryAndOpenThere) {
  using namespace tower;
  const scene::Scene scene = makeTower();
  const std::vector<Triangle> body = named(scene, "tower"), belfry = named(scene, "belfry");
  const glm::vec3 sun = toSun(scene);
  TestRandom random(3);
  const auto stopped = [&](const glm::vec3& at) {
    return blocked(body, at - 30.0f * sun, sun) || blocked(belfry, at - 30.0f * sun, sun);
  };
  // Edge on: within 2 mm of the joints between shaft, belfry and cap, and of the tower's corners.
  for (int i = 0; i < 1200; ++i) {
    const float joint = i % 2 == 0 ? kBelfry : kBelfryTop;
    ASSERT_TRUE(stopped({random.range(-kHalf + 0.05f, kHalf - 0.05f), joint + 0.002f * random.range(-1, 1), 0}))
        << joint;
    const float corner = (i % 2 == 0 ? -1.0f : 1.0f) * (kHalf - random.range(0.01f, 0.5f));
    const glm::vec3 at{corner, random.range(kBelfry + 1.2f, kBelfryTop - 0.1f), 0};
    ASSERT_TRUE(stopped(at)) << corner;
    ASSERT_TRUE(blocked(belfry, at + glm::vec3(0, 0, 20), {0, 0, -1})) << corner;
    ASSERT_TRUE(stopped(random.inside({-2.6f, 0.5f, 0}, {2.6f, kBelfry - 1.1f, 0})));
  }
  int open = 0;
  for (int i = 0; i < 1000; ++i) {
    open += stopped(random.inside({-kOpeningHalf, 12.2f, 0}, {kOpeningHalf, 13.4f, 0})) ? 0 : 1;
  }
  EXPECT_GT(open, 100);  // what trestle, mullion, tracery and balustrades leave
  EXPECT_LT(open, 600);  // openwork, not a hole
}

}  // namespace
}  // namespace tyndall::levels
