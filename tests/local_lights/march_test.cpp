// ray_march with spot and point lights against the ray-traced truth. Figures are printed.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

#include "laboratory.hpp"
#include "lamp_level.hpp"

namespace tyndall::local_lights {
namespace {

using figures::operator+;
using figures::errorOf;
using figures::Laboratory;
using figures::Settings;
using scene::LightKind;

const Settings kMarch = {"volumetrics.technique=ray_march"};
Settings marched(int steps) {
  return kMarch + Settings{"shadows.resolution=2048", "volumetrics.steps=" + std::to_string(steps)};
}
Settings withSteps(const char* steps) {
  return kMarch + Settings{"shadows.resolution=1024", "volumetrics.steps=" + std::string(steps)};
}

double mean(const image::FloatImage& picture) {
  double sum = 0;
  for (std::size_t i = 0; i < picture.values.size(); i += 4)
    sum += picture.values[i] + picture.values[i + 1] + picture.values[i + 2];
  return sum / (3.0 * picture.width * picture.height);
}

/// nRMSE where picture and truth see the same surface: at an edge a pixel's ray may pass or not, which no technique can
/// change. Such pixels, told by their transmittance, must be few.
double errorOnSameSurfaces(image::FloatImage picture, const image::FloatImage& truth) {
  int others = 0;
  for (std::size_t i = 0; i < truth.values.size(); i += 4) {
    if (std::abs(picture.values[i + 3] - truth.values[i + 3]) < 1e-3f) continue;
    ++others;
    std::copy_n(&truth.values[i], 4, &picture.values[i]);
  }
  EXPECT_LE(others, 10);
  return errorOf(picture, truth).nRmse;
}

/// Writes pictures for people to look at, if the environment asks for it.
void show(const std::string& name, const image::FloatImage& picture) {
  if (const char* folder = std::getenv("TYNDALL_SHOW"))
    if (const auto written = image::writeExr(std::filesystem::path(folder) / (name + ".exr"), picture); !written)
      ADD_FAILURE() << written.error().message;
}

struct Case {
  const char* name;
  Lamp lamp;
  float slats;   ///< metres before a spot; half size of a point light's cage
  double bound;  ///< nRMSE of 512 steps, of which what is left is the shadow map's resolution
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

Lamp lamp(LightKind kind, glm::vec3 position, glm::vec3 towards, std::optional<float> range = {}) {
  Lamp made;
  made.kind = kind;
  made.position = position;
  made.towards = towards;
  made.range = range;
  return made;
}

const Case kCases[] = {
    {"outside", lamp(LightKind::kSpot, {-4, 4, 0}, {1, -0.5f, -0.2f}), 1.2f, 0.008},
    {"outside_range", lamp(LightKind::kSpot, {-4, 4, 0}, {1, -0.5f, -0.2f}, 5.0f), 1.2f, 0.01},
    {"inside", lamp(LightKind::kSpot, {1, 3, -6}, {-0.1f, -0.08f, 1}), 1.2f, 0.01},
    {"inside_range", lamp(LightKind::kSpot, {1, 3, -6}, {-0.1f, -0.08f, 1}, 12.0f), 1.2f, 0.02},
    {"behind", lamp(LightKind::kSpot, {0.5f, 2.5f, 4}, {-0.1f, -0.1f, -1}), 1.2f, 0.012},
    {"behind_range", lamp(LightKind::kSpot, {0.5f, 2.5f, 4}, {-0.1f, -0.1f, -1}, 9.0f), 1.2f, 0.012},
    {"point", lamp(LightKind::kPoint, {0.4f, 2.2f, 0}, {0, 0, -1}), 0.7f, 0.01},
    {"point_range", lamp(LightKind::kPoint, {0.4f, 2.2f, 0}, {0, 0, -1}, 5.0f), 0.7f, 0.014},
};

Lamp withCookie(Lamp made) {
  made.cookie = true;
  if (made.kind == LightKind::kDirectional) made.intensity = 10;
  return made;
}

// What is seen through a cookie has edges inside the light too, and few steps find them as late as those of shadows.
const Case kCookieCases[] = {
    {"cookie_outside", withCookie(lamp(LightKind::kSpot, {-4, 4, 0}, {1, -0.5f, -0.2f})), 1.2f, 0.03},
    {"cookie_inside", withCookie(lamp(LightKind::kSpot, {1, 3, -6}, {-0.1f, -0.08f, 1}, 12.0f)), 1.2f, 0.03},
    {"cookie_point", withCookie(lamp(LightKind::kPoint, {0.4f, 2.2f, 0}, {0, 0, -1}, 9.0f)), 0.7f, 0.03},
    {"cookie_sun", withCookie(lamp(LightKind::kDirectional, {}, {0.7f, -1, -0.4f})), 0, 0.03},
};

class AgainstTruth : public testing::TestWithParam<Case> {};

TEST_P(AgainstTruth, MarchConvergesToIt) {
  const Case& c = GetParam();
  const auto bars = c.lamp.kind == LightKind::kPoint         ? cage(c.lamp.position, c.slats)
                    : c.lamp.kind == LightKind::kDirectional ? roof()
                                                             : slatsBefore(c.lamp, c.slats);
  Laboratory lab(writeLevel(c.name, {c.lamp}, bars), 0, 160, 90);
  const image::FloatImage truth = lab.truth(1024);
  show(std::string(c.name) + "_truth", truth);
  double last = 1e9;
  for (const int steps : {16, 64, 512}) {
    const image::FloatImage picture = lab.shoot(marched(steps)).scatter;
    show(std::string(c.name) + "_" + std::to_string(steps), picture);
    const double error = errorOnSameSurfaces(picture, truth);
    std::printf("%-14s %4d steps: nRMSE %.4f\n", c.name, steps, error);
    EXPECT_LT(error, last) << steps;
    last = error;
  }
  EXPECT_LT(last, c.bound);
  // The shadows are there to be seen: without slats the picture is another.
  Laboratory empty(writeLevel(std::string(c.name) + "_empty", {c.lamp}, {}), 0, 160, 90);
  EXPECT_GT(errorOf(empty.shoot(marched(64)).scatter, truth).nRmse, 5 * last) << "hardly a shadow";
}

INSTANTIATE_TEST_SUITE_P(Lamps, AgainstTruth, testing::ValuesIn(kCases),
                         [](const auto& each) { return std::string(each.param.name); });
INSTANTIATE_TEST_SUITE_P(Cookies, AgainstTruth, testing::ValuesIn(kCookieCases),
                         [](const auto& each) { return std::string(each.param.name); });

// Nothing in the way and nothing around: no shadow map's resolution in the error, and few steps do.
TEST(March, AnUnshadowedLampNeedsFewSteps) {
  for (const Case& c : kCases) {
    Laboratory lab(writeLevel(std::string(c.name) + "_alone", {c.lamp}, {}, false), 0, 160, 90);
    const image::FloatImage truth = lab.truth(512);
    // What is left is float's: one pixel a few millimetres beside the lamp holds it all.
    for (const auto& [steps, bound] : {std::pair{16, 5e-2}, {64, 6e-3}, {512, 2.5e-3}}) {
      const double error = errorOf(lab.shoot(marched(steps)).scatter, truth).nRmse;
      std::printf("%-14s unshadowed, %4d steps: nRMSE %.6f\n", c.name, steps, error);
      EXPECT_LT(error, bound) << c.name << ' ' << steps;
    }
  }
}

TEST(March, LightsOfAllKindsAddUp) {
  Lamp sun = lamp(LightKind::kDirectional, {}, {0.3f, -1, -0.4f});
  sun.intensity = 3;
  Lamp spot = kCases[0].lamp, point = kCases[6].lamp, away = lamp(LightKind::kSpot, {0, 2, 20}, {0, 0, 1});
  spot.color = {1, 0.2f, 0.1f};
  const std::vector<Bar> bars = slatsBefore(spot, 1.2f);
  const auto alone = [&](const Lamp& one) {
    return Laboratory(writeLevel("one", {one}, bars), 0, 160, 90).shoot(withSteps("64")).scatter;
  };
  image::FloatImage sum = alone(sun);
  for (const Lamp& other : {spot, point}) {
    const image::FloatImage more = alone(other);
    for (std::size_t i = 0; i < sum.values.size(); ++i)
      if (i % 4 != 3) sum.values[i] += more.values[i];
  }
  Laboratory lab(writeLevel("all", {point, sun, away, spot}, bars), 0, 160, 90);
  const figures::Shot all = lab.shoot(withSteps("64"));
  EXPECT_LT(errorOf(all.scatter, sum).nRmse, 1e-5);
  for (std::size_t i = 3; i < sum.values.size(); i += 4) ASSERT_EQ(all.scatter.values[i], sum.values[i]);
  int marches = 0;
  for (const render::PassTime& pass : all.passes)
    marches += pass.owner == "volumetrics" && pass.name.starts_with("march");
  EXPECT_EQ(marches, 3) << "the lamp that shines away must cost no pass";
}

TEST(March, ALampOutOfViewLeavesTheTransmittanceAndNoPass) {
  Laboratory lab(writeLevel("away", {lamp(LightKind::kSpot, {0, 2, 20}, {0, 0, 1})}, {}), 0, 160, 90);
  const figures::Shot shot = lab.shoot(withSteps("64"));
  EXPECT_EQ(mean(shot.scatter), 0);
  EXPECT_GT(shot.scatter.at(80, 45, 3), 0.4);
  EXPECT_LT(shot.scatter.at(80, 45, 3), 0.6);  // 20 m to the wall
  for (const render::PassTime& pass : shot.passes)
    EXPECT_FALSE(pass.owner == "volumetrics" && pass.name.starts_with("march")) << pass.name;
}

// What the parameters of the march do with a lamp.
TEST(March, ParametersDoWhatTheySay) {
  const Case& c = kCases[6];
  Laboratory lab(writeLevel("parameters", {c.lamp}, cage(c.lamp.position, c.slats)), 0, 160, 90);
  const auto shot = [&](const Settings& settings) { return lab.shoot(withSteps("16") + settings).scatter; };
  const image::FloatImage base = shot({}), reference = lab.shoot(withSteps("4096")).scatter;
  const double error = errorOf(base, reference).nRmse;
  EXPECT_GT(errorOf(shot({"volumetrics.jitter=white"}), base).nRmse, 1e-3);
  // Equal steps in distance waste themselves far from the lamp.
  const double distance = errorOf(shot({"volumetrics.march_spacing=distance"}), reference).nRmse;
  std::printf("16 steps of equal angle %.4f, of equal distance %.4f\n", error, distance);
  EXPECT_GT(distance, 1.2 * error);
  // Both arrive at the same picture.
  EXPECT_LT(
      errorOf(lab.shoot(withSteps("4096") + Settings{"volumetrics.march_spacing=distance"}).scatter, reference).nRmse,
      5e-3);
  // Jitter is noise around the truth, not an offset.
  EXPECT_NEAR(mean(lab.shoot(withSteps("64") + Settings{"volumetrics.jitter=white"}).scatter) / mean(reference), 1,
              5e-3);
  EXPECT_NEAR(mean(shot({"medium.albedo=0.45"})) / mean(base), 0.5, 1e-4);
  EXPECT_EQ(mean(shot({"medium.sigma_t=0"})), 0);
}

// The view "difference" holds a march of every light that meets every shadow texel: a fine march is black in it, a
// coarse one is not.
TEST(March, TheDifferenceViewKnowsLocalLights) {
  std::vector<Bar> bars = cage(kCases[6].lamp.position, 0.7f);
  for (const Bar& bar : slatsBefore(kCases[0].lamp, 1.2f)) bars.push_back(bar);
  Laboratory lab(writeLevel("difference", {kCases[6].lamp, kCases[0].lamp}, bars), 0, 160, 90);
  const auto brightness = [&](const char* steps, const char* view) {
    const image::ByteImage picture = lab.look(withSteps(steps) + Settings{"shadows.resolution=256"}, view);
    double sum = 0;
    for (const std::uint8_t value : picture.values) sum += value;
    return sum / static_cast<double>(picture.values.size());
  };
  const double fine = brightness("2048", "difference"), coarse = brightness("8", "difference"),
               dense = brightness("8", "dense_march");
  std::printf("mean of the difference view: 8 steps %.2f, 2048 steps %.2f; of the dense march %.1f\n", coarse, fine,
              dense);
  // The view is coded for the eye, which lifts what is dark: a fiftieth of the difference is a sixth of the brightness.
  EXPECT_LT(fine, 0.15 * coarse);
  EXPECT_GT(coarse, 2);
  EXPECT_GT(dense, 10);
}

}  // namespace
}  // namespace tyndall::local_lights
