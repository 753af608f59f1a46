// The tables of docs/results/exact.md: error of the technique `exact` over its parameters against the ray-traced truth,
// beside the other techniques, for suns and for lamps. What the requirements bound is asserted.
#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include <gtest/gtest.h>

#include "laboratory.hpp"
#include "table.hpp"

namespace tyndall::figures {
namespace {

struct View {
  const char* level;
  std::uint32_t camera;
  const char* what;
  /// Bound of the nRMSE of `exact` with three and with six reference rays; 0: none is asserted. Lamps: away from their
  /// pixels.
  double bound3 = 0, bound6 = 0;
};
void PrintTo(const View& view, std::ostream* out) { *out << view.level << view.camera; }
std::string nameOf(const View& view) { return std::string(view.level) + std::to_string(view.camera); }

constexpr std::uint32_t kWidth = 320, kHeight = 180, kTruthSamples = 2048;
/// Pixels about a light in the picture that count as its own.
constexpr float kOwnPixels = 16;
/// One scheme throughout: the error does not depend on it, and nothing is timed in between.
const Settings kCommon = {"shadows.resolution=4096", "volumetrics.prefix_scheme=row"};

Settings with(Settings base, const std::string& setting) { return base + Settings{"volumetrics." + setting}; }
Settings technique(const std::string& name) { return {"volumetrics.technique=" + name}; }
Settings exact(int rays) { return with(technique("exact"), "reference_rays=" + std::to_string(rays)); }
Settings march(int steps) {
  return with(with(technique("ray_march"), "steps=" + std::to_string(steps)), "jitter=none");
}

using Choice = std::function<bool(std::uint32_t, std::uint32_t)>;

/// Of the pixels that `chosen` takes, over their reference's mean; 0 where it takes none.
double nRmseOf(const image::FloatImage& picture, const image::FloatImage& reference, const Choice& chosen) {
  double squares = 0, sum = 0;
  std::size_t count = 0;
  for (std::uint32_t y = 0; y < picture.height; ++y)
    for (std::uint32_t x = 0; x < picture.width; ++x) {
      if (!chosen(x, y)) continue;
      for (std::uint32_t c = 0; c < 3; ++c) {
        const double difference = double{picture.at(x, y, c)} - reference.at(x, y, c);
        squares += difference * difference;
        sum += reference.at(x, y, c);
        ++count;
      }
    }
  return count != 0 && sum > 0 ? std::sqrt(squares / static_cast<double>(count)) / (sum / static_cast<double>(count))
                               : 0;
}

double brightness(const image::FloatImage& picture, std::uint32_t x, std::uint32_t y) {
  return (double{picture.at(x, y, 0)} + picture.at(x, y, 1) + picture.at(x, y, 2)) / 3;
}

/// Whether both end the ray at the same surface (their transmittances, in alpha): at silhouettes a rasteriser and a ray
/// tracer may differ, which is no error of any technique.
bool sameSurface(const image::FloatImage& picture, const image::FloatImage& reference, std::uint32_t x,
                 std::uint32_t y) {
  return std::abs(picture.at(x, y, 3) - reference.at(x, y, 3)) < 0.01f;
}

/// The pixel that is farthest off, of those on the same surface: "x, y: picture / truth", in means of the reference.
std::string worstOf(const image::FloatImage& picture, const image::FloatImage& reference, double mean) {
  std::uint32_t worst[2] = {};
  double most = -1;
  for (std::uint32_t y = 0; y < picture.height; ++y)
    for (std::uint32_t x = 0; x < picture.width; ++x) {
      const double off = std::abs(brightness(picture, x, y) - brightness(reference, x, y));
      if (off <= most || !sameSurface(picture, reference, x, y)) continue;
      most = off;
      worst[0] = x;
      worst[1] = y;
    }
  return std::to_string(worst[0]) + ", " + std::to_string(worst[1]) + ": " +
         figure(brightness(picture, worst[0], worst[1]) / mean) + " / " +
         figure(brightness(reference, worst[0], worst[1]) / mean);
}

/// Pixels on the same surface that stand out from all their neighbours and from the truth's: twice as bright as any, or
/// half as bright, by a tenth of the mean at least. Such a pixel is a fault of its own, not an error of a map or of
/// weights.
std::string spikesOf(const image::FloatImage& picture, const image::FloatImage& reference, double mean) {
  int count = 0;
  std::string first;
  for (std::uint32_t y = 1; y + 1 < picture.height; ++y)
    for (std::uint32_t x = 1; x + 1 < picture.width; ++x) {
      double least = brightness(reference, x, y), most = least;
      for (std::uint32_t j = y - 1; j <= y + 1; ++j)
        for (std::uint32_t i = x - 1; i <= x + 1; ++i) {
          const double truth = brightness(reference, i, j), here = i == x && j == y ? truth : brightness(picture, i, j);
          least = std::min({least, truth, here});
          most = std::max({most, truth, here});
        }
      if (!sameSurface(picture, reference, x, y)) continue;
      const double value = brightness(picture, x, y);
      const bool bright = value > 2 * most && value > most + 0.1 * mean,
                 dark = value < 0.5 * least && value < least - 0.1 * mean;
      if ((bright || dark) && count++ == 0)
        first = " (" + std::to_string(x) + ", " + std::to_string(y) + ": " + figure(value / mean) + ")";
    }
  return std::to_string(count) + first;
}

/// Pictures of one view against its truth, a row each.
class Pictures : public testing::TestWithParam<View> {
 protected:
  explicit Pictures(const std::string& table)
      : lab_(GetParam().level, GetParam().camera, kWidth, kHeight),
        report_(table + "_" + nameOf(GetParam())),
        truth_(lab_.truth(kTruthSamples)),
        lights_(lab_.lightsInPicture()),
        own_([this](std::uint32_t x, std::uint32_t y) {
          return std::any_of(lights_.begin(), lights_.end(), [&](const glm::vec2& light) {
            return glm::distance(light, glm::vec2(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f)) <=
                   kOwnPixels;
          });
        }),
        others_([this](std::uint32_t x, std::uint32_t y) { return !own_(x, y); }) {
    const View view = GetParam();
    report_.line("### " + std::string(view.level) + ", camera " + std::to_string(view.camera) + " (" + view.what + ")");
    for (const glm::vec2& light : lights_)
      if (light.x > -kOwnPixels && light.y > -kOwnPixels && light.x < kWidth + kOwnPixels &&
          light.y < kHeight + kOwnPixels)
        report_.line("A light at pixel " + figure(light.x) + ", " + figure(light.y) + ".");
    report_.line("");
  }

