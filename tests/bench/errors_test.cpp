// Quartiles, and errors split by where they lie, against pictures made by hand.
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "bench/error_split.hpp"
#include "bench/statistics.hpp"
#include "bench/truths.hpp"

namespace tyndall::bench {
namespace {

image::FloatImage flat(std::uint32_t width, std::uint32_t height, float radiance, float transmittance) {
  image::FloatImage picture{width, height, 4, {}};
  for (std::uint32_t i = 0; i < width * height; ++i)
    picture.values.insert(picture.values.end(), {radiance, radiance, radiance, transmittance});
  return picture;
}

void set(image::FloatImage& picture, std::uint32_t x, std::uint32_t y, float radiance) {
  for (std::uint32_t c = 0; c < 3; ++c) picture.at(x, y, c) = radiance;
}

TEST(Spread, QuartilesLieBetweenRanks) {
  EXPECT_EQ(spreadOf({}).count, 0u);
  const Spread one = spreadOf({4});
  EXPECT_EQ(one.median, 4);
  EXPECT_EQ(one.low, 4);
  const Spread five = spreadOf({50, 10, 30, 20, 40});
  EXPECT_EQ(five.median, 30);
  EXPECT_EQ(five.low, 20);
  EXPECT_EQ(five.high, 40);
  const Spread two = spreadOf({1, 2});
  EXPECT_DOUBLE_EQ(two.median, 1.5);
  EXPECT_DOUBLE_EQ(two.low, 1.25);
}

TEST(ErrorSplit, EachPartHasItsOwnErrors) {
  constexpr std::uint32_t kWidth = 60, kHeight = 40;
  const image::FloatImage reference = flat(kWidth, kHeight, 2, 0.5f);
  image::FloatImage picture = reference;
  std::vector<float> distance(kWidth * kHeight, 10.0f);
  // Columns 0 to 4 lie nearer: columns 4 and 5 are on the step.
  for (std::uint32_t y = 0; y < kHeight; ++y)
    for (std::uint32_t x = 0; x < 5; ++x) distance[y * kWidth + x] = 9.0f;
  set(picture, 4, 7, 3);         // silhouette by distance: +0.5 of the mean
  picture.at(30, 3, 3) = 0.52f;  // silhouette by transmittance
  set(picture, 30, 3, 2.2f);     // +0.1
  set(picture, 20, 20, 1);       // interior: -0.5
  set(picture, 50, 30, 6);       // by the light: +2
  auto split = splitErrors(picture, reference, distance, {{50.5f, 30.5f}});
  ASSERT_TRUE(split) << split.error().message;
  EXPECT_EQ(split->all->pixels, kWidth * kHeight);
  EXPECT_EQ(split->all->pixels, split->silhouettes->pixels + split->interior->pixels + split->light->pixels);
  EXPECT_EQ(split->silhouettes->pixels, 2 * kHeight + 1);
  EXPECT_NEAR(split->silhouettes->nrmse, std::sqrt((0.25 + 0.01) / static_cast<double>(split->silhouettes->pixels)),
              1e-6);
  EXPECT_NEAR(split->silhouettes->maximum, 0.5, 1e-6);
  EXPECT_NEAR(split->interior->nrmse, 0.5 / std::sqrt(static_cast<double>(split->interior->pixels)), 1e-6);
  EXPECT_LT(split->interior->bias, 0);
  EXPECT_NEAR(split->light->maximum, 2, 1e-6);
  EXPECT_NEAR(split->light->bias * static_cast<double>(split->light->pixels), 2, 1e-5);
  EXPECT_NEAR(split->all->nrmse, std::sqrt((0.25 + 0.01 + 0.25 + 4) / (kWidth * kHeight)), 1e-6);
  EXPECT_EQ(split->all->p99, 0);
}

TEST(ErrorSplit, PartsWithoutPixelsAreMissing) {
  const image::FloatImage reference = flat(8, 8, 1, 1);
  auto split = splitErrors(reference, reference, {}, {});
  ASSERT_TRUE(split);
  EXPECT_FALSE(split->light);
  EXPECT_FALSE(split->silhouettes);
  EXPECT_EQ(split->interior->nrmse, 0);
}

TEST(ErrorSplit, TheNinetyNinthPercentileIsANearestRank) {
  const image::FloatImage reference = flat(10, 10, 1, 1);
  image::FloatImage picture = reference;
  set(picture, 0, 0, 5);  // one pixel of a hundred: above the 99th percentile
  EXPECT_EQ(splitErrors(picture, reference, {}, {})->all->p99, 0);
  set(picture, 1, 0, 3);  // two of a hundred
  EXPECT_NEAR(splitErrors(picture, reference, {}, {})->all->p99, 2, 1e-6);
}

TEST(ErrorSplit, OtherSurfacesCanBeLeftOut) {
  const image::FloatImage reference = flat(8, 8, 1, 0.5f);
  image::FloatImage picture = reference;
  set(picture, 2, 2, 9);
  picture.at(2, 2, 3) = 0.7f;
  set(picture, 3, 3, 2);
  EXPECT_NEAR(splitErrors(onSameSurface(picture, reference), reference, {}, {})->all->maximum, 1, 1e-6);
  EXPECT_NEAR(splitErrors(picture, reference, {}, {})->all->maximum, 8, 1e-6);
}

TEST(ErrorSplit, WhatCannotBeComparedIsRefused) {
  const image::FloatImage reference = flat(8, 8, 1, 1);
  EXPECT_FALSE(splitErrors(flat(8, 9, 1, 1), reference, {}, {}));
  EXPECT_FALSE(splitErrors(reference, flat(8, 8, 0, 1), {}, {}));
  EXPECT_FALSE(splitErrors(reference, reference, std::vector<float>(3), {}));
  image::FloatImage broken = reference;
  set(broken, 3, 2, std::numeric_limits<float>::quiet_NaN());
  auto split = splitErrors(broken, reference, {}, {});
  ASSERT_FALSE(split);
  EXPECT_NE(split.error().message.find("3, 2"), std::string::npos);
}

TEST(ErrorSplit, LightsStandWhereTheyAreSeen) {
  scene::CameraView camera;  // at the origin, looks down -z
  camera.worldFromView = glm::mat4(1);
  camera.camera.yfov = glm::radians(90.0f);
  scene::LightView sun, lamp, behind;
  sun.light.kind = scene::LightKind::kDirectional;
  sun.direction = glm::vec3(0, 0, 1);  // shines towards +z: stands in the middle
  lamp.light.kind = scene::LightKind::kPoint;
  lamp.position = glm::vec3(1, 1, -2);
  behind.light.kind = scene::LightKind::kPoint;
  behind.position = glm::vec3(0, 0, 5);
  const auto places = lightsInPicture({sun, lamp, behind}, camera, {200, 100});
  ASSERT_EQ(places.size(), 2u);
  EXPECT_NEAR(places[0].x, 100, 1e-4f);
  EXPECT_NEAR(places[0].y, 50, 1e-4f);
  EXPECT_NEAR(places[1].x, 125, 1e-4f);  // 1/2 of the half height, which is 50 pixels
  EXPECT_NEAR(places[1].y, 25, 1e-4f);
  EXPECT_TRUE(insidePicture(places, {200, 100}));
  EXPECT_FALSE(insidePicture({{-1.0f, 5.0f}}, {200, 100}));
}

scene::LightView sunFrom(double azimuth, double elevation) {
  const double a = glm::radians(azimuth), e = glm::radians(elevation);
  scene::LightView sun;
  sun.light.kind = scene::LightKind::kDirectional;
  sun.direction = glm::vec3(std::sin(a) * std::cos(e), -std::sin(e),
                            std::cos(a) * std::cos(e));  // azimuth grows to the left from -z
  return sun;
}

// Of series of random numbers with logarithms spread normally: how often one more stays under the limit.
TEST(PredictionLimit, HoldsInNineteenOfTwentyCases) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal(-3, 0.4);
  for (const std::size_t count : {3u, 4u, 6u, 9u, 21u, 40u}) {
    int under = 0;
    constexpr int kSeries = 20000;
    for (int i = 0; i < kSeries; ++i) {
      std::vector<double> values(count);
      for (double& value : values) value = std::exp(normal(random));
      under += std::exp(normal(random)) <= predictionLimit(values).value();
    }
    EXPECT_NEAR(static_cast<double>(under) / kSeries, 0.95, 0.006) << count;
  }
  EXPECT_FALSE(predictionLimit({0.1, 0.2}));
  EXPECT_FALSE(predictionLimit({0.1, 0.2, 0.0}));
  EXPECT_DOUBLE_EQ(predictionLimit({0.25, 0.25, 0.25}).value(), 0.25) << "no spread";
}

TEST(Turn, YawGoesLeftAndPitchUp) {
  scene::CameraView camera;
  camera.worldFromView = glm::mat4(1);
  camera.worldFromView[3] = glm::vec4(3, 2, 1, 1);
  const scene::CameraView left = turned(camera, {90, 0}), up = turned(camera, {0, 30}), both = turned(camera, {90, 30});
  EXPECT_NEAR(glm::length(-glm::vec3(left.worldFromView[2]) - glm::vec3(-1, 0, 0)), 0, 1e-6f);
  EXPECT_NEAR(-up.worldFromView[2].y, 0.5f, 1e-6f);
  EXPECT_NEAR(glm::length(-glm::vec3(both.worldFromView[2]) - glm::vec3(-std::sqrt(0.75f), 0.5f, 0)), 0, 1e-6f);
  EXPECT_NEAR(both.worldFromView[0].y, 0, 1e-6f) << "no roll";
  EXPECT_EQ(both.worldFromView[3], camera.worldFromView[3]);
}

TEST(Turn, TowardsALightBringsItHalfWayIntoThePicture) {
  scene::CameraView camera;
  camera.worldFromView = glm::mat4(1);
  camera.camera.yfov = glm::radians(60.0f);
  const Size size{160, 90};
  // To the left and the right, before and behind the camera, high, low, and all but in the zenith.
  for (const auto& [azimuth, elevation] :
       {std::pair{100.0, 20.0}, {-100.0, 20.0}, {180.0, 10.0}, {-50.0, 70.0}, {30.0, -60.0}, {10.0, 89.0}}) {
    const auto turn = turnTowardsLight({sunFrom(azimuth, elevation)}, camera, size);
    ASSERT_TRUE(turn) << azimuth << ' ' << elevation;
    const auto places = lightsInPicture({sunFrom(azimuth, elevation)}, turned(camera, *turn), size);
    ASSERT_EQ(places.size(), 1u);
    EXPECT_TRUE(insidePicture(places, size))
        << azimuth << ' ' << elevation << ": " << places[0].x << ' ' << places[0].y;
    // No more of a turn than is needed, and the light comes in on the side on which it is.
    EXPECT_LE(std::abs(turn->yaw), std::abs(azimuth));
    EXPECT_LE(std::abs(turn->pitch), std::abs(elevation));
  }
  const auto level = turnTowardsLight({sunFrom(100, 0)}, camera, size);
  ASSERT_TRUE(level);
  const auto place = lightsInPicture({sunFrom(100, 0)}, turned(camera, *level), size);
  EXPECT_NEAR(place[0].x, 40, 0.01f);
  EXPECT_NEAR(place[0].y, 45, 0.01f);
}

TEST(Turn, OfSeveralLightsTheNearestIsTaken) {
  scene::CameraView camera;
  camera.worldFromView = glm::mat4(1);
  camera.camera.yfov = glm::radians(60.0f);
  scene::LightView lamp;
  lamp.light.kind = scene::LightKind::kPoint;
  lamp.position = glm::vec3(10, 0, -1);
  const Size size{160, 90};
  const auto turn = turnTowardsLight({sunFrom(170, 30), lamp}, camera, size);
  ASSERT_TRUE(turn);
  EXPECT_LT(turn->yaw, 0) << "to the right";
  EXPECT_GT(turn->yaw, -85);
  EXPECT_FALSE(turnTowardsLight({}, camera, size));
  lamp.position = glm::vec3(0);
  EXPECT_FALSE(turnTowardsLight({lamp}, camera, size)) << "the eye is at the lamp";
}

}  // namespace
}  // namespace tyndall::bench
