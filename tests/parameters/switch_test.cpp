// rectification=auto: turning the camera until the light comes near the screen fades the projective map into the
// epipolar one. The picture must not tell: at views within the fade, whatever a step of the turn does to the shares of
// the two maps, either way, raises the error against the dense march by at most a tenth, and changes the picture less
// than the step of the turn does.
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "laboratory.hpp"

namespace tyndall::figures {
namespace {

const Settings kCommon = {"shadows.resolution=4096", "volumetrics.splits=4",   "volumetrics.basis_count=64",
                          "volumetrics.columns=512", "volumetrics.slices=512", "volumetrics.prefix_scheme=row"};
const Settings kSmall = {"shadows.resolution=256", "volumetrics.technique=min_max", "volumetrics.splits=4",
                         "volumetrics.slices=64"};
constexpr double kStep = 0.25;  // degrees

struct Turn {
  const char* level;
  std::uint32_t camera;
  double from, to;              ///< degrees: linear at `from`, epipolar at `to`
  std::vector<double> offsets;  ///< degrees from the middle of the fade
  std::vector<const char*> techniques;
};
void PrintTo(const Turn& turn, std::ostream* out) { *out << turn.level << turn.camera << ' ' << turn.from; }

/// a + share (b - a), RGB.
image::FloatImage mixed(const image::FloatImage& a, const image::FloatImage& b, double share) {
  image::FloatImage result = a;
  for (std::size_t i = 0; i < a.values.size(); ++i)
    result.values[i] += static_cast<float>(share * (b.values[i] - a.values[i]));
  return result;
}

/// The share of the projective map in what `auto` shows, found from the pictures of both maps alone; the share depends
/// on the view and the splits only. min_max has no parts: the map that stands in is an epipolar one of the columns of
/// all splits.
double shareAt(Laboratory& lab, double degrees) {
  lab.turn(degrees);
  const auto shoot = [&](const char* rectification, const char* columns) {
    return lab
        .shoot(kSmall + Settings{std::string("volumetrics.rectification=") + rectification,
                                 std::string("volumetrics.columns=") + columns})
        .scatter;
  };
  const image::FloatImage linear = shoot("linear", "64"), epipolar = shoot("epipolar", "256"),
                          both = shoot("auto", "64");
  double along = 0, whole = 0, off = 0;
  for (std::size_t i = 0; i < both.values.size(); ++i) {
    const double difference = double{linear.values[i]} - epipolar.values[i];
    along += difference * (both.values[i] - epipolar.values[i]);
    whole += difference * difference;
  }
  double norm = 0;
  for (const float value : epipolar.values) norm += std::pow(value, 2);
  if (whole < 1e-6 * norm) return 0;  // no projective map: linear is epipolar
  const double share = along / whole;
  const image::FloatImage expected = mixed(epipolar, linear, share);
  for (std::size_t i = 0; i < both.values.size(); ++i) off += std::pow(both.values[i] - expected.values[i], 2);
  EXPECT_LT(off, 1e-4 * whole) << "at " << degrees << " degrees the picture is no mixture of both maps'";
  return share;
}

/// The multiple of the step at which both maps have about the same share.
double middleOf(const Turn& turn, Laboratory& lab) {
  double linear = turn.from, epipolar = turn.to;
  EXPECT_NEAR(shareAt(lab, linear), 1, 1e-3);
  EXPECT_NEAR(shareAt(lab, epipolar), 0, 1e-3);
  while (std::abs(epipolar - linear) > 1.5 * kStep) {
    const double middle = std::round(0.5 * (linear + epipolar) / kStep) * kStep;
    (shareAt(lab, middle) >= 0.5 ? linear : epipolar) = middle;
  }
  return epipolar;
}

class Switch : public testing::TestWithParam<Turn> {};

TEST_P(Switch, IsNotSeen) {
  const Turn turn = GetParam();
  Laboratory lab(turn.level, turn.camera, 160, 90);
  const double middle = middleOf(turn, lab);
  for (const double offset : turn.offsets) {
    const double at = middle + offset;
    const double before = shareAt(lab, at - kStep), after = shareAt(lab, at + kStep), share = shareAt(lab, at);
    ASSERT_GT(share, 0.01);
    ASSERT_LT(share, 0.99);
    lab.turn(at - kStep);
    const Settings march = kCommon + Settings{"volumetrics.technique=ray_march", "volumetrics.steps=4096"};
    const image::FloatImage earlier = lab.shoot(march).scatter;
    lab.turn(at);
    const image::FloatImage reference = lab.shoot(march).scatter;
    const double turned = errorOf(earlier, reference).nRmse;
    for (const char* technique : turn.techniques) {
      const Settings settings = kCommon + Settings{"volumetrics.technique=" + std::string(technique)};
      const image::FloatImage both = lab.shoot(settings + Settings{"volumetrics.rectification=auto"}).scatter;
      const image::FloatImage linear = lab.shoot(settings + Settings{"volumetrics.rectification=linear"}).scatter;
      const double error = errorOf(both, reference).nRmse;
      std::printf("%s %u at %.2f degrees, %s: share %.3f, before %.3f, after %.3f; nRMSE %.4f, linear alone %.4f",
                  turn.level, turn.camera, at, technique, share, before, after, error,
                  errorOf(linear, reference).nRmse);
      for (const double other : {before, after}) {
        const image::FloatImage stepped = mixed(both, linear, (other - share) / (1 - share));
        const double steppedError = errorOf(stepped, reference).nRmse;
        std::printf("; a step: %.3f times", steppedError / error);
        EXPECT_LT(steppedError, 1.1 * error) << technique;
        EXPECT_LT(error, 1.1 * steppedError) << technique;
        EXPECT_LT(errorOf(stepped, both).nRmse, turned) << technique;
      }
      std::printf("\n");
    }
  }
}

#ifdef TYNDALL_EVERY_SWITCH
const std::vector<double> kOffsets = {-1.5, 0, 1.5};
const std::vector<const char*> kTechniques = {"fourier", "moments4", "moments6", "min_max", "exact"};
INSTANTIATE_TEST_SUITE_P(EveryTurn, Switch,
                         testing::Values(Turn{"hall", 0, 30, -40, kOffsets, kTechniques},
                                         Turn{"hall", 0, -115, -70, kOffsets, kTechniques},
                                         Turn{"forest", 0, 5, -60, kOffsets, kTechniques}));
#else
INSTANTIATE_TEST_SUITE_P(ATurn, Switch, testing::Values(Turn{"hall", 0, 30, -40, {-1}, {"fourier", "min_max"}}));
#endif

}  // namespace
}  // namespace tyndall::figures