  image::FloatImage picture(const Settings& settings) { return lab_.shoot(kCommon + settings).scatter; }

  void headSuns() {
    report_.head(
        {"", "nRMSE", "on the same surface", "p99", "bias", "worst pixel: picture / truth, in means", "spikes"});
  }
  /// Returns the nRMSE.
  double rowSuns(const std::string& what, const Settings& settings) {
    const image::FloatImage shot = picture(settings);
    const image::ErrorMetrics error = errorOf(shot, truth_);
    const double same =
        nRmseOf(shot, truth_, [&](std::uint32_t x, std::uint32_t y) { return sameSurface(shot, truth_, x, y); });
    report_.row({what, figure(error.nRmse), figure(same), figure(error.p99), figure(error.bias, 2),
                 worstOf(shot, truth_, error.referenceMean), spikesOf(shot, truth_, error.referenceMean)});
    return error.nRmse;
  }

  void headLamps() {
    report_.head({"", "nRMSE, all", "away from lights", "away, on the same surface",
                  "within " + figure(kOwnPixels, 2) + " pixels of one", "p99, all", "bias",
                  "worst pixel: picture / truth, in means", "spikes"});
  }
  /// Returns the nRMSE away from the lights' own pixels.
  double rowLamps(const std::string& what, const Settings& settings) {
    const image::FloatImage shot = picture(settings);
    const image::ErrorMetrics error = errorOf(shot, truth_);
    const double same = nRmseOf(shot, truth_, [&](std::uint32_t x, std::uint32_t y) {
      return others_(x, y) && sameSurface(shot, truth_, x, y);
    });
    const double away = nRmseOf(shot, truth_, others_), near = nRmseOf(shot, truth_, own_);
    report_.row({what, figure(error.nRmse), figure(away), figure(same), near > 0 ? figure(near) : "–",
                 figure(error.p99), figure(error.bias, 2), worstOf(shot, truth_, error.referenceMean),
                 spikesOf(shot, truth_, error.referenceMean)});
    return away;
  }

