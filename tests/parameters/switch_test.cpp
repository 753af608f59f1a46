// rectification=auto: turning the camera until the light comes near the screen switches from the projective to the epipolar map. The picture
// must not tell: its error against the dense march may not jump.
#include <algorithm>

#include <gtest/gtest.h>

#include "laboratory.hpp"

namespace tyndall::figures {
namespace {

const Settings kCommon = {"shadows.resolution=4096", "volumetrics.splits=4", "volumetrics.basis_count=64", "volumetrics.columns=512", "volumetrics.slices=512",
                          "volumetrics.prefix_scheme=row"};

bool isLinear(const Shot& shot) { return shot.pluginMs("rectify linear") > 0; }

struct Turn {
  const char* level;
  std::uint32_t camera;
  double from, to;  ///< degrees: linear at `from`, epipolar at `to`
  const char* technique;
};
void PrintTo(const Turn& turn, std::ostream* out) { *out << turn.level << turn.camera << ' ' << turn.technique; }

/// Errors at steps of 0.25 degrees; linear at the first half, epipolar at the second.
void expectSmooth(const Turn& turn) {
  Laboratory lab(turn.level, turn.camera, 160, 90);
  const Settings settings = kCommon + Settings{"volumetrics.technique=" + std::string(turn.technique), "volumetrics.rectification=auto"};
  const auto at = [&](double degrees) {
    lab.turn(degrees);
    return lab.shoot(settings);
  };
  double linear = turn.from, epipolar = turn.to;
  ASSERT_TRUE(isLinear(at(linear))) << turn.level;
  ASSERT_FALSE(isLinear(at(epipolar))) << turn.level;
  while (std::abs(epipolar - linear) > 0.3) {
    const double middle = 0.5 * (linear + epipolar);
    (isLinear(at(middle)) ? linear : epipolar) = middle;
  }
  const double step = epipolar > linear ? 0.25 : -0.25;
  std::vector<double> errors;
  for (int i = -3; i <= 4; ++i) {
    const Shot shot = at(linear + i * step);
    const Shot march = lab.shoot(kCommon + Settings{"volumetrics.technique=ray_march", "volumetrics.steps=4096"});
    errors.push_back(errorOf(shot.scatter, march.scatter).nRmse);
    std::printf("%s%u %s at %7.3f degrees: %s, nRMSE %.4f\n", turn.level, turn.camera, turn.technique, linear + i * step,
                isLinear(shot) ? "linear" : "epipolar", errors.back());
  }
  const auto mean = [&](int first) { return (errors[first] + errors[first + 1] + errors[first + 2]) / 3; };
  EXPECT_LT(mean(5), 1.1 * mean(1)) << turn.level;  // three steps behind the switch against three before it
  EXPECT_LT(mean(1), 1.1 * mean(5)) << turn.level;
}

class Switch : public testing::TestWithParam<Turn> {};

TEST_P(Switch, IsNotSeen) { expectSmooth(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Turns, Switch,
                         testing::Values(Turn{"hall", 0, 25, -40, "fourier"}, Turn{"hall", 0, 25, -40, "moments6"}, Turn{"hall", 0, 25, -40, "min_max"},
                                         Turn{"hall", 0, -110, -70, "fourier"}, Turn{"forest", 0, -5, -60, "fourier"}, Turn{"forest", 0, -5, -60, "min_max"}));

}  // namespace
}  // namespace tyndall::figures
