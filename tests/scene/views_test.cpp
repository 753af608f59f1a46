// Cameras, lights and the ones made up for files without them: physical facts.
#include <cmath>
#include <random>

#include <glm/gtc/matrix_transform.hpp>

#include "gltf_file.hpp"

namespace tyndall::scene {
namespace {

constexpr float kPi = 3.14159265f;

void expectRigid(const glm::mat4& m) {
  const glm::mat3 r(m);
  const glm::mat3 identity = glm::transpose(r) * r;
  for (int c = 0; c < 3; ++c)
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(identity[c][k], c == k ? 1 : 0, 1e-5);
  EXPECT_NEAR(glm::determinant(r), 1, 1e-5);
}

TEST(Cameras, FollowTheirNodeWithoutItsScale) {
  Scene s;
  s.cameras = {{}};
  s.nodes.resize(2);
  s.nodes[0].scale = {3, 5, -7};  // mirrored and uneven
  s.nodes[0].translation = {1, 2, 3};
  s.nodes[1].parent = 0;
  s.nodes[1].camera = 0;
  s.nodes[1].rotation = glm::angleAxis(kPi / 2, glm::vec3(0, 1, 0));
  const auto cameras = placedCameras(s, 0);
  ASSERT_EQ(cameras.size(), 1u);
  expectRigid(cameras[0].worldFromView);
  EXPECT_LT(glm::distance(glm::vec3(cameras[0].worldFromView[3]), glm::vec3(1, 2, 3)), 1e-6f);
  // -z turned by 90 degrees about y looks along -x; up stays up.
  EXPECT_LT(glm::distance(-glm::vec3(cameras[0].worldFromView[2]), glm::vec3(-1, 0, 0)), 1e-5f);
  EXPECT_LT(glm::distance(glm::vec3(cameras[0].worldFromView[1]), glm::vec3(0, 1, 0)), 1e-5f);
}

TEST(Cameras, CountInTheOrderOfTheFilesNodes) {
  GltfFile f;
  f.triangle();
  f.json["cameras"] = {
      {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}},
      {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0.1}, {"zfar", 10}}}},
      {{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}, {"zfar", 50}}}}};
  // The child stands before its parent, as some exporters write it.
  f.json["nodes"] = {
      {{"camera", 2}, {"name", "child"}}, {{"camera", 1}}, {{"camera", 0}, {"name", "parent"}, {"children", {0, 1}}}};
  f.json["scenes"] = {{{"nodes", {2}}}};
  const Scene s = f.scene();
  const auto cameras = placedCameras(s, 0);
  ASSERT_EQ(cameras.size(), 2u);
  EXPECT_EQ(cameras[0].name, "child");
  EXPECT_FLOAT_EQ(cameras[0].camera.yfov, 0.7f);
  EXPECT_EQ(cameras[0].camera.zfar, 50.0f);
  EXPECT_EQ(cameras[1].name, "parent");
  EXPECT_FALSE(cameras[1].camera.zfar.has_value());
  EXPECT_EQ(s.orthographicCameras, 1u);
}

TEST(Cameras, PlanesThatOnlyADoubleTellsApartAreKept) {
  GltfFile f;
  f.triangle();
  f.json["cameras"] = {
      {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 1000}, {"zfar", 1000.00001}}}}};
  f.json["nodes"] = {{{"camera", 0}}};
  f.json["scenes"] = {{{"nodes", {0}}}};
  const auto loaded = f.load();
  ASSERT_TRUE(loaded.ok()) << loaded.error().message;
  EXPECT_TRUE(loaded->warnings.empty());
  ASSERT_TRUE(loaded->scene.cameras[0].zfar.has_value());
  EXPECT_GT(*loaded->scene.cameras[0].zfar, loaded->scene.cameras[0].znear);
}

