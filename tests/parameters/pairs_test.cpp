// Each parameter against its neighbour value: it changes the picture if the technique says that it reads it for the
// picture, leaves it if it is about speed only, and leaves it to the bit if the technique does not read it.
#include <algorithm>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "laboratory.hpp"

namespace tyndall::figures {
namespace {

const Settings kSmall = {"shadows.resolution=512", "volumetrics.columns=128", "volumetrics.slices=128",
                         "volumetrics.prefix_scheme=row"};

enum class Change {
  kPicture,  ///< nRMSE above 1e-3
  kSpeed,    ///< nRMSE below 5e-4: sums in another order
  kNothing,  ///< equal to the bit
};

struct Pair {
  const char* technique;
  const char* parameter;
  Change change;
  const char *a, *b;
  Settings given = {};
  int view = 0;  ///< of kViews
};

/// A linear map that stands where the light is: with few columns, or the sun near the screen, the epipolar one would.
const Settings kLinear = {"volumetrics.rectification=linear", "volumetrics.columns=512"};

/// exact by its wavelet matrix.
const Settings kColumnOrder = {"volumetrics.row_order=column"};

struct View {
  const char* level;
  std::uint32_t camera;
};
constexpr View kViews[] = {{"hall", 0}, {"hall", 1}, {"forest", 0}};

const Pair kPairs[] = {
    {"ray_march", "steps", Change::kPicture, "16", "64"},
    {"ray_march", "jitter", Change::kPicture, "none", "white"},
    {"ray_march", "march_spacing", Change::kPicture, "distance", "transmittance", {"volumetrics.steps=8"}},
    {"min_max", "columns", Change::kPicture, "128", "256"},
    {"min_max", "slices", Change::kPicture, "128", "256"},
    {"min_max", "slice_spacing", Change::kPicture, "azimuth", "border"},
    {"min_max", "column_spacing", Change::kPicture, "distance", "transmittance"},
    {"min_max", "column_spacing", Change::kNothing, "distance", "transmittance", kLinear, 2},
    {"exact", "column_spacing", Change::kPicture, "distance", "transmittance"},
    {"fourier", "column_spacing", Change::kPicture, "distance", "transmittance"},
    {"moments6", "column_spacing", Change::kPicture, "distance", "transmittance"},
    {"min_max", "row_filter", Change::kPicture, "nearest", "linear"},
    {"min_max", "row_filter", Change::kNothing, "linear", "mipmapped"},
    {"min_max", "rectification", Change::kPicture, "linear", "epipolar", {"volumetrics.columns=512"}, 2},
    {"min_max", "splits", Change::kPicture, "1", "3", kLinear, 2},
    {"min_max", "splits", Change::kNothing, "1", "3"},  // epipolar maps are not split
    {"min_max", "near_correction", Change::kNothing, "false", "true"},
    {"min_max", "epipole_block", Change::kPicture, "0", "20", {}, 1},
    {"fourier", "basis_count", Change::kPicture, "8", "32"},
    {"fourier", "basis_count", Change::kPicture, "30", "32"},
    {"fourier", "bases_per_thread", Change::kSpeed, "4", "32"},
    {"fourier", "basis_evaluation", Change::kSpeed, "fused", "separate", {"volumetrics.precision=full"}},
    {"fourier", "precision", Change::kPicture, "standard", "full"},
    {"fourier", "precision", Change::kNothing, "compact", "standard"},
    {"fourier", "depth_warp", Change::kPicture, "0", "1"},
    {"fourier", "row_filter", Change::kPicture, "linear", "mipmapped"},
    {"fourier", "prefix_bounds", Change::kPicture, "false", "true"},
    {"moments6", "overestimation", Change::kPicture, "lower", "half"},
    {"moments6", "overestimation", Change::kPicture, "half", "adaptive"},
    {"moments6", "precision", Change::kPicture, "compact", "standard"},
    {"moments6", "precision", Change::kPicture, "standard", "full"},
    {"moments4",
     "precision",
     Change::kPicture,
     "compact",
     "standard",
     {"volumetrics.overestimation=half", "volumetrics.prefix_bounds=false"}},
    {"moments4", "precision", Change::kNothing, "standard", "full"},
    {"moments6", "reference_rays", Change::kPicture, "1", "3"},
    {"moments6", "reference_ray", Change::kPicture, "bisectrix", "mean", {"volumetrics.reference_rays=1"}},
    {"moments6", "reference_ray", Change::kPicture, "optimum", "mean", {"volumetrics.reference_rays=1"}},
    {"moments6", "reference_ray", Change::kNothing, "bisectrix", "mean"},
    {"moments6", "weights", Change::kPicture, "average", "transmittance", {"medium.sigma_t=0.2"}},
    {"moments6", "prefix_bounds", Change::kPicture, "false", "true"},
    {"fourier", "filtered_resampling", Change::kPicture, "false", "true"},
    {"moments4", "filtered_resampling", Change::kPicture, "false", "true"},
    {"moments6", "filtered_resampling", Change::kPicture, "false", "true"},
    {"moments6", "regions", Change::kPicture, "1", "4"},
    {"fourier", "regions", Change::kPicture, "1", "4"},
    {"fourier", "reference_rays", Change::kPicture, "1", "3"},
    {"moments4", "reference_rays", Change::kPicture, "1", "3"},
    {"moments4", "overestimation", Change::kPicture, "half", "upper"},
    {"moments6", "near_correction", Change::kPicture, "false", "true", kLinear, 2},
    {"exact", "levels", Change::kPicture, "4", "6", kColumnOrder},
    {"exact", "levels", Change::kNothing, "0", "14", kColumnOrder},
    {"exact", "columns", Change::kPicture, "100", "200"},
    {"exact", "slices", Change::kPicture, "128", "256"},
    {"exact", "slice_spacing", Change::kPicture, "azimuth", "border"},
    {"exact", "rectification", Change::kPicture, "linear", "epipolar", {"volumetrics.columns=512"}, 2},
    {"exact", "splits", Change::kPicture, "1", "3", kLinear, 2},
    {"exact", "row_filter", Change::kPicture, "nearest", "linear"},
    {"exact", "row_filter", Change::kNothing, "linear", "mipmapped"},
    {"exact", "reference_rays", Change::kPicture, "1", "3", kColumnOrder},
    {"exact",
     "reference_ray",
     Change::kPicture,
     "optimum",
     "mean",
     {"volumetrics.reference_rays=1", "volumetrics.row_order=column"}},
    {"exact", "weights", Change::kPicture, "average", "transmittance", {"medium.sigma_t=0.2"}},
    {"exact",
     "prefix_bounds",
     Change::kSpeed,
     "false",
     "true",
     {"volumetrics.columns=1024", "volumetrics.slices=256", "volumetrics.row_order=column"}},
    {"exact", "precision", Change::kSpeed, "standard", "full", kColumnOrder},
    {"exact", "precision", Change::kNothing, "compact", "standard", kColumnOrder},
    {"exact", "row_order", Change::kPicture, "depth", "column"},
    {"exact", "row_blocks", Change::kPicture, "8", "columns", {"volumetrics.columns=1024", "medium.sigma_t=0.3"}},
    {"exact", "prefix_scheme", Change::kNothing, "row", "block"},
    {"exact", "prefix_scheme", Change::kNothing, "row", "scan"},
    {"exact", "levels", Change::kNothing, "4", "6"},
    {"exact", "reference_rays", Change::kNothing, "3", "6"},
    {"exact", "prefix_bounds", Change::kNothing, "false", "true"},
    {"exact", "precision", Change::kNothing, "standard", "full"},
    {"exact", "epipole_block", Change::kPicture, "0", "20", {}, 1},
    {"exact", "depth_warp", Change::kPicture, "0", "1", {"volumetrics.columns=64"}},
    {"exact", "prefix_scheme", Change::kSpeed, "row", "block", kColumnOrder},
    {"exact", "prefix_scheme", Change::kSpeed, "row", "scan", kColumnOrder},
    {"moments6", "prefix_scheme", Change::kSpeed, "row", "block"},
    {"moments6", "prefix_scheme", Change::kSpeed, "row", "scan"},
    {"fourier", "prefix_scheme", Change::kSpeed, "block", "scan"},
};

TEST(Pairs, EachParameterChangesWhatItShould) {
  for (int view = 0; view < static_cast<int>(std::size(kViews)); ++view) {
    Laboratory lab(kViews[view].level, kViews[view].camera, 160, 90);
    for (const Pair& pair : kPairs) {
      if (pair.view != view) continue;
      const Settings base = kSmall + Settings{"volumetrics.technique=" + std::string(pair.technique)} + pair.given;
      const std::string id = "volumetrics." + std::string(pair.parameter) + "=";
      const Shot a = lab.shoot(base + Settings{id + pair.a}), b = lab.shoot(base + Settings{id + pair.b});
      const double apart = errorOf(a.scatter, b.scatter).nRmse;
      const std::string what = std::string(pair.technique) + ": " + id + pair.a + "|" + pair.b;
      std::printf("%-60s %.5f\n", what.c_str(), apart);
      switch (pair.change) {
        case Change::kPicture: EXPECT_GT(apart, 1e-3) << what; break;
        case Change::kSpeed: EXPECT_LT(apart, 5e-4) << what; break;
        case Change::kNothing: EXPECT_EQ(a.scatter.values, b.scatter.values) << what; break;
      }
      // Nothing but the visibility of light depends on them: the transmittance to the surface stays.
      for (std::size_t i = 3; i < a.scatter.values.size(); i += 4)
        ASSERT_EQ(a.scatter.values[i], b.scatter.values[i]) << what;
    }
  }
}

/// Another value of `parameter` than its default that is built.
std::string another(const params::Parameter& p) {
  if (p.type == params::Type::kFloat)
    return params::toText(
        p, p.defaultValue +
               0.37 * ((p.defaultValue < (p.builtMin + p.builtMax) / 2 ? p.builtMax : p.builtMin) - p.defaultValue));
  if (p.type == params::Type::kInt)
    return params::toText(p, p.defaultValue == p.builtMax ? p.builtMin : std::min(p.builtMax, p.defaultValue + 1));
  const auto count = p.type == params::Type::kBool ? std::size_t{2} : p.choices.size();
  for (std::size_t i = 0; i < count; ++i)
    if (static_cast<double>(i) != p.defaultValue && (p.built.empty() || p.built[i]))
      return params::toText(p, static_cast<double>(i));
  return "";
}

TEST(Pairs, WhatATechniqueDoesNotReadChangesNothing) {
  Laboratory lab("hall", 0, 160, 90);
  const host::Plugin& plugin = lab.session().catalogue().effectPlugin();
  int tried = 0;
  for (const host::TechniqueInfo& technique : plugin.techniques()) {
    const Settings base = kSmall + Settings{"volumetrics.technique=" + technique.id};
    const Shot before = lab.shoot(base);
    for (const params::Parameter& p : plugin.parameters()) {
      if (std::find(technique.reads.begin(), technique.reads.end(), p.id) != technique.reads.end()) continue;
      const std::string value = another(p);
      if (value.empty()) continue;
      ++tried;
      EXPECT_EQ(lab.shoot(base + Settings{p.id + "=" + value}).scatter.values, before.scatter.values)
          << technique.id << " does not read " << p.id << ", set to " << value;
      EXPECT_THAT(lab.session().catalogue().unusedSettings(), testing::Contains(p.id));
    }
  }
  EXPECT_GT(tried, 30);
}

}  // namespace
}  // namespace tyndall::figures
