// The error of the projective and of the epipolar rectification against the dense march while the camera turns, and which of them `auto` takes
// (docs/results/prefiltered.md).
#include <gtest/gtest.h>

#include "laboratory.hpp"
#include "table.hpp"

namespace tyndall::figures {
namespace {

struct Turn {
  const char* level;
  double from, to;  ///< degrees
};
void PrintTo(const Turn& turn, std::ostream* out) { *out << turn.level; }

class Rectification : public testing::TestWithParam<Turn> {};

TEST_P(Rectification, Table) {
  const Turn turn = GetParam();
  Laboratory lab(turn.level, 0, 320, 180);
  Report report(std::string("rectification_") + turn.level);
  report.head({"degrees", "auto", "min_max linear", "epipolar", "fourier 64 linear", "epipolar", "moments6 linear", "epipolar"});
  const Settings common = {"shadows.resolution=4096", "volumetrics.splits=4", "volumetrics.basis_count=64", "volumetrics.columns=512",
                           "volumetrics.slices=512", "volumetrics.prefix_scheme=row"};
  int linears = 0, epipolars = 0;
  for (double degrees = turn.from; degrees <= turn.to; degrees += 5) {
    lab.turn(degrees);
    const image::FloatImage reference = lab.shoot(common + Settings{"volumetrics.technique=ray_march", "volumetrics.steps=4096"}).scatter;
    const auto shoot = [&](const char* technique, const char* rectification) {
      return lab.shoot(common + Settings{std::string("volumetrics.technique=") + technique, std::string("volumetrics.rectification=") + rectification});
    };
    if (shoot("min_max", "linear").pluginMs("rectify linear") <= 0) continue;  // no projective map: the light, or its antipode, is in view
    const bool linear = shoot("min_max", "auto").pluginMs("rectify linear") > 0;
    ++(linear ? linears : epipolars);
    std::vector<std::string> row{figure(degrees), linear ? "linear" : "epipolar"};
    for (const char* technique : {"min_max", "fourier", "moments6"})
      for (const char* rectification : {"linear", "epipolar"}) row.push_back(figure(errorOf(shoot(technique, rectification).scatter, reference).nRmse));
    report.row(row);
  }
  // A turn that does not meet both says nothing about the choice between them.
  EXPECT_GT(linears, 0);
  EXPECT_GT(epipolars, 0);
}

INSTANTIATE_TEST_SUITE_P(Turns, Rectification, testing::Values(Turn{"hall", -110, 30}, Turn{"forest", -70, 40}),
                         [](const auto& given) { return std::string(given.param.level); });

}  // namespace
}  // namespace tyndall::figures
