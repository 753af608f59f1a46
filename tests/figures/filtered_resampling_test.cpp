// The tables of docs/results/moment_shadow_maps.md: what filtered resampling (Peters et al. 2017, section 5.2) does to
// the error of prefiltered techniques over the size of the rectified map, and what the moment shadow map costs.
#include <gtest/gtest.h>

#include "laboratory.hpp"
#include "table.hpp"

namespace tyndall::figures {
namespace {

struct View {
  const char* level;
  std::uint32_t camera;
};
void PrintTo(const View& view, std::ostream* out) { *out << view.level << view.camera; }

class FilteredResampling : public testing::TestWithParam<View> {};

TEST_P(FilteredResampling, Table) {
  const std::string name = GetParam().level + std::to_string(GetParam().camera);
  Laboratory lab(GetParam().level, GetParam().camera, 320, 180);
  Report report("filtered_resampling_" + name);
  const Settings common = {"shadows.resolution=2048", "volumetrics.prefix_scheme=row"};
  const image::FloatImage march =
      lab.shoot(common + Settings{"volumetrics.technique=ray_march", "volumetrics.steps=1024"}).scatter;
  report.line("### " + name + ", " + lab.device());
  report.line("");
  report.head({"technique, map", "unfiltered nRMSE", "filtered, 64 bit", "filtered, 128 bit", "unfiltered ms",
               "filtered ms", "moment map ms"});
  const std::pair<const char*, Settings> techniques[] = {
      {"moments6", {"volumetrics.technique=moments6"}},
      {"moments4", {"volumetrics.technique=moments4"}},
      {"fourier, 32", {"volumetrics.technique=fourier", "volumetrics.basis_count=32"}}};
  for (const auto& [what, technique] : techniques)
    for (const char* size : {"128", "256", "512", "1024"}) {
      const Settings base =
          common + technique +
          Settings{"volumetrics.columns=" + std::string(size), "volumetrics.slices=" + std::string(size)};
      const Settings filtered = base + Settings{"volumetrics.filtered_resampling=true"};
      const Shot without = lab.shoot(base), narrow = lab.shoot(filtered);
      const Shot wide = lab.shoot(filtered + Settings{"shadows.precision=128"});
      double moments = 0;
      for (const render::PassTime& pass : narrow.passes)
        moments += pass.name.starts_with("moments ") ? pass.milliseconds : 0;
      report.row({std::string(what) + ", " + size + "²", figure(errorOf(without.scatter, march).nRmse),
                  figure(errorOf(narrow.scatter, march).nRmse), figure(errorOf(wide.scatter, march).nRmse),
                  figure(without.pluginMs(), 2), figure(narrow.pluginMs(), 2), figure(moments, 2)});
    }
}

INSTANTIATE_TEST_SUITE_P(Views, FilteredResampling, testing::Values(View{"hall", 0}, View{"forest", 0}),
                         [](const auto& view) { return view.param.level + std::to_string(view.param.camera); });

}  // namespace
}  // namespace tyndall::figures