  Laboratory lab_;
  Report report_;
  image::FloatImage truth_;
  std::vector<glm::vec2> lights_;
  Choice own_, others_;
};

std::string rayName(int rays) { return "`exact`, K = " + std::to_string(rays); }
std::string viewName(const testing::TestParamInfo<View>& given) { return nameOf(given.param); }

class ExactSuns : public Pictures {
 protected:
  ExactSuns() : Pictures("exact_suns") {}
};

TEST_P(ExactSuns, Table) {
  headSuns();
  double error[7] = {}, best = 1e9;
  for (const int rays : {1, 2, 3, 4, 6}) {
    error[rays] = rowSuns(rayName(rays), exact(rays));
    best = std::min(best, error[rays]);
  }
  const double dense = rowSuns("dense sum of the same map (`min_max`)", technique("min_max"));
  rowSuns(rayName(3) + ", map 2048²", with(with(exact(3), "columns=2048"), "slices=2048"));
  for (const char* rays : {"1", "3"})
    rowSuns("`fourier` 32, K = " + std::string(rays),
            with(with(technique("fourier"), "basis_count=32"), "reference_rays=" + std::string(rays)));
  rowSuns("`moments6`, K = 1", with(technique("moments6"), "reference_rays=1"));
  rowSuns("`ray_march` 128", march(128));
  rowSuns("`ray_march` 512", march(512));
  rowSuns("`ray_march` 4096", march(4096));
  if (GetParam().bound3 > 0) {
    EXPECT_LE(error[3], GetParam().bound3);
  }
  EXPECT_LE(best, 1.1 * dense) << "the best of K = 1, 2, 3, 4, 6 over the dense sum of the same map: " << best / dense;
}

INSTANTIATE_TEST_SUITE_P(, ExactSuns,
                         testing::Values(View{"hall", 0, "across the shafts, sun off screen", 0.05},
                                         View{"hall", 1, "sun on screen"}, View{"hall", 2, "sun off screen"},
                                         View{"forest", 0, "across the light, sun off screen", 0.02},
                                         View{"forest", 1, "sun on screen"},
                                         View{"forest", 2, "sun behind, its antipode on screen"}),
                         viewName);

class ExactLamps : public Pictures {
 protected:
  ExactLamps() : Pictures("exact_lamps") {}
};

TEST_P(ExactLamps, Table) {
  headLamps();
  double error[7] = {};
  for (const int rays : {1, 2, 3, 4, 6}) error[rays] = rowLamps(rayName(rays), exact(rays));
  rowLamps("`fourier` 32, K = 3", with(technique("fourier"), "basis_count=32"));
  rowLamps("`moments6`, K = 3", technique("moments6"));
  // The march sees no cookies yet, which the vault has.
  if (std::string(GetParam().level) != "vault")
    for (const int steps : {128, 512, 4096}) rowLamps("`ray_march` " + std::to_string(steps), march(steps));
  if (GetParam().bound3 > 0) {
    EXPECT_LE(error[3], GetParam().bound3);
  }
  if (GetParam().bound6 > 0) {
    EXPECT_LE(error[6], GetParam().bound6);
  }
}

INSTANTIATE_TEST_SUITE_P(, ExactLamps,
                         testing::Values(View{"vault", 0, "both lamps off screen", 0.04, 0.04},
                                         View{"vault", 1, "a lamp on screen", 0.04, 0.04},
                                         View{"vault", 2, "along a cone, lamp behind", 0, 0.04},
                                         View{"cage", 0, "lamp off screen", 0.04, 0.04},
                                         View{"cage", 1, "lamp on screen", 0.04, 0.04},
                                         View{"cage", 2, "lamp on screen, near", 0.04, 0.04}),
                         viewName);

class ExactLevels : public Pictures {
 protected:
  ExactLevels() : Pictures("exact_levels") {}
};

TEST_P(ExactLevels, Table) {
  const image::FloatImage linear = picture(technique("min_max")),
                          nearest = picture(with(technique("min_max"), "row_filter=nearest"));
  report_.head({"", "nRMSE, dense sum of the map", "p99, dense sum", "nRMSE, truth", "p99, truth"});
  const auto row = [&](const std::string& what, const Settings& settings, const image::FloatImage& dense) {
    const image::FloatImage shot = picture(settings);
    const image::ErrorMetrics map = errorOf(shot, dense), truth = errorOf(shot, truth_);
    report_.row({what, figure(map.nRmse), figure(map.p99), figure(truth.nRmse), figure(truth.p99)});
    return map.nRmse;
  };
  double last = 1e9;
  for (const int levels : {2, 4, 6, 8, 10}) {
    const double error =
        row("K = 6, levels = " + std::to_string(levels), with(exact(6), "levels=" + std::to_string(levels)), linear);
    EXPECT_LE(error, 1.02 * last) << "more levels must not make it worse: " << levels;
    last = error;
  }
  for (const int levels : {2, 4, 6, 8, 10})
    row("K = 3, levels = " + std::to_string(levels), with(exact(3), "levels=" + std::to_string(levels)), linear);
  for (const int rays : {3, 6})
    for (const char* precision : {"standard", "full"})
      row("K = " + std::to_string(rays) + ", precision = " + precision,
          with(exact(rays), "precision=" + std::string(precision)), linear);
  for (const char* scheme : {"block", "scan"})
    row("K = 6, prefix_scheme = " + std::string(scheme), with(exact(6), "prefix_scheme=" + std::string(scheme)),
        linear);
  row("K = 6, prefix_bounds = false", with(exact(6), "prefix_bounds=false"), linear);
  row("K = 6, row_filter = nearest, both", with(exact(6), "row_filter=nearest"), nearest);
  row("K = 6, row_filter = linear, both", exact(6), linear);
  row("dense sum, row_filter = nearest", with(technique("min_max"), "row_filter=nearest"), linear);
  row("dense sum, row_filter = linear", technique("min_max"), linear);
}

INSTANTIATE_TEST_SUITE_P(, ExactLevels,
                         testing::Values(View{"hall", 0, "sun off screen"}, View{"forest", 0, "sun off screen"}),
                         viewName);

class ExactBlock : public Pictures {
 protected:
  ExactBlock() : Pictures("exact_block") {}
};

TEST_P(ExactBlock, Table) {
  headLamps();
  for (const int rays : {3, 6})
    for (const char* block : {"0", "8", "16", "24"})
      rowLamps(rayName(rays) + ", block " + block, with(exact(rays), "epipole_block=" + std::string(block)));
}

INSTANTIATE_TEST_SUITE_P(, ExactBlock,
                         testing::Values(View{"cage", 1, "lamp on screen"}, View{"hall", 1, "sun on screen"}),
                         viewName);

class ExactMap : public Pictures {
 protected:
  ExactMap() : Pictures("exact_map") {}
};

TEST_P(ExactMap, Table) {
  headLamps();
  const double one = rowLamps(rayName(6), exact(6));
  const double slices = rowLamps(rayName(6) + ", 2048 slices", with(exact(6), "slices=2048"));
  // Between the two large maps, since a device may not hold both and the last picture's memory is kept until the next
  // one's is there.
  rowLamps(rayName(6) + ", slices by the border", with(exact(6), "slice_spacing=border"));
  rowLamps(rayName(6) + ", 2048 columns", with(exact(6), "columns=2048"));
  // Edges of the cookie are finer than a slice.
  EXPECT_LT(slices, one);
}

INSTANTIATE_TEST_SUITE_P(, ExactMap,
                         testing::Values(View{"vault", 1, "a lamp with a cookie, 11 pixels from the border"}),
                         viewName);

}  // namespace
}  // namespace tyndall::figures
