// How many reference rays a map needs: `fourier` with K = 1 to 6 against the truth, beside the exact march of the same
// map (min_max), on views whose slices span a wide range of inclinations (docs/results/prefiltered.md).
#include <array>

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
  const Settings block = {"volumetrics.epipole_block=" + std::string(view.epipole ? "8" : "0")};
  std::array<double, 7> even{}, grown{}, ratio{};  // [0]: the map alone
  for (const bool grows : {false, true}) {
    const Settings common = {"shadows.resolution=4096", "volumetrics.columns=512", "volumetrics.slices=512",
                             "volumetrics.prefix_scheme=row",
                             std::string("volumetrics.column_spacing=") + (grows ? "transmittance" : "distance")};
    const auto error = [&](const Settings& settings) {
      return errorOf(lab.shoot(common + block + settings).scatter, truth).nRmse;
    };
    std::array<double, 7>& errors = grows ? grown : even;
    errors[0] = error({"volumetrics.technique=min_max"});
    report.line("### " + name + ", epipole " + (view.epipole ? "on" : "off") + " screen, map 512², " +
                (grows ? "columns by transmittance" : "even columns"));
    report.head({"", "nRMSE, truth", "over the exact march of the map"});
    report.row({"exact march of the map", figure(errors[0]), "1"});
    for (std::size_t k = 1; k <= 6; ++k) {
      errors[k] = error({"volumetrics.technique=fourier", "volumetrics.basis_count=64",
                         "volumetrics.reference_rays=" + std::to_string(k)});
      report.row({"fourier 64, K = " + std::to_string(k), figure(errors[k]), figure(errors[k] / errors[0])});
    }
    if (!grows)
      for (std::size_t k = 1; k <= 6; ++k) ratio[k] = even[k] / even[0];
  }
  // The papers' one reference ray is their largest error; three bring a sun off the screen near to what the papers'
  // map, of even columns, can give.
  EXPECT_LT(ratio[6], ratio[1]);
  if (!view.epipole) {
    EXPECT_LT(ratio[3], 1.7);
  }
  // Columns that grow make the map better, and what is read from it no worse; its error then lies below that of three
  // rays.
  for (const std::size_t k : {0u, 3u, 6u}) EXPECT_LT(grown[k], 1.02 * even[k]) << k;
}

INSTANTIATE_TEST_SUITE_P(Views, ReferenceRays,
                         testing::Values(View{"hall", 0, false}, View{"hall", 1, true}, View{"hall", 2, false},
                                         View{"forest", 0, false}, View{"forest", 1, true}),
                         [](const auto& given) {
                           return std::string(given.param.level) + std::to_string(given.param.camera);
                         });

}  // namespace
}  // namespace tyndall::figures
