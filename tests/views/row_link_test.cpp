// From a pixel to its place in the rows, to the light ray of that texel in the world, and back to a pixel.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "stage.hpp"
#include "views_project.hpp"

namespace tyndall::views {
namespace {

using render::ViewRole;

struct Case {
  const char* level;
  std::uint32_t camera;
  const char* rectification;
  std::uint32_t splits;
  std::uint32_t size;  ///< columns and slices of a map
  /// How many columns the end may be off. 1: it lies in its own. A projective map's columns are planes across e1, so
  /// within a slice their distances differ by half a slice's angle times the tangent of its azimuth, which near the eye
  /// is more than a column.
  std::uint32_t slack;
};
void PrintTo(const Case& c, std::ostream* out) {
  *out << c.level << ' ' << c.camera << ' ' << c.rectification << ' ' << c.splits;
}

class RowLink : public Stage, public testing::WithParamInterface<Case> {};

/// The points nearest to each other of two lines: parameters along a (from its origin) and b.
glm::dvec2 nearestOf(const glm::dvec3& a, const glm::dvec3& alongA, const glm::dvec3& b, const glm::dvec3& alongB) {
  const double d = glm::dot(alongA, alongB), p = glm::dot(b - a, alongA), q = glm::dot(b - a, alongB);
  return glm::dvec2(p - d * q, d * p - q) / (1 - d * d);
}

/// A pixel's view ray meets the light ray of its texel, as seen from the camera within a pixel; and its end lies
/// between the light rays of the columns before and behind.
TEST_P(RowLink, RoundTripEndsAtThePixel) {
  const Case c = GetParam();
  constexpr std::uint32_t kWidth = 160, kHeight = 90;
  ASSERT_TRUE(open(
      c.level, c.camera,
      {"volumetrics.technique=exact", "volumetrics.columns=" + std::to_string(c.size),
       "volumetrics.slices=" + std::to_string(c.size), "shadows.resolution=512",
       std::string("volumetrics.rectification=") + c.rectification, "volumetrics.splits=" + std::to_string(c.splits)}));
  take(kWidth, kHeight, {});
  const Taken taken = take(kWidth, kHeight,
                           {{viewOf(ViewRole::kRowPlace)},
                            {viewOf(ViewRole::kLightRayStart)},
                            {viewOf(ViewRole::kLightRayEnd)},
                            {viewOf(ViewRole::kRowDepths)}});
  const app::ViewPicture &places = taken.views[0], &starts = taken.views[1], &ends = taken.views[2],
                         &depths = taken.views[3];
  ASSERT_EQ(starts.width, c.size);
  ASSERT_EQ(starts.height, c.size * (std::string(c.rectification) == "epipolar" ? 1 : c.splits));
  const render::View view = render::makeView(camera_, kWidth, kHeight);
  const glm::mat4 clipFromWorld = view.clipFromView * view.viewFromWorld;
  const glm::dvec3 eye(view.eye);
  std::vector<double> off;
  std::size_t blocked = 0, agreed = 0, ended = 0, between = 0;
  for (std::uint32_t y = 0; y < kHeight; ++y)
    for (std::uint32_t x = 0; x < kWidth; ++x) {
      const float slice = places.at(x, y, 0), column = places.at(x, y, 1), theta = places.at(x, y, 2);
      // A ray that ends beyond the map's last column, or before its first, has no light ray at its end.
      if (column <= 0.0f || column >= 0.999f || theta < 0.02f || theta > 3.12f) continue;
      const auto i = static_cast<std::uint32_t>(slice * static_cast<float>(starts.width)),
                 j = static_cast<std::uint32_t>(column * static_cast<float>(starts.height));
      ASSERT_LT(i, starts.width);
      ASSERT_LT(j, starts.height);
      if (starts.at(i, j, 3) < 0.5f) continue;
      const auto point = [&](const app::ViewPicture& p, std::uint32_t row) {
        return glm::dvec3(p.at(i, row, 0), p.at(i, row, 1), p.at(i, row, 2));
      };
      const glm::dvec3 start = point(starts, j), along = glm::normalize(point(ends, j) - start);
      const glm::vec4 ndc(2 * (static_cast<float>(x) + 0.5f) / kWidth - 1,
                          2 * (static_cast<float>(y) + 0.5f) / kHeight - 1, 0.5f, 1);
      const glm::vec4 inView = view.viewFromClip * ndc;
      const glm::dvec3 direction =
          glm::normalize(glm::dvec3(glm::vec3(view.worldFromView * glm::vec4(glm::vec3(inView) / inView.w, 0))));
      const double atMeeting = nearestOf(eye, direction, start, along).y;
      const auto seen = editor::projectedPoint(clipFromWorld, glm::vec3(start + along * atMeeting), {kWidth, kHeight});
      ASSERT_TRUE(seen.has_value());
      off.push_back(glm::length(*seen - glm::vec2(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f)));
      const auto meets = [&](std::uint32_t row) {
        return nearestOf(eye, direction, point(starts, row), glm::normalize(point(ends, row) - point(starts, row))).x;
      };
      if (j >= c.slack && j + c.slack < starts.height) {
        ++ended;
        const double end = double{taken.distance.at(x, y, 0)};
        between += meets(j - c.slack) <= end && end <= meets(j + c.slack);
      }
      // Whether the blocker lies before the view ray on the light ray is what the two depths say.
      if (ends.at(i, j, 3) > 0.5f && std::abs(places.at(x, y, 3) - depths.at(i, j, 0)) > 0.02f) {
        ++blocked;
        const bool before = glm::dot(point(ends, j) - start, along) < atMeeting;
        agreed += before == (depths.at(i, j, 0) < places.at(x, y, 3));
      }
    }
  ASSERT_GT(off.size(), 2000u);
  std::sort(off.begin(), off.end());
  std::printf("%zu pixels: median %.3f, 99%% %.3f, most %.3f pixels off; %zu blocked\n", off.size(),
              off[off.size() / 2], off[off.size() * 99 / 100], off.back(), blocked);
  EXPECT_LT(off[off.size() * 99 / 100], 1.0);
  EXPECT_GT(blocked, 50u);
  EXPECT_EQ(agreed, blocked);
  EXPECT_GT(ended, 2000u);
  EXPECT_EQ(between, ended);
}

INSTANTIATE_TEST_SUITE_P(Levels, RowLink,
                         testing::Values(Case{"hall", 0, "epipolar", 1, 512, 1}, Case{"hall", 0, "linear", 2, 1024, 4},
                                         Case{"cage", 0, "epipolar", 1, 512, 1}));

}  // namespace
}  // namespace tyndall::views
