#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "light_scene.hpp"

namespace tyndall::editor {
namespace {

/// Two nodes that share a lamp; the second hangs on a parent that is turned by 90 degrees about y and scaled by 2.
scene::Scene makeScene() {
  scene::Scene scene;
  scene.lights.resize(1);
  scene.lights[0].kind = scene::LightKind::kPoint;
  scene.nodes.resize(3);
  scene.nodes[0].light = 0, scene.nodes[0].matrix = glm::translate(glm::mat4(1), glm::vec3(1, 2, 3));
  scene.nodes[1].rotation = glm::angleAxis(glm::radians(90.0f), glm::vec3(0, 1, 0)),
  scene.nodes[1].scale = glm::vec3(2);
  scene.nodes[2].light = 0, scene.nodes[2].parent = 1, scene.nodes[2].translation = {1, 0, 0};
  return scene;
}

TEST(Lights, SharedOnesAreEditedApartAndTheFileComesBack) {
  scene::Scene scene = makeScene();
  separateLights(scene);
  ASSERT_EQ(scene.lights.size(), 2u);
  const LightEdits file = lightsOf(scene);
  ASSERT_EQ(file.size(), 2u);
  EXPECT_EQ(file.at(0).translation, glm::vec3(1, 2, 3));
  EXPECT_TRUE(changedLights(scene, file).empty());
  LightEdit edit = file.at(2);
  edit.intensity = 7, edit.translation.y = 5;
  setLight(scene, 2, edit);
  EXPECT_EQ(scene::placedLights(scene, scene::worldMatrices(scene, 0))[1].light.intensity, 7);
  EXPECT_EQ(scene::placedLights(scene, scene::worldMatrices(scene, 0))[0].light.intensity, 1);
  const LightEdits changed = changedLights(scene, file);
  ASSERT_EQ(changed.size(), 1u);
  applyLights(scene, file, {});
  EXPECT_EQ(lightsOf(scene), file);
  applyLights(scene, file, changed);
  EXPECT_EQ(changedLights(scene, file), changed);
}

TEST(Lights, AStepInTheWorldIsThatStepWhateverTheParent) {
  scene::Scene scene = makeScene();
  separateLights(scene);
  for (const int node : {0, 2})
    for (const glm::vec3 step : {glm::vec3(1, 0, 0), glm::vec3(0, -2, 0), glm::vec3(0.5f, 1, 3)}) {
      const auto before = scene::worldMatrices(scene, 0);
      LightEdit edit = lightsOf(scene).at(node);
      edit.translation += localStep(scene, before, node, step);
      setLight(scene, node, edit);
      const glm::vec3 moved = glm::vec3(scene::worldMatrices(scene, 0)[static_cast<std::size_t>(node)][3] -
                                        before[static_cast<std::size_t>(node)][3]);
      EXPECT_LT(glm::distance(moved, step), 1e-5f) << node;
    }
}

TEST(Lights, AnAnimatedPlaceIsNotTheHands) {
  scene::Scene scene = makeScene();
  EXPECT_FALSE(isMoved(scene, 2));
  scene.animations.resize(1);
  scene.animations[0].channels.resize(1);
  scene.animations[0].channels[0].node = 2, scene.animations[0].channels[0].target = scene::AnimationTarget::kRotation;
  EXPECT_FALSE(isMoved(scene, 2));
  scene.animations[0].channels[0].target = scene::AnimationTarget::kTranslation;
  EXPECT_TRUE(isMoved(scene, 2));
}

}  // namespace
}  // namespace tyndall::editor
