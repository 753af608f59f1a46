// What the window shows, and how the program refuses.
#include <algorithm>
#include <set>

#include "display.hpp"
#include "image/image_io.hpp"

namespace tyndall::editor_test {
namespace {

/// How many different colours a part of the picture has.
std::size_t colours(const image::ByteImage& picture, std::uint32_t left, std::uint32_t top, std::uint32_t right,
                    std::uint32_t bottom) {
  std::set<std::uint32_t> seen;
  for (std::uint32_t y = top; y < bottom; ++y)
    for (std::uint32_t x = left; x < right; ++x) {
      const std::uint8_t* p = &picture.values[(std::size_t{y} * picture.width + x) * picture.channels];
      seen.insert(p[0] << 16 | p[1] << 8 | p[2]);
    }
  return seen.size();
}

TEST_F(EditorTest, ScreenshotShowsPictureAndPanels) {
  const auto file = folder_ / "window.png";
  startEditor({"hall", "--frames", "8", "--size", "640x400", "--screenshot", file.string(), "--validate", "--set",
               "volumetrics.columns=64", "--set", "volumetrics.slices=64", "--set", "shadows.resolution=256", "--set",
               "volumetrics.prefix_scheme=row"});
  ASSERT_EQ(waitEditor(280), 0) << errors();
  EXPECT_EQ(errors(), "");
  const auto now = state();
  ASSERT_TRUE(now.is_object());
  EXPECT_EQ(now["frames"], 8);
  EXPECT_EQ(now["pictures"], 8);
  auto picture = image::readPng(file);
  ASSERT_TRUE(picture) << picture.error().message;
  EXPECT_EQ(picture->width, 640u);
  EXPECT_EQ(picture->height, 400u);
  const auto viewport = now["widgets"]["viewport"].get<std::vector<double>>();
  const auto edge = static_cast<std::uint32_t>(viewport[2]), top = static_cast<std::uint32_t>(viewport[1]),
             bottom = static_cast<std::uint32_t>(viewport[1] + viewport[3]);
  ASSERT_GT(edge, 200u);
  ASSERT_LT(edge, 500u);
  // A lit, foggy hall has hundreds of shades; text on a panel a few dozen, and both far more than an empty area's one.
  EXPECT_GT(colours(*picture, 0, top, edge, bottom), 300u);
  EXPECT_GT(colours(*picture, edge, 0, 640, bottom), 20u);
  EXPECT_GT(colours(*picture, 0, bottom, 640, 400), 1u);  // one line of text, not smoothed
}

TEST_F(EditorTest, WithoutADisplayItSaysSoInOneLine) {
  display_ = "";
  startEditor({"hall", "--frames", "1"});
  EXPECT_EQ(waitEditor(), 1);
  const std::string text = errors();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
  EXPECT_NE(text.find("display"), std::string::npos) << text;
}

TEST_F(EditorTest, BadCallsAreRefusedInOneLine) {
  const std::vector<std::vector<std::string>> calls = {{"no_such_level"},
                                                       {"hall", "--set", "volumetrics.technique=nothing"},
                                                       {"hall", "--camera", "99"},
                                                       {"hall", "--size", "0x10"},
                                                       {"hall", "--frames"},
                                                       {"hall", "--frame", "3"},
                                                       {"hall", "two"},
                                                       {"hall", "--screenshot", "picture.txt"}};
  for (const auto& call : calls) {
    SCOPED_TRACE(call.back());
    startEditor(call);
    EXPECT_EQ(waitEditor(), 2);
    const std::string text = errors();
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
  }
}

}  // namespace
}  // namespace tyndall::editor_test
