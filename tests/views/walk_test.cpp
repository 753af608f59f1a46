// The walk that the editor shows is a search of the row it belongs to: it counts what is there.
#include <algorithm>
#include <cmath>
#include <random>

#include "row_walk.hpp"
#include "stage.hpp"

namespace tyndall::views {
namespace {

using render::ViewRole;

constexpr float kCountScale = 65535;

class WalkOf : public Stage, public testing::WithParamInterface<const char*> {};

TEST_P(WalkOf, CountsTheBlockersBeforeTheRay) {
  ASSERT_TRUE(
      open("hall", 0,
           {"volumetrics.technique=exact", "volumetrics.columns=96", "volumetrics.slices=64", "shadows.resolution=256",
            "volumetrics.row_order=column", std::string("volumetrics.prefix_scheme=") + GetParam()}));
  take(80, 45, {});
  std::vector<app::ViewRequest> requests{{viewOf(ViewRole::kWalkRanks)}, {viewOf(ViewRole::kRowDepths)}};
  bool across = false;
  for (const render::DebugViewInfo& view : session_->debugViews())
    if (view.role == ViewRole::kWalkLevel || view.role == ViewRole::kWalkLevelAcross)
      requests.push_back({view.name}), across = view.role == ViewRole::kWalkLevelAcross;
  EXPECT_EQ(across, std::string(GetParam()) == "scan");
  ASSERT_EQ(requests.size(), 2u + 7u);  // 96 columns are padded to 128 = 2^7
  const Taken taken = take(80, 45, requests);
  const app::ViewPicture &ranks = taken.views[0], &depths = taken.views[1];
  const auto bins = static_cast<float>(ranks.height - 1);
  std::mt19937 random(5);
  const auto below = [&](std::uint32_t count) {
    return std::uniform_int_distribution<std::uint32_t>(0, count - 1)(random);
  };
  std::size_t some = 0;
  for (int i = 0; i < 4000; ++i) {
    const std::uint32_t slice = below(depths.width), elements = below(depths.height + 1);
    // Mostly about where depths are, so that not all lie on one side.
    const float near = depths.at(slice, below(depths.height), 0);
    const float depth = std::clamp(near + std::uniform_real_distribution(-0.02f, 0.02f)(random), 0.0f, 1.0f);
    editor::WalkRow row;
    for (std::uint32_t bin = 0; bin < ranks.height; ++bin) row.before.push_back(ranks.at(slice, bin, 0) * kCountScale);
    for (std::size_t level = 2; level < taken.views.size(); ++level) {
      const app::ViewPicture& view = taken.views[level];
      auto& texels = row.levels.emplace_back(across ? view.width : view.height);
      for (std::uint32_t p = 0; p < texels.size(); ++p)
        texels[p] = {view.at(across ? p : slice, across ? slice : p, 0) * kCountScale,
                     view.at(across ? p : slice, across ? slice : p, 1)};
    }
    const editor::Walk walk = editor::walkOf(row, elements, depth);
    // By hand. Depths of the ray's own bin may count either way.
    const float bin = std::min(std::floor(depth * bins), bins - 1);
    std::uint32_t least = 0, most = 0;
    for (std::uint32_t column = 0; column < elements; ++column) {
      const float at = depths.at(slice, column, 0) * bins;
      least += at < bin - 1e-3f, most += at < bin + 1 + 1e-3f;
    }
    ASSERT_GE(walk.blockers + walk.left, least) << i;
    ASSERT_LE(walk.blockers, most) << i;
    ASSERT_EQ(walk.elements, elements);
    ASSERT_GE(walk.blocked, -1e-6);
    ASSERT_LE(walk.blocked, 1 + 1e-4);
    if (most == 0) {
      ASSERT_LT(walk.blocked, 1e-4) << i;
    }
    if (elements > 0 && least == elements) {
      ASSERT_GT(walk.blocked, 1 - 1e-3) << i;
    }
    some += least > 0 && most < elements;
    std::uint32_t left = elements;
    for (const editor::WalkStep& step : walk.steps) {
      ASSERT_EQ(step.elements, left);
      left = step.second ? step.elements - step.zeros : step.zeros;
    }
    ASSERT_EQ(left, walk.left);
  }
  EXPECT_GT(some, 500u);
}

INSTANTIATE_TEST_SUITE_P(Schemes, WalkOf, testing::Values("row", "scan"));

}  // namespace
}  // namespace tyndall::views
