// What the cameras see, and where the sun stands to them: the levels are there to try the epipole in every place.
#include <algorithm>

#include <gtest/gtest.h>

#include "levels/levels.hpp"
#include "triangles.hpp"

namespace tyndall::levels {
namespace {

constexpr float kAspect = 16.0f / 9.0f;

struct Views {
  explicit Views(const scene::Scene& level) : scene(level) {
    const std::vector<glm::mat4> world = scene::worldMatrices(scene, 0);
    cameras = scene::placedCameras(scene, 0);
    lights = scene::placedLights(scene, 0);
    toSun = -lights.at(0).direction;
  }
  glm::vec3 ray(int camera, float x, float y) const {  // x, y in [-1, 1]
    const float reach = glm::tan(0.5f * cameras[camera].camera.yfov);
    return glm::normalize(glm::mat3(cameras[camera].worldFromView) * glm::vec3(x * reach * kAspect, y * reach, -1));
  }
  glm::vec3 eye(int camera) const { return glm::vec3(cameras[camera].worldFromView[3]); }
  /// The sun (`sign` +1) or the point opposite to it (-1): x, y as above, z > 0 when in front of the camera.
  glm::vec3 onScreen(int camera, float sign) const {
    const glm::vec3 v = glm::transpose(glm::mat3(cameras[camera].worldFromView)) * (sign * toSun);
    const float reach = glm::tan(0.5f * cameras[camera].camera.yfov);
    return {v.x / (-v.z * reach * kAspect), v.y / (-v.z * reach), -v.z};
  }
  /// The same for a place in the world; z is its distance along the view.
  glm::vec3 onScreen(int camera, const glm::vec3& place) const {
    const glm::vec3 v = glm::transpose(glm::mat3(cameras[camera].worldFromView)) * (place - eye(camera));
    const float reach = glm::tan(0.5f * cameras[camera].camera.yfov);
    return {v.x / (-v.z * reach * kAspect), v.y / (-v.z * reach), -v.z};
  }
  static bool inside(const glm::vec3& p) { return p.z > 0 && glm::abs(p.x) < 1 && glm::abs(p.y) < 1; }

