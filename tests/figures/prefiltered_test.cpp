// The tables of docs/results/prefiltered.md: error of every prefiltering technique over its parameters, against the
// dense march through the same shadow map and against the ray-traced truth. What the papers observe is asserted where
// it was confirmed.
#include <map>

#include <gtest/gtest.h>

#include "laboratory.hpp"
#include "table.hpp"

namespace tyndall::figures {
namespace {

struct View {
  const char* level;
  std::uint32_t camera;
  const char* what;
};
void PrintTo(const View& view, std::ostream* out) { *out << view.level << view.camera; }

/// One scheme throughout: the error does not depend on it, and nothing is timed in between.
const Settings kCommon = {"shadows.resolution=4096", "volumetrics.prefix_scheme=row"};
constexpr std::uint32_t kWidth = 320, kHeight = 180, kTruthSamples = 2048;

class Prefiltered : public testing::TestWithParam<View> {
 protected:
  Prefiltered()
      : lab_(GetParam().level, GetParam().camera, kWidth, kHeight),
        report_("prefiltered_" + std::string(GetParam().level) + std::to_string(GetParam().camera)),
        truth_(lab_.truth(kTruthSamples)),
        dense_(lab_.shoot(kCommon + Settings{"volumetrics.technique=ray_march", "volumetrics.steps=4096"}).scatter) {}

  void head(const std::string& what) {
    report_.line("");
    report_.head({what, "nRMSE, march", "p99, march", "nRMSE, truth", "p99, truth", "ms"});
  }
  /// Renders, writes a row, returns the nRMSE against the dense march.
  double row(const std::string& what, const Settings& settings) {
    const Shot shot = lab_.shoot(kCommon + settings);
    const image::ErrorMetrics march = errorOf(shot.scatter, dense_), truth = errorOf(shot.scatter, truth_);
    report_.row({what, figure(march.nRmse), figure(march.p99), figure(truth.nRmse), figure(truth.p99),
                 figure(shot.pluginMs(), 2)});
    return march.nRmse;
  }

  Laboratory lab_;
  Report report_;
  image::FloatImage truth_, dense_;
};

const Settings kFourier = {"volumetrics.technique=fourier"}, kSix = {"volumetrics.technique=moments6"},
               kFour = {"volumetrics.technique=moments4"}, kMinMax = {"volumetrics.technique=min_max"};
Settings with(const Settings& base, const std::string& setting) { return base + Settings{"volumetrics." + setting}; }

TEST_P(Prefiltered, Table) {
  report_.line("### " + std::string(GetParam().level) + ", camera " + std::to_string(GetParam().camera) + " (" +
               GetParam().what + ")");
  report_.line("Device: " + lab_.device() + ". The dense march against the truth: nRMSE " +
               figure(errorOf(dense_, truth_).nRmse) + ".");

  head("the map itself (`min_max`, exact on it)");
  for (const char* size : {"512", "1024", "2048"})
    row(std::string(size) + "²", with(with(kMinMax, "columns=" + std::string(size)), "slices=" + std::string(size)));

  head("`fourier`, K = 3: functions");
  std::map<std::string, double> fourier;
  for (const char* count : {"8", "16", "32", "64", "128"})
    for (const char* bounds : {"true", "false"})
      fourier[std::string(count) + bounds] =
          row(std::string(count) + (bounds[0] == 't' ? ", bounds" : ", no bounds"),
              with(with(kFourier, "basis_count=" + std::string(count)), "prefix_bounds=" + std::string(bounds)));
  row("64, 16 bit, bounds", with(with(kFourier, "basis_count=64"), "precision=full"));
  // Klehm et al. 2014, section 5: ringing falls with the number of functions.
  EXPECT_LT(fourier["32true"], fourier["8true"]);
  EXPECT_LT(fourier["64false"], fourier["16false"]);

  head("moments, K = 3, bounds: precision, overestimation");
  std::map<std::string, double> moments;
  for (const auto& [name, base] : {std::pair{"4", kFour}, {"6", kSix}})
    for (const char* precision : {"compact", "standard", "full"}) {
      if (name[0] == '4' && precision[0] == 's') continue;  // the same as full
      for (const char* over : {"lower", "half", "upper", "adaptive"}) {
        const std::string key = std::string(name) + " " + precision + ", " + over;
        moments[key] =
            row(key, with(with(base, "precision=" + std::string(precision)), "overestimation=" + std::string(over)));
      }
    }
  // Peters et al. 2017, section 5.4: six beat four.
  EXPECT_LT(moments["6 standard, half"], moments["4 full, half"]);

  head("reference rays");
  for (const auto& [name, base] :
       {std::pair{"fourier 64", with(kFourier, "basis_count=64")}, {"moments6", kSix}, {"moments4", kFour}})
    for (const char* rays : {"1", "2", "3", "4", "6"})
      for (const char* bounds : {"true", "false"})
        row(std::string(name) + ", K = " + rays + (bounds[0] == 't' ? ", bounds" : ""),
            with(with(base, "reference_rays=" + std::string(rays)), "prefix_bounds=" + std::string(bounds)));

  head("reference ray, K = 1, no bounds: the papers");
  for (const char* ray : {"bisectrix", "optimum", "mean"})
    for (const char* weights : {"average", "transmittance"})
      row("fourier 64, " + std::string(ray) + ", " + weights,
          with(with(with(with(with(kFourier, "basis_count=64"), "reference_rays=1"), "prefix_bounds=false"),
                    "reference_ray=" + std::string(ray)),
               "weights=" + std::string(weights)));

  head("rectification");
  for (const auto& [name, base] :
       {std::pair{"fourier 64", with(kFourier, "basis_count=64")}, {"moments6", kSix}, {"min_max", kMinMax}}) {
    for (const char* splits : {"1", "2", "4"})
      row(std::string(name) + ", linear, " + splits + " maps",
          with(with(base, "rectification=linear"), "splits=" + std::string(splits)));
    row(std::string(name) + ", epipolar, azimuth", with(base, "slice_spacing=azimuth"));
    row(std::string(name) + ", epipolar, border", with(base, "slice_spacing=border"));
  }

  head("rows at 256² and 1024²");
  for (const auto& [name, base] : {std::pair{"fourier 64", with(kFourier, "basis_count=64")}, {"moments6", kSix}})
    for (const char* size : {"256", "1024"})
      for (const char* filter : {"nearest", "linear", "mipmapped"})
        row(std::string(name) + ", " + size + "², " + filter,
            with(with(with(base, "columns=" + std::string(size)), "slices=" + std::string(size)),
                 "row_filter=" + std::string(filter)));
}

INSTANTIATE_TEST_SUITE_P(Views, Prefiltered,
                         testing::Values(View{"hall", 0, "across the shafts, epipole off screen"},
                                         View{"hall", 1, "towards the windows, epipole on screen"},
                                         View{"forest", 0, "across the light, epipole off screen"},
                                         View{"forest", 1, "towards the sun, epipole on screen"},
                                         View{"terrain", 0, "a vista across the light, epipole off screen"},
                                         View{"tower", 0, "the sun just behind the shaft"},
                                         View{"lattice", 0, "past the fence to the sun and its beams, and two lamps"},
                                         View{"cage", 0, "a point light just off the screen"},
                                         View{"vault", 0, "two spot lights with cookies, both cones across"},
                                         View{"town", 0, "along the street: a moon and eight lamps"}),
                         [](const auto& given) {
                           return std::string(given.param.level) + std::to_string(given.param.camera);
                         });

}  // namespace
}  // namespace tyndall::figures