// The rounding of a float position is half a step to either side; a line tells of steps that shadow maps resolve.
TEST(Cameras, FarFromTheOriginALineSaysHowCoarsePositionsAre) {
  for (const float away : {0.0f, 1e3f, 1e4f, 3e4f, 1e5f, 1e6f, 1e7f}) {
    for (int axis = 0; axis < 3; ++axis) {
      CameraView view;
      view.worldFromView[3][axis] = -away;
      EXPECT_EQ(roundingNote(view).empty(), away < 5e4f) << away;
    }
  }
  CameraView view;
  view.worldFromView[3].x = 1e6f;
  EXPECT_NE(roundingNote(view).find("1000 km"), std::string::npos);
  EXPECT_NE(roundingNote(view).find("62 mm"), std::string::npos);  // 2^-4 m between 2^19 and 2^20 m
}

TEST(Cameras, DistancesThatCannotBeAreRepairedWithAWarning) {
  GltfFile f;
  f.triangle();
  f.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0}}}},
                       {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 2}, {"zfar", 1}}}}};
  f.json["nodes"] = {{{"camera", 0}}, {{"camera", 1}}};
  f.json["scenes"] = {{{"nodes", {0, 1}}}};
  const auto loaded = f.load();
  ASSERT_TRUE(loaded.ok()) << loaded.error().message;
  EXPECT_EQ(loaded->warnings.size(), 2u);
  EXPECT_TRUE(checkScene(loaded->scene).ok());
  EXPECT_GT(loaded->scene.cameras[0].znear, 0);
  EXPECT_FALSE(loaded->scene.cameras[1].zfar.has_value());
}

TEST(Lights, ShineAlongMinusZ) {
  Scene s;
  s.lights = {{}};
  s.nodes.resize(1);
  s.nodes[0].light = 0;
  s.nodes[0].translation = {0, 4, 0};
  s.nodes[0].scale = {2, 2, 2};
  s.nodes[0].rotation = glm::angleAxis(-kPi / 2, glm::vec3(1, 0, 0));  // -z goes to -y
  const auto lights = placedLights(s, 0);
  ASSERT_EQ(lights.size(), 1u);
  EXPECT_LT(glm::distance(lights[0].direction, glm::vec3(0, -1, 0)), 1e-6f);
  EXPECT_EQ(lights[0].position, glm::vec3(0, 4, 0));
  EXPECT_EQ(lights[0].node, 0);
}

TEST(Lights, ReadFromKhrLightsPunctual) {
  GltfFile f;
  f.triangle();
  f.json["extensionsUsed"] = {"KHR_lights_punctual"};
  f.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "spot"},
       {"intensity", 40},
       {"range", 9},
       {"color", {1, 0.5, 0}},
       {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.3}}}},
      {{"type", "point"}},
      {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.5}, {"outerConeAngle", 0.4}}}},
      {{"type", "spot"}, {"spot", nlohmann::json::object()}}};
  f.json["nodes"] = {{{"mesh", 0}}};
  f.json["scenes"] = {{{"nodes", {0, 1, 2, 3, 4}}}};
  for (int i = 0; i < 4; ++i) f.json["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", i}}}}}});
  const Scene s = f.scene();
  ASSERT_EQ(s.lights.size(), 4u);
  EXPECT_EQ(s.lights[0].kind, LightKind::kSpot);
  EXPECT_EQ(s.lights[0].intensity, 40);
  EXPECT_EQ(s.lights[0].range, 9.0f);
  EXPECT_EQ(s.lights[0].color, glm::vec3(1, 0.5f, 0));
  EXPECT_FLOAT_EQ(s.lights[0].innerConeAngle, 0.1f);
  EXPECT_FLOAT_EQ(s.lights[0].outerConeAngle, 0.3f);
  EXPECT_EQ(s.lights[1].kind, LightKind::kPoint);
  EXPECT_EQ(s.lights[1].intensity, 1);
  EXPECT_FALSE(s.lights[1].range.has_value());
  EXPECT_LT(s.lights[2].innerConeAngle, s.lights[2].outerConeAngle);
  EXPECT_FLOAT_EQ(s.lights[3].outerConeAngle, kPi / 4);
}

