// The techniques on rectified rows with lamps and cookies against the ray-traced truth, and the march beside them. Figures are printed.
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

const Settings kBase = {"shadows.resolution=2048", "volumetrics.columns=512", "volumetrics.slices=512", "volumetrics.prefix_scheme=block"};

/// nRMSE without the pixels, told by their transmittance, whose rays end on another surface in the truth.
double errorOnSameSurfaces(image::FloatImage picture, const image::FloatImage& truth) {
  for (std::size_t i = 0; i < truth.values.size(); i += 4)
    if (std::abs(picture.values[i + 3] - truth.values[i + 3]) >= 1e-3f) std::copy_n(&truth.values[i], 4, &picture.values[i]);
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
    {"spot_outside", lamp(LightKind::kSpot, {-4, 4, 0}, {1, -0.5f, -0.2f}, false), 1, 1, 1},
    {"spot_inside", lamp(LightKind::kSpot, {1, 3, -6}, {-0.1f, -0.08f, 1}, false, 14.0f), 1, 1, 1},
    {"spot_behind", lamp(LightKind::kSpot, {0.5f, 2.5f, 4}, {-0.1f, -0.1f, -1}, false), 1, 1, 1},
    {"spot_at_the_eye", lamp(LightKind::kSpot, {0, 2, 8}, {-0.1f, -0.1f, -1}, false), 1, 1, 1},
    {"point", lamp(LightKind::kPoint, {3.4f, 2.2f, 0}, {0, 0, -1}, false, 6.0f), 1, 1, 1},
    {"spot_cookie", lamp(LightKind::kSpot, {-4, 4, 0}, {1, -0.5f, -0.2f}, true), 1, 1, 1},
    {"point_cookie", lamp(LightKind::kPoint, {3.4f, 2.2f, 0}, {0, 0, -1}, true, 9.0f), 1, 1, 1},
    {"sun_cookie", lamp(LightKind::kDirectional, {0, 0, 0}, {0.7f, -1, -0.4f}, true), 1, 1, 1},
};

class RowsAgainstTruth : public testing::TestWithParam<Case> {};

TEST_P(RowsAgainstTruth, StayWithinTheirMeasuredErrors) {
  const Case& c = GetParam();
  std::vector<Bar> bars;
  if (c.lamp.kind == LightKind::kPoint) bars = cage(c.lamp.position, 0.7f);
  if (c.lamp.kind == LightKind::kSpot) bars = slatsBefore(c.lamp, 1.2f);
  if (c.lamp.kind == LightKind::kDirectional)
    for (int i = 0; i < 6; ++i) bars.push_back({{-6, 4, -6.0f + 2 * static_cast<float>(i)}, {6, 4, -6.0f + 2 * static_cast<float>(i)}, {0, 0, 0.8f}});
  Laboratory lab(writeLevel(std::string("rows_") + c.name, {c.lamp}, bars), 0, 160, 90);
  const image::FloatImage truth = lab.truth(2048);
  const auto error = [&](const char* what, const Settings& settings) {
    const double found = errorOnSameSurfaces(lab.shoot(kBase + settings).scatter, truth);
    std::printf("%-16s %-14s nRMSE %.4f\n", c.name, what, found);
    return found;
  };
  EXPECT_LT(error("ray_march 512", {"volumetrics.technique=ray_march", "volumetrics.steps=512"}), c.march);
  EXPECT_LT(error("exact, K = 4", {"volumetrics.technique=exact", "volumetrics.reference_rays=4"}), c.exact);
  EXPECT_LT(error("fourier 32", {"volumetrics.technique=fourier", "volumetrics.basis_count=32"}), c.fourier);
  // A light that is not there, or a cookie that is not looked at, would be far off.
  Lamp other = c.lamp;
  other.cookie = !c.lamp.cookie;
  Laboratory changed(writeLevel(std::string("rows_other_") + c.name, {other}, bars), 0, 160, 90);
  EXPECT_GT(errorOf(changed.shoot(kBase + Settings{"volumetrics.technique=exact"}).scatter, truth).nRmse, 0.3);
}

INSTANTIATE_TEST_SUITE_P(Lamps, RowsAgainstTruth, testing::ValuesIn(kCases), [](const auto& each) { return std::string(each.param.name); });

// The block around a lamp on screen is the dense march, cookie and all, in every technique on rows.
TEST(Rows, TheBlockAroundALampIsTheMarch) {
  Laboratory lab(writeLevel("rows_block", {lamp(LightKind::kSpot, {0.4f, 2.2f, -2}, {-0.1f, -0.1f, 1}, true)}, {}), 0, 160, 90);
  const image::FloatImage march = lab.shoot(kBase + Settings{"volumetrics.technique=ray_march", "volumetrics.steps=4096"}).scatter;
  const image::FloatImage block = lab.shoot(kBase + Settings{"volumetrics.technique=exact", "volumetrics.epipole_block=64"}).scatter;
  EXPECT_LT(errorOf(block, march).nRmse, 0.02);
}

}  // namespace
}  // namespace tyndall::local_lights
