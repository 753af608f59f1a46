// How many reference rays a map needs: `fourier` with K = 1 to 6 against the truth, beside the exact march of the same map (min_max), on
// views whose slices span a wide range of inclinations (docs/results/prefiltered.md).
#include <gtest/gtest.h>

#include "laboratory.hpp"
#include "table.hpp"

namespace tyndall::figures {
namespace {

struct View {
  const char* level;
  std::uint32_t camera;
  bool epipole;  ///< on the screen
};
void PrintTo(const View& view, std::ostream* out) { *out << view.level << view.camera; }

class ReferenceRays : public testing::TestWithParam<View> {};

TEST_P(ReferenceRays, Table) {
  const View view = GetParam();
  const std::string name = std::string(view.level) + std::to_string(view.camera);
  Laboratory lab(view.level, view.camera, 320, 180);
  Report report("reference_rays_" + name);
  const image::FloatImage truth = lab.truth(2048);
  const Settings common = {"shadows.resolution=4096", "volumetrics.columns=512", "volumetrics.slices=512", "volumetrics.prefix_scheme=row"};
  const auto error = [&](const Settings& settings) { return errorOf(lab.shoot(common + settings).scatter, truth).nRmse; };
  const Settings block = {"volumetrics.epipole_block=" + std::string(view.epipole ? "8" : "0")};
  const double exact = error(block + Settings{"volumetrics.technique=min_max"});
  report.line("### " + name + ", epipole " + (view.epipole ? "on" : "off") + " screen, map 512²");
  report.head({"", "nRMSE, truth", "over the exact march of the map"});
  report.row({"exact march of the map", figure(exact), "1"});
  double ratio[7] = {};
  for (int k = 1; k <= 6; ++k) {
    const double e = error(block + Settings{"volumetrics.technique=fourier", "volumetrics.basis_count=64", "volumetrics.reference_rays=" + std::to_string(k)});
    ratio[k] = e / exact;
    report.row({"fourier 64, K = " + std::to_string(k), figure(e), figure(ratio[k])});
  }
  // The papers' one reference ray is their largest error; three bring a sun off the screen near to what the map can give.
  EXPECT_LT(ratio[6], ratio[1]);
  if (!view.epipole) {
    EXPECT_LT(ratio[3], 1.7);
  }
}

INSTANTIATE_TEST_SUITE_P(Views, ReferenceRays, testing::Values(View{"hall", 0, false}, View{"hall", 1, true}, View{"hall", 2, false}, View{"forest", 0, false}, View{"forest", 1, true}),
                         [](const auto& given) { return std::string(given.param.level) + std::to_string(given.param.camera); });

}  // namespace
}  // namespace tyndall::figures
