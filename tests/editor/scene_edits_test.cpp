// Edits of a level: read, put back, moved and turned in the world whatever the parents are.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "node_motion.hpp"

namespace tyndall::editor {
namespace {

/// Two nodes that share a lamp: one has a matrix; the other hangs on a parent that is turned by 90 degrees about y and
/// scaled by 2. The last hangs on a mirrored one.
scene::Scene makeScene() {
  scene::Scene scene;
  scene.lights.resize(1);
  scene.lights[0].kind = scene::LightKind::kPoint;
  scene.materials.resize(2);
  scene.nodes.resize(5);
  scene.nodes[0].light = 0, scene.nodes[0].matrix = glm::translate(glm::mat4(1), glm::vec3(1, 2, 3));
  scene.nodes[1].rotation = glm::angleAxis(glm::radians(90.0f), glm::vec3(0, 1, 0)),
  scene.nodes[1].scale = glm::vec3(2);
  scene.nodes[2].light = 0, scene.nodes[2].parent = 1, scene.nodes[2].translation = {1, 0, 0};
  scene.nodes[3].rotation = glm::angleAxis(0.7f, glm::normalize(glm::vec3(1, 2, 3))),
  scene.nodes[3].scale = glm::vec3(-1.5f, 1.5f, 1.5f);
  scene.nodes[4].parent = 3, scene.nodes[4].translation = {0.5f, 1, 2};
  separateLights(scene);
  return scene;
}

glm::vec3 positionOf(const scene::Scene& scene, int node) {
  return glm::vec3(scene::worldMatrices(scene, 0)[static_cast<std::size_t>(node)][3]);
}

TEST(SceneEdits, SharedLightsAreEditedApartAndTheFileComesBack) {
  scene::Scene scene = makeScene();
  ASSERT_EQ(scene.lights.size(), 2u);
  const SceneFile file = fileOf(scene);
  ASSERT_EQ(file.lights.size(), 2u);
  EXPECT_EQ(file.nodes[0].position(), glm::vec3(1, 2, 3));
  EXPECT_TRUE(editsOf(scene, file).empty());
  LightEdit light = file.lights.at(2);
  light.intensity = 7;
  setLight(scene, 2, light);
  NodeEdit place = file.nodes[0];
  place.setPosition({4, 5, 6});
  setNode(scene, 0, place);
  NodeEdit scaled = file.nodes[3];
  scaled.scale = {-1.5f, 3, 1.5f};
  setNode(scene, 3, scaled);
  MaterialEdit material = file.materials[1];
  material.roughness = 0.25f;
  setMaterial(scene, 1, material);
  EXPECT_EQ(scene::placedLights(scene, 0)[1].light.intensity, 7);
  EXPECT_EQ(scene::placedLights(scene, 0)[0].light.intensity, 1);
  EXPECT_EQ(positionOf(scene, 0), glm::vec3(4, 5, 6));
  EXPECT_EQ(scene.materials[1].roughness, 0.25f);
  EXPECT_EQ(scene.nodes[3].scale, glm::vec3(-1.5f, 3, 1.5f));
  const SceneEdits changed = editsOf(scene, file);
  EXPECT_EQ(changed.lights.size(), 1u);
  EXPECT_EQ(changed.nodes.size(), 2u);
  EXPECT_EQ(changed.materials.size(), 1u);
  applyEdits(scene, file, {});
  EXPECT_TRUE(editsOf(scene, file).empty());
  applyEdits(scene, file, changed);
  EXPECT_EQ(editsOf(scene, file), changed);
}

TEST(SceneEdits, AStepInTheWorldIsThatStepWhateverTheParent) {
  scene::Scene scene = makeScene();
  for (const int node : {0, 2, 4})
    for (const glm::vec3 step : {glm::vec3(1, 0, 0), glm::vec3(0, -2, 0), glm::vec3(0.5f, 1, 3)}) {
      const auto world = scene::worldMatrices(scene, 0);
      const glm::vec3 before = positionOf(scene, node);
      setNode(scene, node, moved(nodeAt(scene, node), worldFromParent(scene, world, node), step));
      EXPECT_LT(glm::distance(positionOf(scene, node) - before, step), 1e-5f) << node;
    }
}

TEST(SceneEdits, ATurnInTheWorldIsThatTurnWhateverTheParent) {
  const glm::quat turn = glm::angleAxis(0.6f, glm::normalize(glm::vec3(1, -2, 0.5f)));
  const glm::vec3 pivot(2, 1, -1);
  for (const int node : {0, 1, 2, 4}) {
    scene::Scene scene = makeScene();
    const auto before = scene::worldMatrices(scene, 0);
    setNode(scene, node, turned(nodeAt(scene, node), worldFromParent(scene, before, node), pivot, turn));
    const auto after = scene::worldMatrices(scene, 0);
    for (const glm::vec3 p : {glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0.3f, -2, 5)}) {
      const glm::vec3 was(before[static_cast<std::size_t>(node)] * glm::vec4(p, 1));
      const glm::vec3 is(after[static_cast<std::size_t>(node)] * glm::vec4(p, 1));
      EXPECT_LT(glm::distance(is, pivot + turn * (was - pivot)), 2e-5f) << node;
    }
  }
}

TEST(SceneEdits, TheShortestTurnGoesWhereItShould) {
  const glm::vec3 from(0, 0, -1);
  for (const glm::vec3 to : {glm::vec3(0, 0, -1), glm::vec3(0, 0, 1), glm::vec3(0, 1, 0), glm::vec3(0.6f, -0.8f, 0),
                             glm::normalize(glm::vec3(0.001f, 0, 1))}) {
    EXPECT_LT(glm::distance(turnBetween(from, to) * from, to), 5e-4f);
    EXPECT_LT(glm::distance(directionOf(headingOf(to)), to), 1e-5f);
  }
  EXPECT_FLOAT_EQ(headingOf({1, 0, 0}).azimuth, glm::radians(90.0f));
}

TEST(SceneEdits, AFlatParentLeadsNowhere) {
  const NodeEdit node{.translation = {1, 2, 3}};
  const glm::mat4 flat = glm::scale(glm::mat4(1), glm::vec3(1, 0, 1));
  EXPECT_EQ(moved(node, flat, {1, 1, 1}), node);
  EXPECT_EQ(turned(node, flat, {}, glm::angleAxis(1.0f, glm::vec3(0, 1, 0))), node);
}

TEST(SceneEdits, AnAnimatedPlaceIsNotTheHands) {
  using Target = scene::AnimationTarget;
  scene::Scene scene = makeScene();
  EXPECT_FALSE(isAnimated(scene, 2, Target::kTranslation));
  scene.animations.resize(1);
  scene.animations[0].channels.resize(1);
  scene.animations[0].channels[0].node = 2, scene.animations[0].channels[0].target = Target::kRotation;
  EXPECT_FALSE(isAnimated(scene, 2, Target::kTranslation));
  EXPECT_TRUE(isAnimated(scene, 2, Target::kRotation));
  EXPECT_FALSE(isAnimated(scene, 1, Target::kRotation));
}

}  // namespace
}  // namespace tyndall::editor