  scene::Scene scene;
  std::vector<scene::CameraView> cameras;
  std::vector<scene::LightView> lights;
  glm::vec3 toSun{0};
};

void expectCamerasSeeGeometry(const Views& views, float least) {
  const std::vector<Triangle> triangles = trianglesOf(views.scene);
  ASSERT_EQ(views.cameras.size(), 4u);
  for (int camera = 0; camera < 4; ++camera) {
    SCOPED_TRACE(views.cameras[camera].name);
    ASSERT_TRUE(views.cameras[camera].camera.zfar);
    int hits = 0, count = 0;
    float farthest = 0;
    for (float y = -0.9f; y < 1; y += 0.3f) {
      for (float x = -0.95f; x < 1; x += 0.19f) {
        ++count;
        const std::optional<float> distance = nearest(triangles, views.eye(camera), views.ray(camera, x, y));
        if (!distance) continue;
        ++hits;
        farthest = glm::max(farthest, *distance);
        EXPECT_GT(*distance, 0.5f) << "something stands in the camera at " << x << ' ' << y;
      }
    }
    EXPECT_GE(static_cast<float>(hits), least * static_cast<float>(count));
    EXPECT_GT(farthest, 8.0f);
    EXPECT_LT(farthest, *views.cameras[camera].camera.zfar);
  }
}

TEST(Cameras, OfTheHallSeeGeometry) { expectCamerasSeeGeometry(Views(makeHall()), 0.85f); }
TEST(Cameras, OfTheForestSeeGeometry) { expectCamerasSeeGeometry(Views(makeForest()), 0.6f); }
TEST(Cameras, OfTheTerrainSeeGeometry) { expectCamerasSeeGeometry(Views(makeTerrain()), 0.55f); }
TEST(Cameras, OfTheTowerSeeGeometry) { expectCamerasSeeGeometry(Views(makeTower()), 0.45f); }

TEST(Cameras, OfTheVaultSeeItsWalls) { expectCamerasSeeGeometry(Views(makeVault()), 1.0f); }
TEST(Cameras, OfTheCageSeeItsWalls) { expectCamerasSeeGeometry(Views(makeCage()), 1.0f); }

// A strip of sky stands between the eaves.
TEST(Cameras, OfTheTownSeeGeometry) { expectCamerasSeeGeometry(Views(makeTown()), 0.7f); }
TEST(Cameras, OfTheLatticeSeeGeometry) { expectCamerasSeeGeometry(Views(makeLattice()), 0.95f); }

TEST(Cameras, OfTheTownTryItsLantern) {
  const Views town(makeTown());
  const auto lantern = std::find_if(town.lights.begin(), town.lights.end(), [](const scene::LightView& light) {
    return light.light.kind == scene::LightKind::kPoint;
  });
  ASSERT_NE(lantern, town.lights.end());
  for (const int camera : {0, 1, 2}) EXPECT_TRUE(Views::inside(town.onScreen(camera, lantern->position))) << camera;
  EXPECT_TRUE(Views::inside(town.onScreen(0, 1)));  // the moon, behind the tower
  EXPECT_TRUE(blocked(trianglesOf(town.scene), town.eye(0), town.toSun));
}

TEST(Cameras, OfTheLatticeTryEveryLightOnTheScreen) {
  const Views lattice(makeLattice());
  ASSERT_EQ(lattice.lights.size(), 3u);
  EXPECT_TRUE(Views::inside(lattice.onScreen(0, 1)));
  const auto at = [&](scene::LightKind kind) {
    for (const scene::LightView& light : lattice.lights)
      if (light.light.kind == kind) return light.position;
    return glm::vec3(0);
  };
  EXPECT_TRUE(Views::inside(lattice.onScreen(1, at(scene::LightKind::kSpot))));
  EXPECT_TRUE(Views::inside(lattice.onScreen(2, at(scene::LightKind::kPoint))));
}

TEST(Cameras, TryLampsOffAndOnTheScreen) {
  const Views vault(makeVault()), cage(makeCage());
  ASSERT_EQ(vault.lights.size(), 2u);
  for (const scene::LightView& light : vault.lights) EXPECT_FALSE(Views::inside(vault.onScreen(0, light.position)));
  EXPECT_TRUE(Views::inside(vault.onScreen(1, vault.lights[0].position)));
  // Camera 2 stands within the window's cone and looks along it: the lamp is behind, its antipode on the screen.
  const scene::LightView& window = vault.lights[1];
  const glm::vec3 fromLamp = glm::normalize(vault.eye(2) - window.position);
  EXPECT_GT(glm::dot(fromLamp, window.direction), glm::cos(window.light.outerConeAngle));
  EXPECT_LT(vault.onScreen(2, window.position).z, 0);
  EXPECT_TRUE(Views::inside(vault.onScreen(2, vault.eye(2) + fromLamp)));
  // Camera 1 stands in the other cone, camera 0 in none.
  const auto within = [&](int camera, const scene::LightView& light) {
    const float cosine = glm::dot(glm::normalize(vault.eye(camera) - light.position), light.direction);
    return cosine > glm::cos(light.light.outerConeAngle);
  };
  EXPECT_TRUE(within(1, vault.lights[0]));
  EXPECT_FALSE(within(1, window));
  EXPECT_FALSE(within(0, vault.lights[0]));
  EXPECT_FALSE(within(0, window));

  ASSERT_EQ(cage.lights.size(), 2u);
  EXPECT_FALSE(Views::inside(cage.onScreen(0, cage.lights[0].position)));
  for (const int camera : {1, 2}) {
    const glm::vec3 lamp = cage.onScreen(camera, cage.lights[0].position);
    EXPECT_TRUE(Views::inside(lamp));
    EXPECT_LT(glm::abs(lamp.x), 0.3f);
  }
  EXPECT_LT(glm::distance(cage.eye(2), cage.lights[0].position), 2.0f);
}

TEST(Cameras, TryTheEpipoleEverywhere) {
  const Views hall(makeHall()), forest(makeForest());
  EXPECT_FALSE(Views::inside(hall.onScreen(0, 1)));
  EXPECT_TRUE(Views::inside(hall.onScreen(1, 1)));
  EXPECT_FALSE(Views::inside(forest.onScreen(0, 1)));
  EXPECT_TRUE(Views::inside(forest.onScreen(1, 1)));
  EXPECT_TRUE(Views::inside(forest.onScreen(2, -1)));
  // The sun of the forest's camera 1 stands behind leaves.
  const std::vector<Triangle> triangles = trianglesOf(forest.scene);
  EXPECT_TRUE(blocked(triangles, forest.eye(1), forest.toSun));
}

TEST(Cameras, OfTheTerrainHaveTheSunAheadAndBehind) {
  const Views terrain(makeTerrain());
  EXPECT_FALSE(Views::inside(terrain.onScreen(0, 1)));
  const glm::vec3 sun = terrain.onScreen(2, 1);  // right of the middle, behind the aqueduct
  EXPECT_TRUE(Views::inside(sun));
  EXPECT_GT(sun.x, 0.4f);
  EXPECT_TRUE(Views::inside(terrain.onScreen(1, -1)));
  // Where camera 1 looks, shadows converge: it stands in one itself.
  EXPECT_TRUE(blocked(trianglesOf(terrain.scene), terrain.eye(1), terrain.toSun));
}

/// Camera 0 has the sun behind the tower's solid part, camera 1 sees it through the belfry; the tour passes from light
/// to shadow and back.
TEST(Cameras, OfTheTowerHaveTheSunBehindIt) {
  const Views tower(makeTower());
  const auto ofTheTower = [](const scene::Node& node) { return node.name == "tower"; };
  const auto ofTheBelfry = [](const scene::Node& node) { return node.name == "belfry" || node.name == "bell"; };
  const std::vector<Triangle> all = trianglesOf(tower.scene), solid = trianglesOf(tower.scene, 0, ofTheTower),
                              openwork = trianglesOf(tower.scene, 0, ofTheBelfry);
  for (const int camera : {0, 1}) EXPECT_TRUE(Views::inside(tower.onScreen(camera, 1)));
  const glm::vec3 beside = tower.onScreen(2, 1);
  EXPECT_GT(beside.z, 0);
  EXPECT_GT(beside.x, 1.0f);
  EXPECT_LT(beside.x, 1.4f);
  EXPECT_TRUE(blocked(solid, tower.eye(0), tower.toSun));
  EXPECT_FALSE(blocked(all, tower.eye(1), tower.toSun));
  const glm::vec3 eye = tower.eye(1);
  const glm::vec3 atTheTower = eye + tower.toSun * (-eye.z / tower.toSun.z);
  EXPECT_LT(glm::abs(atTheTower.x), 1.25f);
  EXPECT_GT(atTheTower.y, 10.6f);
  EXPECT_LT(atTheTower.y, 15.2f);
  int lit = 0, shaded = 0;
  for (double t = 0; t < tower.scene.animations.at(0).duration; t += 0.2) {
    const auto cameras = scene::placedCameras(tower.scene, t);
    const glm::vec3 at(cameras.at(3).worldFromView[3]);
    const bool dark = blocked(solid, at, tower.toSun) || blocked(openwork, at, tower.toSun);
    ++(dark ? shaded : lit);
  }
  EXPECT_GT(lit, 15);
  EXPECT_GT(shaded, 15);
}

TEST(Sun, OfTheDuskLevelsIsLowAndWarm) {
  for (const scene::Scene& scene : {makeTerrain(), makeTower()}) {
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.lights[0].kind, scene::LightKind::kDirectional);
    EXPECT_GT(scene.lights[0].color.r, 1.4f * scene.lights[0].color.g);
    EXPECT_GT(scene.lights[0].color.g, 1.4f * scene.lights[0].color.b);
    const float elevation = glm::degrees(glm::asin(Views(scene).toSun.y));
    EXPECT_GT(elevation, 8.0f);
    EXPECT_LT(elevation, 24.0f);
  }
}

TEST(Sun, IsTheOnlyLightAndPlausible) {
  for (const scene::Scene& scene : {makeHall(), makeForest()}) {
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.lights[0].kind, scene::LightKind::kDirectional);
    EXPECT_FLOAT_EQ(scene.lights[0].intensity, 10.0f);
    EXPECT_GE(scene.lights[0].color.r, scene.lights[0].color.g);  // warm
    EXPECT_GT(scene.lights[0].color.g, scene.lights[0].color.b);
    const float elevation = glm::degrees(glm::asin(Views(scene).toSun.y));
    EXPECT_GT(elevation, 20.0f);
    EXPECT_LT(elevation, 40.0f);
  }
}

}  // namespace
}  // namespace tyndall::levels
