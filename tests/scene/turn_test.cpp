// How cameras and lights are turned: by rotations and mirrorings, whatever the scales.
#include <array>
#include <cmath>
#include <random>

#include <glm/gtc/matrix_transform.hpp>

#include "gltf_file.hpp"

namespace tyndall::scene {
namespace {

struct Random {
  std::mt19937 source{11};
  std::uniform_real_distribution<float> number{-1, 1};
  glm::quat rotation() {
    return glm::normalize(glm::quat(number(source), number(source), number(source), number(source) + 0.1f));
  }
  glm::vec3 sizes() {
    const auto size = [&] { return std::exp2(8 * number(source)); };
    return {size(), size(), size()};
  }
};

/// Three nodes in a row; the last has a sun and a camera.
Scene chain(Random& random) {
  Scene s;
  s.lights = {{}};
  s.cameras = {{}};
  s.nodes.resize(3);
  for (std::size_t i = 0; i < 3; ++i) {
    s.nodes[i].parent = static_cast<std::int32_t>(i) - 1;
    s.nodes[i].rotation = random.rotation();
  }
  s.nodes[2].light = 0;
  s.nodes[2].camera = 0;
  return s;
}

/// Where -Z goes by the rotations of the chain, and by mirrors between them.
glm::vec3 turned(const Scene& s, const std::array<glm::vec3, 3>& mirrors, glm::vec3 v) {
  for (std::size_t i = 3; i-- > 0;) v = s.nodes[i].rotation * (mirrors[i] * v);
  return v;
}

void expectTurned(const Scene& s, double seconds, const std::array<glm::vec3, 3>& mirrors, const std::string& what) {
  const glm::vec3 forward = turned(s, mirrors, {0, 0, -1}), up = turned(s, mirrors, {0, 1, 0});
  const auto lights = placedLights(s, seconds);
  EXPECT_LT(glm::distance(lights.at(0).direction, forward), 1e-5f) << what;
  EXPECT_LT(glm::distance(lights.at(0).worldFromLight[1], up), 1e-5f) << what;
  const glm::mat4 view = placedCameras(s, seconds).at(0).worldFromView;
  EXPECT_LT(glm::distance(-glm::vec3(view[2]), forward), 1e-5f) << what;
  EXPECT_LT(glm::distance(glm::vec3(view[1]), up), 1e-5f) << what;
  EXPECT_NEAR(glm::determinant(glm::mat3(view)), 1, 1e-5) << what;
}

const std::array<glm::vec3, 3> kPlain{glm::vec3(1), glm::vec3(1), glm::vec3(1)};

TEST(Turns, SizesOfScalesDoNotCountAndZeroIsASize) {
  Random random;
  for (int round = 0; round < 20; ++round)
    for (std::size_t node = 0; node < 3; ++node)
      for (unsigned zeros = 0; zeros < 8; ++zeros) {
        Scene s = chain(random);
        for (Node& each : s.nodes) each.scale = random.sizes();
        for (int axis = 0; axis < 3; ++axis)
          if (zeros >> axis & 1) s.nodes[node].scale[axis] = 0;
        expectTurned(s, 0, kPlain, "node " + std::to_string(node) + ", zeros " + std::to_string(zeros));
      }
}

TEST(Turns, NegativeScalesMirror) {
  Random random;
  for (std::size_t node = 0; node < 3; ++node)
    for (unsigned negative = 1; negative < 8; ++negative) {
      Scene s = chain(random);
      std::array<glm::vec3, 3> mirrors = kPlain;
      for (Node& each : s.nodes) each.scale = random.sizes();
      for (int axis = 0; axis < 3; ++axis)
        if (negative >> axis & 1) s.nodes[node].scale[axis] *= -1, mirrors[node][axis] = -1;
      expectTurned(s, 0, mirrors, "node " + std::to_string(node) + ", negative " + std::to_string(negative));
    }
}

TEST(Turns, AScaleMayPassThroughZeroOnItsWay) {
  Random random;
  Scene s = chain(random);
  Animation shrinks;
  shrinks.duration = 2;
  shrinks.channels = {
      {1, AnimationTarget::kScale, Interpolation::kLinear, {0, 1, 2}, {glm::vec4(1), glm::vec4(0), glm::vec4(1)}}};
  s.animations = {shrinks};
  for (const double seconds : {0.0, 0.5, 0.999999, 1.0, 1.000001, 1.7})
    expectTurned(s, seconds, kPlain, std::to_string(seconds) + " s");
}

/// A file with a sun and a camera below a node of this matrix.
Result<Import> below(const glm::mat4& matrix, bool plainParent) {
  GltfFile f;
  f.triangle();
  nlohmann::json numbers = nlohmann::json::array();
  for (int i = 0; i < 16; ++i) numbers.push_back(matrix[i / 4][i % 4]);
  f.json["extensionsUsed"] = {"KHR_lights_punctual"};
  f.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "directional"}}};
  f.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}}};
  f.json["nodes"].push_back({{"matrix", numbers}, {"children", {2}}});
  f.json["nodes"].push_back({{"camera", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  if (plainParent) f.json["nodes"][1].erase("matrix");
  f.json["scenes"] = {{{"nodes", {0, 1}}}};
  return f.load();
}

// A matrix says what it says: a column that is left tells its direction, two tell the third's.
TEST(Turns, AMatrixTellsWhatItHasNotFlattened) {
  Random random;
  for (int round = 0; round < 50; ++round) {
    const glm::mat3 rotation = glm::mat3_cast(random.rotation());
    const glm::vec3 sizes = random.sizes();
    for (unsigned zeros = 0; zeros < 8; ++zeros) {
      glm::mat4 m(1);
      for (int axis = 0; axis < 3; ++axis)
        m[axis] = (zeros >> axis & 1 ? 0.0f : sizes[axis]) * glm::vec4(rotation[axis], 0);
      const auto loaded = below(m, false);
      ASSERT_TRUE(loaded.ok()) << loaded.error().message;
      const bool told = (zeros & 4) == 0 || (zeros & 3) == 0;
      EXPECT_EQ(loaded->warnings.size(), told ? 0u : 2u) << zeros;
      for (const std::string& line : loaded->warnings) {
        EXPECT_NE(line.find("nodes[2]"), std::string::npos) << line;
        EXPECT_NE(line.find("flattens"), std::string::npos) << line;
      }
      const glm::vec3 expected = told ? -rotation[2] : glm::vec3(0, 0, -1);
      EXPECT_LT(glm::distance(placedLights(loaded->scene, 0).at(0).direction, expected), 1e-5f) << zeros;
      EXPECT_LT(glm::distance(-glm::vec3(placedCameras(loaded->scene, 0).at(0).worldFromView[2]), expected), 1e-5f);
    }
  }
  EXPECT_TRUE(below(glm::mat4(0), true)->warnings.empty());
}

}  // namespace
}  // namespace tyndall::scene
