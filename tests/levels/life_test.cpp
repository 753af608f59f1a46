// The animations: something that casts a shadow moves, the tour's camera runs into nothing, and both loop.
#include <gtest/gtest.h>

#include "levels/hall_plan.hpp"
#include "levels/levels.hpp"
#include "triangles.hpp"

namespace tyndall::levels {
namespace {

float change(const glm::mat4& a, const glm::mat4& b) {
  float most = 0;
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) most = glm::max(most, glm::abs(a[c][r] - b[c][r]));
  }
  return most;
}

/// How far the mesh's bounds are carried between two poses, metres.
float travel(const scene::Scene& scene, const scene::Node& node, const glm::mat4& a, const glm::mat4& b) {
  float most = 0;
  for (const scene::Primitive& p : scene.meshes[node.mesh].primitives) {
    for (const glm::vec3& corner : {p.bounds.min, p.bounds.max})
      most = glm::max(most, glm::length(glm::vec3((a - b) * glm::vec4(corner, 1))));
  }
  return most;
}

TEST(Life, CastersMoveAndComeBack) {
  for (const Sample& sample : kSamples) {
    const scene::Scene scene = sample.make();
    SCOPED_TRACE(scene.name);
    const double duration = scene.animations.at(0).duration;
    ASSERT_GT(duration, 5);
    for (const scene::AnimationChannel& channel : scene.animations[0].channels)
      EXPECT_FLOAT_EQ(channel.times.back(), scene.animations[0].duration);
    const auto rest = scene::worldMatrices(scene, 0), again = scene::worldMatrices(scene, duration);
    float most = 0;
    for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
      EXPECT_LT(change(rest[n], again[n]), 1e-3f) << scene.nodes[n].name;
      if (scene.nodes[n].mesh == scene::kNone) continue;
      for (double t = 0; t < duration; t += 0.25)
        most = glm::max(most, travel(scene, scene.nodes[n], rest[n], scene::worldMatrices(scene, t)[n]));
      if (most > 0.3f) break;
    }
    EXPECT_GT(most, 0.3f);
  }
}

/// The tour's camera keeps half a metre from everything but undergrowth, in 26 directions, all the way.
void expectClearTour(const scene::Scene& scene) {
  const auto solid = [](const scene::Node& n) { return n.name != "undergrowth" && n.name != "bush"; };
  const std::vector<Triangle> triangles = trianglesOf(scene, 0, solid);
  for (double t = 0; t < scene.animations.at(0).duration; t += 0.8) {
    const glm::vec3 eye(scene::placedCameras(scene, t).at(3).worldFromView[3]);
    float least = 1e9f;
    for (int k = 0; k < 27; ++k) {
      if (k == 13) continue;
      const glm::vec3 direction = glm::normalize(glm::vec3(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1));
      least = glm::min(least, nearest(triangles, eye, direction).value_or(1e9f));
    }
    EXPECT_GT(least, 0.5f) << "at " << t << " s: " << eye.x << ' ' << eye.y << ' ' << eye.z;
  }
}

TEST(Life, TheHallsTourIsClear) { expectClearTour(makeHall()); }
TEST(Life, TheForestsTourIsClear) { expectClearTour(makeForest()); }
TEST(Life, TheVaultsTourIsClear) { expectClearTour(makeVault()); }
TEST(Life, TheCagesTourIsClear) { expectClearTour(makeCage()); }
TEST(Life, TheTownsTourIsClear) { expectClearTour(makeTown()); }
TEST(Life, TheLatticesTourIsClear) { expectClearTour(makeLattice()); }

TEST(Life, TheTerrainsTourIsClear) { expectClearTour(makeTerrain()); }
TEST(Life, TheTowersTourIsClear) { expectClearTour(makeTower()); }

TEST(Life, TheHallsTourStaysInTheHall) {
  const scene::Scene scene = makeHall();
  for (double t = 0; t < scene.animations.at(0).duration; t += 0.1) {
    const glm::vec3 eye(scene::placedCameras(scene, t).at(3).worldFromView[3]);
    EXPECT_LT(glm::abs(eye.x), hall::kHalfWidth - 0.8f);
    EXPECT_LT(glm::abs(eye.z), hall::kHalfLength - 0.8f);
    EXPECT_GT(eye.y, 1.0f);
    EXPECT_LT(eye.y, 7.0f);
  }
}

}  // namespace
}  // namespace tyndall::levels
