// The sample levels against the ray-traced truth, and the prefiltered techniques against the march. Figures are
// printed.
#include "pictures.hpp"

namespace tyndall::quality {
namespace {

class OnLevel : public QualityTest, public ::testing::WithParamInterface<const char*> {};

/// nRMSE of moments6, 1024x1024, one reference ray, against the march: what the method's approximation of the
/// visibility and its single reference ray give on this level (docs/results/first_light.md explains both from their
/// pictures). A quarter above the value measured, so that a regression shows.
double momentsLimit(const std::string& level) { return level == "hall" ? 1.0 : 0.32; }

TEST_P(OnLevel, MarchAgreesWithTheTruthAndMomentsStayWithinTheirMethod) {
  const std::string level = GetParam();
  const image::FloatImage reference = truth(level, 2048);
  const Arguments march = {"volumetrics.technique=ray_march", "shadows.resolution=4096"};
  const auto marched = [&](int steps) {
    Arguments all = march;
    all.push_back("volumetrics.steps=" + std::to_string(steps));
    return scatter(level, all);
  };
  const image::FloatImage fine = marched(1024);
  const double error = nRmse(fine, reference);
  std::printf("%s: ray_march 1024 against truth: nRMSE %.4f\n", level.c_str(), error);
  EXPECT_LT(error, 0.02);
  // No hidden cap: fewer steps are worse, again and again.
  double last = error;
  for (int steps : {512, 128, 32}) {
    const double coarse = nRmse(marched(steps), reference);
    std::printf("%s: ray_march %d against truth: nRMSE %.4f\n", level.c_str(), steps, coarse);
    EXPECT_GT(coarse, last) << steps;
    last = coarse;
  }
  const auto prefiltered = [&](const Arguments& settings) {
    Arguments all = {"shadows.resolution=4096", "volumetrics.columns=1024", "volumetrics.slices=1024"};
    all.insert(all.end(), settings.begin(), settings.end());
    return nRmse(scatter(level, all), fine);
  };
  const double six = prefiltered({"volumetrics.technique=moments6", "volumetrics.reference_rays=1"});
  const double four = prefiltered({"volumetrics.technique=moments4", "volumetrics.reference_rays=1"});
  std::printf("%s: moments6 K=1 %.4f, moments4 K=1 %.4f against ray_march 1024\n", level.c_str(), six, four);
  EXPECT_LT(six, momentsLimit(level));
  EXPECT_LT(six, four);
}

INSTANTIATE_TEST_SUITE_P(Levels, OnLevel, ::testing::Values("hall", "forest"),
                         [](const auto& level) { return std::string(level.param); });

}  // namespace
}  // namespace tyndall::quality
