// What is read of a view is what is in its image: against the outputs of the frame itself and against the picture shown
// of the view.
#include <algorithm>
#include <cmath>

#include "stage.hpp"
#include "views_colour.hpp"

namespace tyndall::views {
namespace {

const std::vector<std::string> kSmall = {"volumetrics.technique=moments6", "volumetrics.columns=128",
                                         "volumetrics.slices=128", "shadows.resolution=256"};

TEST_F(Stage, ScatterAndDepthAreThoseOfTheFrame) {
  ASSERT_TRUE(open("hall", 0, kSmall));
  const Taken taken = take(80, 45, {{"scatter"}, {"depth"}});
  ASSERT_EQ(taken.views.size(), 2u);
  EXPECT_EQ(taken.views[0].channels, 4u);
  EXPECT_EQ(taken.views[0].values, taken.scatter.values);
  EXPECT_EQ(taken.views[1].channels, 1u);
  EXPECT_EQ(taken.views[1].values, taken.distance.values);
  EXPECT_GT(*std::max_element(taken.scatter.values.begin(), taken.scatter.values.end()), 0.0f);
}

/// Every view of engine and plugin: the 8-bit picture shown of it, at the view's own size, is its numbers stretched.
TEST_F(Stage, EveryViewIsShownAsItsNumbersSay) {
  ASSERT_TRUE(open("hall", 0, kSmall));
  take(80, 45, {});
  std::size_t compared = 0;
  for (const render::DebugViewInfo& info : session_->debugViews()) {
    SCOPED_TRACE(info.name);
    const Taken taken = take(80, 45, {{info.name}}, info.name);
    const app::ViewPicture& view = taken.views.at(0);
    if (view.width != 80 || view.height != 45) continue;  // shown by the nearest texel of another raster
    ++compared;
    const auto shown = editor::stretched(view.values, view.channels, {view.shown, false, view.low, view.high});
    int most = 0;
    for (std::size_t i = 0; i < std::size_t{80} * 45; ++i)
      for (std::size_t c = 0; c < 3; ++c) {
        // Normals are shown without a code for brightness.
        const int expected = info.name == "normal"
                                 ? static_cast<int>(std::lround((view.values[i * 3 + c] * 0.5f + 0.5f) * 255))
                                 : shown[i * 4 + c];
        most = std::max(most, std::abs(expected - int{taken.picture.values[i * 3 + c]}));
      }
    EXPECT_LE(most, 1);
  }
  EXPECT_GE(compared, 10u);
}

TEST_F(Stage, OtherLayersAndImagesOfOtherSizesAreRead) {
  ASSERT_TRUE(open("hall", 0, kSmall));
  take(80, 45, {});
  const Taken taken =
      take(80, 45, {{"moment_1"}, {"moment_1", 1}, {"moment_5"}, {"light_ray_end"}, {"shadow_map"}, {"no such view"}});
  ASSERT_EQ(taken.views.size(), 6u);
  EXPECT_EQ(taken.views[0].width, 128u);
  EXPECT_EQ(taken.views[0].height, 128u);
  EXPECT_EQ(taken.views[0].layers, 2u);
  EXPECT_EQ(taken.views[1].values, taken.views[2].values);  // moments 5 and 6 lie in the second layer
  EXPECT_NE(taken.views[0].values, taken.views[1].values);
  EXPECT_EQ(taken.views[3].layer, 1u);
  EXPECT_EQ(taken.views[4].width, 256u);
  EXPECT_EQ(taken.views[4].format, "D32 float");
  EXPECT_EQ(taken.views[5].width, 0u);
  EXPECT_TRUE(taken.views[5].values.empty());
}

TEST_F(Stage, RolesAreThereWhereTheyBelong) {
  ASSERT_TRUE(open("hall", 0, kSmall));
  using render::ViewRole;
  for (const char* technique : {"fourier", "moments4", "moments6", "min_max", "exact"}) {
    SCOPED_TRACE(technique);
    set({std::string("volumetrics.technique=") + technique});
    take(80, 45, {});
    for (const ViewRole role : {ViewRole::kRows, ViewRole::kRowDepths, ViewRole::kRowPlace, ViewRole::kLightRayStart,
                                ViewRole::kLightRayEnd, ViewRole::kReference})
      EXPECT_NE(viewOf(role), "") << static_cast<int>(role);
  }
  set({"volumetrics.technique=ray_march"});
  take(80, 45, {});
  EXPECT_EQ(viewOf(ViewRole::kRowPlace), "");
  EXPECT_NE(viewOf(ViewRole::kReference), "");
}

}  // namespace
}  // namespace tyndall::views
