// What surfaces see of the sky: closed rooms are dark, open floors bright, and between them what rays say.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "stage.hpp"

namespace tyndall::render::test {
namespace {

// Only the night sky: nothing else lights these levels.
class Sky : public FrameTest {
 protected:
  Shot shoot(const scene::Scene& scene, const scene::CameraView& camera, float strength = 1) {
    Stage::Options options;
    options.settings.skyStrength = strength;
    return stage().render(scene, camera, {}, options);
  }
  static void castNothing(scene::Scene& scene) {
    for (scene::Node& node : scene.nodes) node.castsShadow = false;
  }
};

Level box(float side) {
  Level level;
  const std::int32_t grey = level.material(Level::grey(180));
  const glm::vec3 x(side, 0, 0), y(0, side, 0), z(0, 0, side);
  level.quad(-y, z, x, grey), level.quad(y, x, z, grey);
  level.quad(-x, y, z, grey), level.quad(x, z, y, grey);
  level.quad(-z, x, y, grey), level.quad(z, y, x, grey);
  return level;
}

double mean(const Shot& shot) {
  double sum = 0;
  for (const glm::vec4& c : shot.color) sum += c.g;
  return sum / static_cast<double>(shot.color.size());
}

TEST_F(Sky, LeavesAClosedRoomDark) {
  for (const float ground : {0.0f, 500.0f}) {
    Level level = box(3);
    if (ground > 0) level.quad({0, -3.2f, 0}, {0, 0, ground}, {ground, 0, 0}, 0);
    for (const glm::vec3 target : {glm::vec3(-3, -3, -3), glm::vec3(3, 0, 1), glm::vec3(0, 3, -2)}) {
      const scene::CameraView camera = lookAt({0.3f, 0.2f, 0.1f}, target, 1.5f);
      const double dark = mean(shoot(level.scene, camera));
      scene::Scene open = level.scene;
      castNothing(open);
      const double bright = mean(shoot(open, camera));
      EXPECT_GT(bright, 1e-4);
      EXPECT_LT(dark, 1e-3 * bright) << ground;
    }
  }
}

TEST_F(Sky, LightsAnOpenFloorWhollyAndInProportion) {
  Level level;
  level.quad({0, 0, 0}, {0, 0, 40}, {40, 0, 0}, level.material(Level::grey(180)));
  const scene::CameraView camera = lookAt({0, 3, 6}, {0, 0, 0});
  scene::Scene open = level.scene;
  castNothing(open);
  const double bright = mean(shoot(open, camera)), lit = mean(shoot(level.scene, camera));
  EXPECT_NEAR(lit / bright, 1, 0.02);
  EXPECT_NEAR(mean(shoot(level.scene, camera, 7)) / lit, 7, 1e-3);
  EXPECT_EQ(mean(shoot(level.scene, camera, 0)), 0);
}

// Visibility of the cosine-weighted sky beside a wall of height h and endless length, at distance d from its foot: the
// wall's form factor is (1 - cos a) / 2 with tan a = h / d.
TEST_F(Sky, BesideAWallIsWhatItsFormFactorLeaves) {
  Level level;
  const std::int32_t grey = level.material(Level::grey(180));
  level.quad({0, 0, 0}, {0, 0, 60}, {60, 0, 0}, grey);
  level.quad({0, 2, 0}, {0, 0, 60}, {0, 2, 0}, grey);
  const scene::CameraView camera = lookAt({4, 9, 0.1f}, {3, 0, 0}, 1.2f);
  const Shot shot = shoot(level.scene, camera);
  scene::Scene open = level.scene;
  castNothing(open);
  const Shot bright = shoot(open, camera);
  double last = 0;
  for (const float d : {1.0f, 2.0f, 4.0f, 7.0f}) {
    const double seen = radianceAt(camera, shot, {d, 0, 0}).g / radianceAt(camera, bright, {d, 0, 0}).g;
    EXPECT_NEAR(seen, 1 - 0.5 * (1 - d / std::hypot(4.0, d)), 0.09) << d;
    EXPECT_GE(seen, last);
    last = seen;
  }
}

TEST_F(Sky, KeptMapsAreDrawnAgainOnlyWhenACasterMoves) {
  Level level;
  const std::int32_t grey = level.material(Level::grey(180));
  level.quad({0, 0, 0}, {0, 0, 8}, {8, 0, 0}, grey);
  level.quad({0, 1, 0}, {0, 0, 3}, {3, 0, 0}, grey);
  const scene::CameraView camera = lookAt({0, 0.5f, 6}, {0, 0, 0});
  const auto draws = [](const Shot& shot) {
    return std::count_if(shot.passes.begin(), shot.passes.end(),
                         [](const PassTime& pass) { return pass.name == "sky maps"; });
  };
  const Shot first = shoot(level.scene, camera);
  Stage::Options again;
  again.upload = false;
  const Shot still = stage().render(level.scene, camera, {}, again);
  again.worldFromNode = scene::worldMatrices(level.scene, 0);
  (*again.worldFromNode)[1] = glm::translate(glm::mat4(1), glm::vec3(0, 40, 0));
  const Shot moved = stage().render(level.scene, camera, {}, again);
  EXPECT_EQ(draws(first), 1);
  EXPECT_EQ(draws(still), 0);
  EXPECT_EQ(draws(moved), 1);
  EXPECT_EQ(still.color, first.color);
  const double before = radianceAt(camera, first, {0, 0, 0}).g;
  EXPECT_GT(radianceAt(camera, moved, {0, 0, 0}).g, 3 * before);
}

}  // namespace
}  // namespace tyndall::render::test
