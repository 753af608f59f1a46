// What single parameters must do to the picture, as physics or their definition has it.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/memory.hpp"
#include "bench/stand.hpp"
#include "laboratory.hpp"

namespace tyndall::figures {
namespace {

const Settings kSmall = {"shadows.resolution=512", "volumetrics.columns=256", "volumetrics.slices=256",
                         "volumetrics.prefix_scheme=row"};

// Sharp bounds: whatever the true visibility, lower <= half <= upper at every pixel, and half is the middle. Exact for
// K = 1; interpolation between several reference rays has negative weights, hence one.
TEST(Effects, OverestimationIsMonotonicAtEveryPixel) {
  Laboratory lab("hall", 0, 160, 90);
  for (const char* technique : {"moments4", "moments6"}) {
    const Settings base =
        kSmall + Settings{"volumetrics.technique=" + std::string(technique), "volumetrics.reference_rays=1"};
    const auto shot = [&](const char* value) {
      return lab.shoot(base + Settings{"volumetrics.overestimation=" + std::string(value)}).scatter;
    };
    const image::FloatImage lower = shot("lower"), half = shot("half"), upper = shot("upper"),
                            adaptive = shot("adaptive");
    double widest = 0;
    for (std::size_t i = 0; i < lower.values.size(); ++i) {
      const float slack = 1e-4f * (1 + upper.values[i]);
      ASSERT_LE(lower.values[i], half.values[i] + slack) << technique << ' ' << i;
      ASSERT_LE(half.values[i], upper.values[i] + slack) << technique << ' ' << i;
      ASSERT_LE(lower.values[i], adaptive.values[i] + slack) << technique << ' ' << i;
      ASSERT_LE(adaptive.values[i], upper.values[i] + slack) << technique << ' ' << i;
      ASSERT_NEAR(half.values[i], (lower.values[i] + upper.values[i]) / 2, 5 * slack) << technique << ' ' << i;
      widest = std::max(widest, static_cast<double>(upper.values[i] - lower.values[i]));
    }
    EXPECT_GT(widest, 0.05) << technique;
  }
}

// The block changes pixels inside it only, and there it is the dense march.
TEST(Effects, TheEpipoleBlockIsMarchedAndNothingElse) {
  Laboratory lab("hall", 1, 160, 90);
  const Settings base = kSmall + Settings{"volumetrics.technique=moments6"};
  const image::FloatImage without = lab.shoot(base + Settings{"volumetrics.epipole_block=0"}).scatter;
  const image::FloatImage with = lab.shoot(base + Settings{"volumetrics.epipole_block=12"}).scatter;
  const image::FloatImage march =
      lab.shoot(kSmall + Settings{"volumetrics.technique=ray_march", "volumetrics.steps=4096"}).scatter;
  std::uint32_t x0 = 160, x1 = 0, y0 = 90, y1 = 0, changed = 0;
  for (std::uint32_t y = 0; y < 90; ++y)
    for (std::uint32_t x = 0; x < 160; ++x) {
      if (with.at(x, y, 1) == without.at(x, y, 1)) continue;
      ++changed;
      x0 = std::min(x0, x), x1 = std::max(x1, x), y0 = std::min(y0, y), y1 = std::max(y1, y);
      EXPECT_NEAR(with.at(x, y, 1), march.at(x, y, 1), 0.02 * (march.at(x, y, 1) + 0.1)) << x << ' ' << y;
    }
  EXPECT_GT(changed, 200u);
  EXPECT_LE(x1 - x0, 24u);
  EXPECT_LE(y1 - y0, 24u);
}

// Exact on its map, so that only the map's resolution is left of its error.
TEST(Effects, MoreColumnsAndSlicesBringMinMaxToTheMarch) {
  Laboratory lab("hall", 0, 160, 90);
  const Settings common = {"shadows.resolution=2048"};
  const image::FloatImage march =
      lab.shoot(common + Settings{"volumetrics.technique=ray_march", "volumetrics.steps=4096"}).scatter;
  double last = 1e9;
  for (const char* size : {"128", "512", "2048"}) {
    const double error =
        errorOf(lab.shoot(common + Settings{"volumetrics.technique=min_max", "volumetrics.columns=" + std::string(size),
                                            "volumetrics.slices=" + std::string(size)})
                    .scatter,
                march)
            .nRmse;
    std::printf("min_max %s^2 against the march: %.4f\n", size, error);
    EXPECT_LT(error, 0.7 * last) << size;
    last = error;
  }
  EXPECT_LT(last, 0.03);
}

// Rows of exact against the walk of the min-max tree: two ways to sum the same map. The wavelet matrix has the weights
// of reference rays, six of which leave nothing but the bins of depth; levels trade error for time. Rows in the order
// of depth have the ray's own weights, column by column or in blocks.
TEST(Effects, ExactIsTheDenseSumOfItsMap) {
  Laboratory lab("hall", 0, 160, 90);
  struct Map {
    const char* name;
    Settings settings;
    double most;
    std::vector<const char*> schemes = {"block"};
    double columns = 1e-3, blocks = 5e-3;  ///< in the order of depth
  };
  const Map maps[] = {
      {"epipolar 1024x256", {"volumetrics.columns=1024", "volumetrics.slices=256"}, 0.003, {"row", "block", "scan"}},
      {"epipolar, 700 columns", {"volumetrics.columns=700", "volumetrics.slices=256"}, 0.004, {"row", "block", "scan"}},
      {"epipolar, nearest rows",
       {"volumetrics.columns=1024", "volumetrics.slices=256", "volumetrics.row_filter=nearest"},
       0.003},
      {"linear, 3 maps of 300",
       {"volumetrics.rectification=linear", "volumetrics.splits=3", "volumetrics.columns=300",
        "volumetrics.slices=256"},
       0.006},
      {"epipolar, 4096 columns", {"volumetrics.columns=4096", "volumetrics.slices=64"}, 0.003, {"row", "scan"}},
      {"linear, 4 maps of 2048",
       {"volumetrics.rectification=linear", "volumetrics.splits=4", "volumetrics.columns=2048",
        "volumetrics.slices=64"},
       0.006},
  };
  for (const Map& map : maps) {
    const Settings base = Settings{"shadows.resolution=1024"} + map.settings;
    const image::FloatImage dense = lab.shoot(base + Settings{"volumetrics.technique=min_max"}).scatter;
    const auto from = [&](const Settings& own, const char* what) {
      const double error =
          errorOf(lab.shoot(base + Settings{"volumetrics.technique=exact"} + own).scatter, dense).nRmse;
      std::printf("exact, %s, %s: %.5f from the dense sum\n", map.name, what, error);
      return error;
    };
    for (const char* scheme : map.schemes)
      EXPECT_LT(from({"volumetrics.row_order=column", "volumetrics.reference_rays=6",
                      "volumetrics.prefix_scheme=" + std::string(scheme)},
                     scheme),
                map.most)
          << map.name << ' ' << scheme;
    EXPECT_LT(from({"volumetrics.row_blocks=columns", "volumetrics.prefix_scheme=row"}, "depth, by columns"),
              map.columns)
        << map.name;
    for (const char* scheme : {"row", "scan"})
      EXPECT_LT(from({"volumetrics.prefix_scheme=" + std::string(scheme)}, "depth, 32 blocks"), map.blocks) << map.name;
  }
  const Settings base = kSmall + Settings{"volumetrics.reference_rays=6", "volumetrics.row_order=column"};
  const image::FloatImage dense = lab.shoot(base + Settings{"volumetrics.technique=min_max"}).scatter;
  double last = 1e9;
  for (const char* levels : {"1", "2", "4", "6", "8"}) {
    const double error =
        errorOf(lab.shoot(base + Settings{"volumetrics.technique=exact", "volumetrics.prefix_bounds=false",
                                          "volumetrics.levels=" + std::string(levels)})
                    .scatter,
                dense)
            .nRmse;
    std::printf("exact, %s levels: %.5f from the dense sum\n", levels, error);
    EXPECT_LT(error, 0.75 * last) << levels;
    last = error;
  }
}

// Blocks whose weight falls off steeply are looked at by parts: in air so thick that the first of them hold most of the
// weight, and for lamps, the error stays near that of single columns.
TEST(Effects, BlocksOfRowsAreAsGoodAsTheirColumns) {
  struct Case {
    const char* level;
    std::uint32_t camera;
    const char* sigma_t;
    double most;  ///< over the error of single columns
  };
  // Measured: 1.17, 1.38, 1.34, 1.17, 1.14.
  for (const Case& c : {Case{"hall", 0, "0.2", 1.5}, Case{"hall", 0, "1", 1.5}, Case{"terrain", 0, "0.2", 1.5},
                        Case{"cage", 1, "0.2", 1.5}, Case{"vault", 0, "0.03", 1.5}}) {
    Laboratory lab(c.level, c.camera, 160, 90);
    const Settings base = {"shadows.resolution=2048", "volumetrics.prefix_scheme=row",
                           "medium.sigma_t=" + std::string(c.sigma_t)};
    const image::FloatImage march =
        lab.shoot(base + Settings{"volumetrics.technique=ray_march", "volumetrics.steps=2048"}).scatter;
    const auto error = [&](const char* blocks) {
      return errorOf(lab.shoot(base + Settings{"volumetrics.row_blocks=" + std::string(blocks)}).scatter, march).nRmse;
    };
    const double columns = error("columns"), blocks = error("32");
    std::printf("%s %u, sigma_t %s: %.5f by columns, %.5f by 32 blocks\n", c.level, c.camera, c.sigma_t, columns,
                blocks);
    EXPECT_LT(blocks, c.most * columns + 1e-4) << c.level << ' ' << c.sigma_t;
    EXPECT_LT(columns, 0.06) << c.level << ' ' << c.sigma_t;
  }
}

// Shorter segments are joined with the ray's own weights: with one reference ray, more regions must bring the error of
// the weights down.
TEST(Effects, RegionsTakeAwayTheErrorOfASingleReferenceRay) {
  Laboratory lab("hall", 0, 160, 90);
  const Settings base =
      kSmall + Settings{"volumetrics.technique=fourier", "volumetrics.basis_count=128", "volumetrics.reference_rays=1",
                        "volumetrics.precision=full", "medium.sigma_t=0.1"};
  const image::FloatImage exact =
      lab.shoot(kSmall + Settings{"volumetrics.technique=min_max", "medium.sigma_t=0.1"}).scatter;
  const auto error = [&](const char* regions) {
    return errorOf(lab.shoot(base + Settings{"volumetrics.regions=" + std::string(regions)}).scatter, exact).nRmse;
  };
  const double one = error("1"), eight = error("8");
  std::printf("fourier 128, K = 1, against min_max on the same map: 1 region %.4f, 8 regions %.4f\n", one, eight);
  EXPECT_LT(eight, 0.6 * one);
}

// Rows much coarser than the shadow map: single texels miss thin branches, the filtered map does not (Peters et al.
// 2017, section 5.2).
TEST(Effects, FilteredResamplingLowersTheErrorOfSmallMaps) {
  Laboratory lab("forest", 0, 320, 180);
  // Even columns: those that grow away from the eye miss less of what is near it, and leave the filter less to mend
  // (0.51 and 0.99).
  const Settings common = {"shadows.resolution=2048", "volumetrics.prefix_scheme=row",
                           "volumetrics.column_spacing=distance"};
  const image::FloatImage march =
      lab.shoot(common + Settings{"volumetrics.technique=ray_march", "volumetrics.steps=1024"}).scatter;
  struct Case {
    const char* technique;
    const char* size;
    double most;  ///< of the unfiltered error
  };
  // Measured shares: 0.37, 0.62 and 0.88; what remains of moments6 is the error of its bounds.
  for (const Case& c : {Case{"fourier", "128", 0.5}, Case{"fourier", "256", 0.75}, Case{"moments6", "128", 0.95}}) {
    const Settings base =
        common + Settings{"volumetrics.technique=" + std::string(c.technique),
                          "volumetrics.columns=" + std::string(c.size), "volumetrics.slices=" + std::string(c.size)};
    const double without = errorOf(lab.shoot(base).scatter, march).nRmse;
    for (const char* precision : {"64", "128"}) {
      const Settings filtered = {"volumetrics.filtered_resampling=true", "shadows.precision=" + std::string(precision)};
      const double with = errorOf(lab.shoot(base + filtered).scatter, march).nRmse;
      std::printf("%s %s^2: unfiltered %.4f, filtered (%s bit) %.4f\n", c.technique, c.size, without, precision, with);
      EXPECT_LT(with, c.most * without) << c.technique << ' ' << c.size << ' ' << precision;
    }
  }
}

// With the sun on the screen slices span inclinations from the epipole on, and short prefixes near it want another
// polynomial between reference rays than long ones: joined by the row's own depth, three had 0.108 and four 0.033 here.
TEST(Effects, FewReferenceRaysServeTheSunOnTheScreen) {
  Laboratory lab("hall", 1, 160, 90);
  const Settings base = {"shadows.resolution=2048", "volumetrics.prefix_scheme=row", "volumetrics.row_order=column"};
  const image::FloatImage dense = lab.shoot(base + Settings{"volumetrics.technique=min_max"}).scatter;
  const std::pair<const char*, double> most[] = {{"3", 0.075}, {"4", 0.025}, {"6", 0.015}};
  for (const auto& [rays, bound] : most) {
    const double error =
        errorOf(
            lab.shoot(base + Settings{"volumetrics.technique=exact", std::string("volumetrics.reference_rays=") + rays})
                .scatter,
            dense)
            .nRmse;
    std::printf("exact, sun on the screen, K = %s: %.4f from the dense sum\n", rays, error);
    EXPECT_LT(error, bound) << rays;
  }
}

// A kept shadow map shows what a new one would: nothing is drawn while nothing changes, and all that has changed is.
TEST(Effects, KeptShadowMapsAreDrawnAgainWhenSomethingHasChanged) {
  Laboratory lab("cage", 0, 160, 90);
  const Settings base = {"shadows.resolution=512", "volumetrics.technique=ray_march", "volumetrics.steps=32"};
  const auto drawn = [](const Shot& shot) {
    return std::count_if(shot.passes.begin(), shot.passes.end(),
                         [](const auto& pass) { return pass.owner == "engine" && pass.name.starts_with("shadow "); });
  };
  image::FloatImage last;
  for (const double seconds : {0.0, 1.0}) {
    lab.at(seconds);
    const Shot anew = lab.shoot(base + Settings{"shadows.reuse=false"});
    EXPECT_EQ(drawn(anew), 2) << "two lamps";
    const Shot kept = lab.shoot(base + Settings{"shadows.reuse=true"});
    EXPECT_EQ(drawn(kept), 0) << "the second frame of the same";
    EXPECT_EQ(kept.scatter.values, anew.scatter.values);
    EXPECT_NE(kept.scatter.values, last.values) << "a lamp swings";
    last = kept.scatter;
  }
  // The lamp that hangs still, and what it lights, stay; the one that swings is drawn at each place anew.
  lab.at(2.0);
  const std::vector<Shot> moved = lab.again(2);
  EXPECT_GE(drawn(moved[0]), 1);
  EXPECT_EQ(drawn(moved[1]), 0);
  EXPECT_EQ(moved[1].scatter.values, lab.shoot(base + Settings{"shadows.reuse=false"}).scatter.values);
  // Another size is another map.
  lab.shoot(base);
  EXPECT_EQ(lab.shoot({"shadows.resolution=256", "volumetrics.technique=ray_march", "volumetrics.steps=32",
                       "shadows.reuse=true"})
                .scatter.values,
            lab.shoot({"shadows.resolution=256", "volumetrics.technique=ray_march", "volumetrics.steps=32",
                       "shadows.reuse=false"})
                .scatter.values);
}

// Frames of the same picture leave nothing behind, neither here nor in the driver: lavapipe kept a megabyte or two of
// each for the lights that it found in a uniform block (shaders/engine/include/opaque.glsl). Under a sanitizer's
// allocator this sees nothing.
TEST(Effects, FramesKeepNoMemory) {
  const auto held = [] { return static_cast<double>(allocatedBytes()) / (1 << 20); };
  for (const char* name : {"cage", "hall"}) {
    auto catalogue = app::Catalogue::load(app::pluginFolder({}));
    ASSERT_TRUE(catalogue) << catalogue.error().message;
    auto stand = bench::Stand::open(catalogue.take(), "");  // reads the picture, so that surfaces are drawn too
    ASSERT_TRUE(stand) << stand.error().message;
    auto level = app::loadLevel(name);
    ASSERT_TRUE(level) << level.error().message;
    const auto camera = app::chooseCamera(*level, 0, 0);
    ASSERT_TRUE(camera) << camera.error().message;
    ASSERT_TRUE((*stand)->setLevel(level.take()));
    const bench::Assignments settings = {{"shadows.resolution", "256"},
                                         {"volumetrics.technique", "exact"},
                                         {"volumetrics.columns", "64"},
                                         {"volumetrics.slices", "64"},
                                         {"volumetrics.prefix_scheme", "row"}};
    const auto frames = [&](int count) { ASSERT_TRUE((*stand)->render(settings, *camera, {32, 18}, 0, count, false)); };
    frames(10);
    // A driver's block of some 14 MiB comes and goes between readings. What a frame keeps shows in every reading:
    // a mebibyte of each of 60 frames is four times such a block.
    const double before = held();
    frames(60);
    const double after = held();
    EXPECT_LT(after - before, 30) << name << ": MiB kept by 60 frames, " << before << " before, " << after << " after";
  }
}

}  // namespace
}  // namespace tyndall::figures
