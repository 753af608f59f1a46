// The techniques on rectified rows with lamps and cookies against the ray-traced truth, and the march beside them.
// Figures are printed.
#include <algorithm>
#include <cstdio>
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

const Settings kBase = {"shadows.resolution=2048", "volumetrics.columns=1024", "volumetrics.slices=1024",
                        "volumetrics.prefix_scheme=block"};

/// nRMSE without the pixels, told by their transmittance, whose rays end on another surface in the truth.
double errorOnSameSurfaces(image::FloatImage picture, const image::FloatImage& truth) {
  for (std::size_t i = 0; i < truth.values.size(); i += 4)
    if (std::abs(picture.values[i + 3] - truth.values[i + 3]) >= 1e-3f)
      std::copy_n(&truth.values[i], 4, &picture.values[i]);
  return errorOf(picture, truth).nRmse;
}

struct Case {
  const char* name;
  Lamp lamp;
  double march, exact, fourier;  ///< bounds of nRMSE, one and a half times what was measured
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

Lamp lamp(LightKind kind, glm::vec3 position, glm::vec3 towards, bool cookie, std::optional<float> range = {}) {
  Lamp made;
  made.kind = kind;
  made.position = position;
  made.towards = towards;
  made.cookie = cookie;
  made.range = range;
  if (kind == LightKind::kDirectional) made.intensity = 10;
  return made;
}

const Case kCases[] = {
    {"spot_outside", lamp(LightKind::kSpot, {-4, 4, 0}, {1, -0.5f, -0.2f}, false), 0.006, 0.009, 0.21},
    {"spot_inside", lamp(LightKind::kSpot, {1, 3, -6}, {-0.1f, -0.08f, 1}, false, 14.0f), 0.009, 0.005, 0.023},
    {"spot_behind", lamp(LightKind::kSpot, {0.5f, 2.5f, 4}, {-0.1f, -0.1f, -1}, false), 0.01, 0.13, 0.165},
    {"spot_beside_the_eye", lamp(LightKind::kSpot, {0.3f, 1.8f, 7.9f}, {-0.1f, -0.1f, -1}, false), 0.002, 0.17, 0.125},
    {"point", lamp(LightKind::kPoint, {3.4f, 2.2f, 0}, {0, 0, -1}, false, 6.0f), 0.012, 0.035, 0.07},
    {"spot_cookie", lamp(LightKind::kSpot, {-4, 4, 0}, {1, -0.5f, -0.2f}, true), 0.01, 0.013, 0.41},
    {"point_cookie", lamp(LightKind::kPoint, {3.4f, 2.2f, 0}, {0, 0, -1}, true, 9.0f), 0.023, 0.022, 0.125},
    {"sun_cookie", lamp(LightKind::kDirectional, {0, 0, 0}, {0.7f, -1, -0.4f}, true), 0.009, 0.008, 0.061},
};

class RowsAgainstTruth : public testing::TestWithParam<Case> {};

TEST_P(RowsAgainstTruth, StayWithinTheirMeasuredErrors) {
  const Case& c = GetParam();
  std::vector<Bar> bars;
  if (c.lamp.kind == LightKind::kPoint) bars = cage(c.lamp.position, 0.7f);
  if (c.lamp.kind == LightKind::kSpot) bars = slatsBefore(c.lamp, 1.2f);
  if (c.lamp.kind == LightKind::kDirectional) bars = roof();
  Laboratory lab(writeLevel(std::string("rows_") + c.name, {c.lamp}, bars), 0, 160, 90);
  const image::FloatImage truth = lab.truth(2048);
  const auto error = [&](const char* what, const Settings& settings) {
    image::FloatImage picture = lab.shoot(kBase + settings).scatter;
    // A lamp's own pixels, hundreds of times as bright as the rest, would be all that is compared: the block is for
    // those.
    for (const glm::vec2& at : lab.lightsInPicture())
      for (std::uint32_t y = 0; y < truth.height; ++y)
        for (std::uint32_t x = 0; x < truth.width; ++x)
          if (glm::distance(at, glm::vec2(x, y) + 0.5f) < 8)
            for (std::uint32_t channel = 0; channel < 3; ++channel) picture.at(x, y, channel) = truth.at(x, y, channel);
    const double found = errorOnSameSurfaces(std::move(picture), truth);
    std::printf("%-16s %-14s nRMSE %.4f\n", c.name, what, found);
    return found;
  };
  EXPECT_LT(error("ray_march 512", {"volumetrics.technique=ray_march", "volumetrics.steps=512"}), c.march);
  const Settings matrix = {"volumetrics.technique=exact", "volumetrics.row_order=column"};
  error("exact, K = 3", matrix + Settings{"volumetrics.reference_rays=3"});
  EXPECT_LT(error("exact, K = 4", matrix + Settings{"volumetrics.reference_rays=4"}), c.exact);
  // Rows of lights with a cookie are kept as the matrix whatever the order.
  if (!c.lamp.cookie) {
    EXPECT_LT(error("exact by depth", {"volumetrics.technique=exact"}), c.exact);
  }
  EXPECT_LT(error("fourier 32",
                  {"volumetrics.technique=fourier", "volumetrics.basis_count=32", "volumetrics.reference_rays=3"}),
            c.fourier);
  // A light that is not there, or a cookie that is not looked at, would be far off.
  Lamp other = c.lamp;
  other.cookie = !c.lamp.cookie;
  Laboratory changed(writeLevel(std::string("rows_other_") + c.name, {other}, bars), 0, 160, 90);
  EXPECT_GT(errorOf(changed.shoot(kBase + Settings{"volumetrics.technique=exact"}).scatter, truth).nRmse, 0.3);
}

INSTANTIATE_TEST_SUITE_P(Lamps, RowsAgainstTruth, testing::ValuesIn(kCases),
                         [](const auto& each) { return std::string(each.param.name); });

// The block around a lamp on screen is the dense march, cookie and all, in every technique on rows.
TEST(Rows, TheBlockAroundALampIsTheMarch) {
  Laboratory lab(writeLevel("rows_block", {lamp(LightKind::kSpot, {0.4f, 2.2f, -2}, {-0.1f, -0.1f, 1}, true)}, {}), 0,
                 160, 90);
  const image::FloatImage march =
      lab.shoot(kBase + Settings{"volumetrics.technique=ray_march", "volumetrics.steps=4096"}).scatter;
  const image::FloatImage block =
      lab.shoot(kBase + Settings{"volumetrics.technique=exact", "volumetrics.epipole_block=64"}).scatter;
  EXPECT_LT(errorOf(block, march).nRmse, 0.02);
}

// A further lamp that covers little of the screen has a smaller map in the same images: what it adds is what it
// scatters alone, with the whole map, but for that map's resolution.
TEST(Rows, AFurtherLampWithASmallMapAddsWhatItScattersAlone) {
  const Lamp first = lamp(LightKind::kSpot, {-4, 4, 0}, {1, -0.5f, -0.2f}, false);
  Lamp second = lamp(LightKind::kPoint, {3, 2, -4}, {0, 0, -1}, false, 2.5f);
  second.intensity = 60;
  const std::vector<Bar> bars = cage(second.position, 0.5f);
  Laboratory both(writeLevel("rows_two", {first, second}, bars), 0, 160, 90);
  Laboratory one(writeLevel("rows_first", {first}, bars), 0, 160, 90);
  Laboratory alone(writeLevel("rows_second", {second}, bars), 0, 160, 90);
  for (const char* technique : {"exact", "fourier", "moments6"})
    for (const char* filter : {"linear", "mipmapped"}) {
      const Settings settings = kBase + Settings{"volumetrics.technique=" + std::string(technique),
                                                 "volumetrics.row_filter=" + std::string(filter)};
      image::FloatImage added = both.shoot(settings).scatter;
      const image::FloatImage without = one.shoot(settings).scatter, expected = alone.shoot(settings).scatter;
      for (std::size_t i = 0; i < added.values.size(); ++i) added.values[i] -= without.values[i];
      const double error = errorOf(added, expected).nRmse;
      std::printf("%s, %s: a further lamp adds what it scatters alone but for nRMSE %.4f\n", technique, filter, error);
      EXPECT_LT(error, 0.15) << technique << ' ' << filter;
    }
}

}  // namespace
}  // namespace tyndall::local_lights