TEST(Bounds, EncloseEveryTransformedVertex) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> number(-3, 3);
  const auto vector = [&] { return glm::vec3(number(random), number(random), number(random)); };
  for (int round = 0; round < 100; ++round) {
    Scene s;
    s.nodes.resize(1);
    s.nodes[0].mesh = 0;
    s.nodes[0].translation = vector();
    s.nodes[0].scale = vector();
    s.nodes[0].rotation = glm::angleAxis(number(random), glm::normalize(vector()));
    Primitive p;
    for (int i = 0; i < 5; ++i) {
      p.vertices.push_back({vector()});
      p.bounds.add(p.vertices.back().position);
    }
    s.meshes = {{"", {p}}};
    const auto matrices = worldMatrices(s, 0);
    const Bounds b = worldBounds(s, matrices);
    for (const Vertex& v : p.vertices) {
      const glm::vec3 world(matrices[0] * glm::vec4(v.position, 1));
      EXPECT_TRUE(glm::all(glm::greaterThanEqual(world, b.min - 1e-4f)) &&
                  glm::all(glm::lessThanEqual(world, b.max + 1e-4f)));
    }
  }
  EXPECT_TRUE(worldBounds(Scene{}, {}).empty());
}

TEST(FramingCamera, SeesTheWholeLevelFromAboveTheHorizon) {
  for (const glm::vec3 size : {glm::vec3(1), glm::vec3(100, 1, 100), glm::vec3(0.01f), glm::vec3(1, 50, 1),
                               glm::vec3(1e5f, 10, 3), glm::vec3(0)}) {
    const Bounds b{glm::vec3(5, -2, 8) - size / 2.0f, glm::vec3(5, -2, 8) + size / 2.0f};
    const CameraView view = framingCamera(b);
    expectRigid(view.worldFromView);
    EXPECT_LT(-view.worldFromView[2].y, -0.1f) << "looks down";
    EXPECT_NEAR(view.worldFromView[0].y, 0, 1e-6) << "stays level";
    const glm::mat4 viewFromWorld = glm::inverse(view.worldFromView);
    const float slope = std::tan(view.camera.yfov / 2), diagonal = glm::length(size);
    float widest = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const glm::vec3 c(corner & 1 ? b.max.x : b.min.x, corner & 2 ? b.max.y : b.min.y, corner & 4 ? b.max.z : b.min.z);
      const glm::vec3 p(viewFromWorld * glm::vec4(c, 1));
      EXPECT_GT(-p.z, view.camera.znear);
      const float extent = std::max(std::abs(p.x), std::abs(p.y)) / (-p.z * slope);
      EXPECT_LE(extent, 1.0f);
      widest = std::max(widest, extent);
      if (view.camera.zfar) {
        EXPECT_LT(-p.z, *view.camera.zfar);
      }
    }
    if (diagonal > 0) {
      EXPECT_GT(widest, 0.8f) << "fills the picture";
    }
    if (view.camera.zfar) {
      EXPECT_GE(*view.camera.zfar, 3 * diagonal);
    }
  }
  const CameraView empty = framingCamera(Bounds{});
  expectRigid(empty.worldFromView);
  EXPECT_LT(glm::length(glm::vec3(empty.worldFromView[3])), 100.0f);
}

TEST(DefaultSun, ShinesDown) {
  const LightView sun = defaultSun();
  EXPECT_NEAR(glm::length(sun.direction), 1, 1e-6);
  EXPECT_LT(sun.direction.y, -0.5f);
  EXPECT_EQ(sun.light.kind, LightKind::kDirectional);
  EXPECT_GT(sun.light.intensity, 0);
  EXPECT_EQ(sun.node, kNone);
}

}  // namespace
}  // namespace tyndall::scene
