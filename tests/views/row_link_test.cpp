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
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.level << ' ' << c.camera << ' ' << c.rectification << ' ' << c.splits; }

class RowLink : public Stage, public testing::WithParamInterface<Case> {};

/// What a pixel sees, the end of its view ray, lies on the light ray of its texel: the point of that ray nearest to it is seen within a pixel.
TEST_P(RowLink, RoundTripEndsAtThePixel) {
  const Case c = GetParam();
  constexpr std::uint32_t kWidth = 160, kHeight = 90, kSize = 1024;
  ASSERT_TRUE(open(c.level, c.camera, {"volumetrics.technique=exact", "volumetrics.columns=1024", "volumetrics.slices=1024", "shadows.resolution=512",
                                       std::string("volumetrics.rectification=") + c.rectification, "volumetrics.splits=" + std::to_string(c.splits)}));
  take(kWidth, kHeight, {});
  const Taken taken = take(kWidth, kHeight, {{viewOf(ViewRole::kRowPlace)}, {viewOf(ViewRole::kLightRayStart)}, {viewOf(ViewRole::kLightRayEnd)}, {viewOf(ViewRole::kRowDepths)}});
  const app::ViewPicture &places = taken.views[0], &starts = taken.views[1], &ends = taken.views[2], &depths = taken.views[3];
  ASSERT_EQ(starts.width, kSize);
  ASSERT_EQ(starts.height, kSize * (std::string(c.rectification) == "epipolar" ? 1 : c.splits));
  const render::View view = render::makeView(camera_, kWidth, kHeight);
  const glm::mat4 clipFromWorld = view.clipFromView * view.viewFromWorld;
  const glm::vec3 eye = view.eye;
  std::vector<double> off;
  std::size_t blocked = 0, agreed = 0;
  for (std::uint32_t y = 0; y < kHeight; ++y)
    for (std::uint32_t x = 0; x < kWidth; ++x) {
      const float slice = places.at(x, y, 0), column = places.at(x, y, 1), theta = places.at(x, y, 2);
      // A ray that ends beyond the map's last column, or before its first, has no light ray at its end.
      if (column <= 0.0f || column >= 0.999f || theta < 0.02f || theta > 3.12f) continue;
      const auto i = static_cast<std::uint32_t>(slice * static_cast<float>(starts.width)), j = static_cast<std::uint32_t>(column * static_cast<float>(starts.height));
      ASSERT_LT(i, starts.width);
      ASSERT_LT(j, starts.height);
      if (starts.at(i, j, 3) < 0.5f) continue;
      const auto point = [&](const app::ViewPicture& p) { return glm::dvec3(p.at(i, j, 0), p.at(i, j, 1), p.at(i, j, 2)); };
      const glm::dvec3 start = point(starts), along = glm::normalize(point(ends) - start);
      const glm::vec4 ndc(2 * (static_cast<float>(x) + 0.5f) / kWidth - 1, 2 * (static_cast<float>(y) + 0.5f) / kHeight - 1, 0.5f, 1);
      const glm::vec4 inView = view.viewFromClip * ndc;
      const glm::vec3 direction = glm::normalize(glm::vec3(view.worldFromView * glm::vec4(glm::vec3(inView) / inView.w, 0)));
      const glm::dvec3 surface = glm::dvec3(eye + direction * taken.distance.at(x, y, 0));
      const glm::dvec3 nearest = start + along * glm::dot(surface - start, along);
      const auto seen = editor::projectedPoint(clipFromWorld, glm::vec3(nearest), {kWidth, kHeight});
      ASSERT_TRUE(seen.has_value());
      off.push_back(glm::length(*seen - glm::vec2(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f)));
      // The inclination of the blocker tells what the stored depth tells: whether it lies before the surface on the light ray.
      if (ends.at(i, j, 3) > 0.5f && std::abs(places.at(x, y, 3) - depths.at(i, j, 0)) > 0.02f) {
        ++blocked;
        const bool before = glm::dot(point(ends) - start, along) < glm::dot(nearest - start, along);
        agreed += before == (depths.at(i, j, 0) < places.at(x, y, 3));
      }
    }
  ASSERT_GT(off.size(), 2000u);
  std::sort(off.begin(), off.end());
  std::printf("%zu pixels: median %.3f, 99%% %.3f, most %.3f pixels off; %zu blocked\n", off.size(), off[off.size() / 2], off[off.size() * 99 / 100], off.back(), blocked);
  EXPECT_LT(off[off.size() * 99 / 100], 1.0);
  EXPECT_GT(blocked, 50u);
  EXPECT_EQ(agreed, blocked);
}

INSTANTIATE_TEST_SUITE_P(Levels, RowLink, testing::Values(Case{"hall", 0, "epipolar", 1}, Case{"forest", 0, "linear", 2}, Case{"cage", 0, "epipolar", 1}));

}  // namespace
}  // namespace tyndall::views
