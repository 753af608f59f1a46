// Node transforms and their animation against closed forms.
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "gltf_file.hpp"

namespace tyndall::scene {
namespace {

constexpr float kPi = 3.14159265f;

Scene oneNode(AnimationChannel channel, float duration) {
  Scene s;
  s.nodes.resize(1);
  channel.node = 0;
  s.animations = {{"", duration, {std::move(channel)}}};
  return s;
}
glm::vec3 translationAt(const Scene& s, double t) { return glm::vec3(worldMatrices(s, t)[0][3]); }

// Sound keys a very long time apart: the tangents between them lead past what a float holds.
TEST(Animations, WhatASplineYieldsIsSoundAtEveryTime) {
  GltfFile file;
  file.triangle();
  const int times = file.floats({0, 1e30f}, "SCALAR");
  const float m = 1e9f;
  const int values = file.floats({m, -m, m, 0, 0, 0, m, m, -m, m, -m, m, 1, 2, 3, m, m, -m}, "VEC3");
  file.json["animations"] = {{{"samplers", {{{"input", times}, {"output", values}, {"interpolation", "CUBICSPLINE"}}}},
                              {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}};
  const auto loaded = file.load();
  ASSERT_TRUE(loaded.ok()) << loaded.error().message;
  ASSERT_EQ(loaded->warnings.size(), 1u);
  EXPECT_NE(loaded->warnings[0].find("lead too far"), std::string::npos) << loaded->warnings[0];
  for (const double seconds : {0.0, 0.5, 1.0, 1e9, 3e29})
    for (const glm::mat4& world : worldMatrices(loaded->scene, seconds))
      for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) EXPECT_LE(std::abs(world[c][r]), 1e9f) << seconds;
}

TEST(Transforms, ComposeAsTranslationRotationScale) {
  Scene s;
  s.nodes.resize(2);
  s.nodes[0].translation = {10, 0, 0};
  s.nodes[0].rotation = glm::angleAxis(kPi / 2, glm::vec3(0, 1, 0));  // +x goes to -z
  s.nodes[0].scale = {2, 2, 2};
  s.nodes[1].parent = 0;
  s.nodes[1].translation = {1, 0, 0};
  const glm::vec3 p(worldMatrices(s, 0)[1] * glm::vec4(1, 0, 0, 1));
  // 1 + 1 along the child's x, doubled, turned to -z, moved by 10.
  EXPECT_LT(glm::distance(p, glm::vec3(10, 0, -4)), 1e-5f);
}

TEST(Transforms, MatrixReplacesTrs) {
  Scene s;
  s.nodes.resize(1);
  s.nodes[0].translation = {9, 9, 9};
  s.nodes[0].matrix = glm::translate(glm::mat4(1), glm::vec3(1, 2, 3));
  EXPECT_EQ(glm::vec3(worldMatrices(s, 0)[0][3]), glm::vec3(1, 2, 3));
}

TEST(Transforms, DeepChainsNeedNoStack) {
  Scene s;
  s.nodes.resize(200'000);
  for (std::size_t i = 0; i < s.nodes.size(); ++i) {
    s.nodes[i].parent = static_cast<std::int32_t>(i) - 1;
    s.nodes[i].translation.x = 1;
  }
  EXPECT_FLOAT_EQ(worldMatrices(s, 0).back()[3].x, 200'000);
}

TEST(Animation, LinearStepAndEnds) {
  const std::vector<glm::vec4> values = {{0, 0, 0, 0}, {4, 0, 0, 0}, {4, 8, 0, 0}};
  const Scene linear = oneNode({0, AnimationTarget::kTranslation, Interpolation::kLinear, {1, 2, 4}, values}, 8);
  EXPECT_EQ(translationAt(linear, 0), glm::vec3(0));  // before the first key
  EXPECT_LT(glm::distance(translationAt(linear, 1.25), glm::vec3(1, 0, 0)), 1e-6f);
  EXPECT_LT(glm::distance(translationAt(linear, 3.5), glm::vec3(4, 6, 0)), 1e-6f);
  EXPECT_EQ(translationAt(linear, 5), glm::vec3(4, 8, 0));  // after the last
  const Scene step = oneNode({0, AnimationTarget::kTranslation, Interpolation::kStep, {1, 2, 4}, values}, 8);
  EXPECT_EQ(translationAt(step, 1.99), glm::vec3(0));
  EXPECT_EQ(translationAt(step, 2), glm::vec3(4, 0, 0));
  EXPECT_EQ(translationAt(step, 3.99), glm::vec3(4, 0, 0));
}

TEST(Animation, ATimeThatIsNoneIsTheFirst) {
  const Scene s =
      oneNode({0, AnimationTarget::kTranslation, Interpolation::kLinear, {0, 2}, {{7, 0, 0, 0}, {2, 0, 0, 0}}}, 2);
  for (const double t : {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e308}) {
    const float x = translationAt(s, t).x;
    EXPECT_TRUE(x >= 2 && x <= 7) << t;
  }
}

// Scales of a chain of nodes, each within its limit, that together lead out of sight: a camera that frames the level
// has a place all the same.
TEST(Animation, BoundsHoldWhatIsInReach) {
  GltfFile file;
  file.triangle();
  auto loaded = file.load();
  ASSERT_TRUE(loaded.ok()) << loaded.error().message;
  Scene s = std::move(loaded->scene);
  const Bounds before = worldBounds(s, worldMatrices(s, 0));
  Node far = s.nodes[0];
  far.matrix.reset();
  for (const float scale : {1e8f, 1e38f}) {
    s.nodes.push_back(far);
    s.nodes.back().scale = glm::vec3(scale);
    s.nodes.back().translation = glm::vec3(scale);
  }
  const Bounds bounds = worldBounds(s, worldMatrices(s, 0.5));
  EXPECT_FALSE(bounds.empty());
  EXPECT_LE(glm::length(bounds.max - bounds.min), 4e9f);
  EXPECT_LE(bounds.min.x, before.min.x);
}

TEST(Animation, LoopsByItsDuration) {
  const Scene s =
      oneNode({0, AnimationTarget::kTranslation, Interpolation::kLinear, {0, 2}, {{0, 0, 0, 0}, {2, 0, 0, 0}}}, 2);
  for (const double t : {0.5, 2.5, 200.5, -1.5}) EXPECT_NEAR(translationAt(s, t).x, 0.5, 1e-5) << t;
}

TEST(Animation, CubicSplineReproducesACubic) {
  // A Hermite segment with the true end slopes is the cubic itself: x(t) = t^3 - 2t, x' = 3t^2 - 2, on [1, 3].
  const auto x = [](float t) { return t * t * t - 2 * t; };
  const auto slope = [](float t) { return 3 * t * t - 2; };
  const Scene s = oneNode(
      {0,
       AnimationTarget::kTranslation,
       Interpolation::kCubicSpline,
       {1, 3},
       {{99, 0, 0, 0}, {x(1), 0, 0, 0}, {slope(1), 0, 0, 0}, {slope(3), 0, 0, 0}, {x(3), 0, 0, 0}, {99, 0, 0, 0}}},
      3);
  for (float t = 1; t < 3; t += 0.125f) EXPECT_NEAR(translationAt(s, t).x, x(t), 1e-4f) << t;
}

TEST(Animation, RotationTurnsEvenlyTheShorterWay) {
  // From 0 to 90 degrees about y, the second quaternion with the opposite sign: still the shorter way.
  const float h = kPi / 4;
  const Scene s = oneNode({0,
                           AnimationTarget::kRotation,
                           Interpolation::kLinear,
                           {0, 1},
                           {{0, 0, 0, 1}, {0, -std::sin(h), 0, -std::cos(h)}}},
                          2);
  for (float t = 0; t <= 1; t += 0.125f) {
    const glm::vec3 x(worldMatrices(s, t)[0][0]);
    const float angle = t * kPi / 2;
    EXPECT_LT(glm::distance(x, glm::vec3(std::cos(angle), 0, -std::sin(angle))), 1e-5f) << t;
  }
}

TEST(Animation, ReadFromAFileWithItsDefects) {
  GltfFile f;
  f.triangle();
  const int input = f.floats({0, 1, 1, 2}, "SCALAR");  // the third key does not advance
  const int output = f.floats({0, 0, 0, 1, 0, 0, 5, 5, 5, 2, 0, 0}, "VEC3");
  f.json["animations"] = {{{"samplers", {{{"input", input}, {"output", output}}}},
                           {"channels",
                            {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}},
                             {{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}}}};
  auto loaded = f.load();
  ASSERT_TRUE(loaded.ok()) << loaded.error().message;
  EXPECT_EQ(loaded->warnings.size(), 2u);
  ASSERT_EQ(loaded->scene.animations.size(), 1u);
  EXPECT_EQ(loaded->scene.animations[0].channels[0].times, (std::vector<float>{0, 1, 2}));
  EXPECT_NEAR(translationAt(loaded->scene, 1.5).x, 1.5, 1e-6);
}

}  // namespace
}  // namespace tyndall::scene
