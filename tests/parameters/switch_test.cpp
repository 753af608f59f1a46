// rectification=auto: turning the camera until the light comes near the screen switches from the projective to the epipolar map. The picture
// must not tell: at the view where it happens, the epipolar map's error against the dense march is at most a tenth above the
// projective one's, and the switch, either way, changes the picture less than the step of the turn does.
#include <cmath>

#include <gtest/gtest.h>

#include "laboratory.hpp"

namespace tyndall::figures {
namespace {

const Settings kCommon = {"shadows.resolution=4096", "volumetrics.splits=4", "volumetrics.basis_count=64", "volumetrics.columns=512", "volumetrics.slices=512",
                          "volumetrics.prefix_scheme=row"};
constexpr double kStep = 0.25;  // degrees

bool isLinear(const Shot& shot) { return shot.pluginMs("rectify linear") > 0; }

struct Turn {
  const char* level;
  std::uint32_t camera;
  double from, to;  ///< degrees: linear at `from`, epipolar at `to`
};
void PrintTo(const Turn& turn, std::ostream* out) { *out << turn.level << turn.camera << ' ' << turn.from; }

/// The first multiple of the step, towards turn.to, whose map is epipolar; whether it is depends on the view and the splits alone.
double switchOf(const Turn& turn, Laboratory& lab) {
  const auto linearAt = [&](double degrees) {
    lab.turn(degrees);
    return isLinear(lab.shoot({"shadows.resolution=64", "volumetrics.splits=4", "volumetrics.technique=min_max", "volumetrics.rectification=auto",
                               "volumetrics.columns=64", "volumetrics.slices=64"}));
  };
  double linear = turn.from, epipolar = turn.to;
  EXPECT_TRUE(linearAt(linear));
  EXPECT_FALSE(linearAt(epipolar));
  while (std::abs(epipolar - linear) > 1.5 * kStep) {
    const double middle = std::round(0.5 * (linear + epipolar) / kStep) * kStep;
    (linearAt(middle) ? linear : epipolar) = middle;
  }
  return epipolar;
}

class Switch : public testing::TestWithParam<Turn> {};

TEST_P(Switch, IsNotSeen) {
  const Turn turn = GetParam();
  Laboratory lab(turn.level, turn.camera, 160, 90);
  const double at = switchOf(turn, lab), before = turn.to > turn.from ? at - kStep : at + kStep;
  const auto march = [&](double degrees) {
    lab.turn(degrees);
    return lab.shoot(kCommon + Settings{"volumetrics.technique=ray_march", "volumetrics.steps=4096"}).scatter;
  };
  const image::FloatImage earlier = march(before), reference = march(at);
  const double turned = errorOf(earlier, reference).nRmse;
  for (const char* technique : {"fourier", "moments4", "moments6", "min_max"}) {
    const Settings settings = kCommon + Settings{"volumetrics.technique=" + std::string(technique)};
    const Shot epipolar = lab.shoot(settings + Settings{"volumetrics.rectification=auto"});
    const Shot linear = lab.shoot(settings + Settings{"volumetrics.rectification=linear"});
    ASSERT_FALSE(isLinear(epipolar));
    ASSERT_TRUE(isLinear(linear));
    const double error = errorOf(epipolar.scatter, reference).nRmse, linearError = errorOf(linear.scatter, reference).nRmse;
    const double switched = errorOf(epipolar.scatter, linear.scatter).nRmse;
    std::printf("%s %u at %.2f degrees, %s: nRMSE linear %.4f, epipolar %.4f; the switch changes %.4f, the turn %.4f\n", turn.level, turn.camera, at,
                technique, linearError, error, switched, turned);
    EXPECT_LT(error, 1.1 * linearError) << technique;
    EXPECT_LT(switched, turned) << technique;
  }
}

INSTANTIATE_TEST_SUITE_P(Turns, Switch, testing::Values(Turn{"hall", 0, 25, -40}, Turn{"hall", 0, -110, -70}, Turn{"forest", 0, -5, -60}));

}  // namespace
}  // namespace tyndall::figures
