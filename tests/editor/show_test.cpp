// The whole way once, with mouse and keyboard: open a level, change the technique, drag a slider, undo, load a preset,
// pick a debug view, take a capture. Each step is checked by what the editor says of itself and by what is on the
// screen.
#include <cmath>
#include <fstream>

#include "session.hpp"

namespace tyndall::editor_test {
namespace {

namespace fs = std::filesystem;

// Pixels of the mouse and of what blinks.
constexpr double kNothing = 0.002;

class ShowTest : public SessionTest {};

TEST_F(ShowTest, EachStepIsSeenAndSaid) {
  startTiny("760x500");
  const image::ByteImage tinyLevel = lookAtPicture();
  // Opens a level.
  const fs::path hall = fs::path(TYNDALL_BIN_DIR) / "levels" / "hall.glb";
  choose("o", hall);
  ASSERT_FALSE(waitFor([&](const Json& s) { return s["level"] == hall.string(); }, 60).is_null()) << state()["message"];
  EXPECT_EQ(state()["history"]["steps"], 1);
  const image::ByteImage opened = lookAtPicture();
  EXPECT_GT(changedShare(tinyLevel, opened), 0.5);

  // Another technique, from the list: the light in the air appears.
  click("volumetrics.technique");
  ASSERT_TRUE(appears("volumetrics.technique=ray_march"));
  click("volumetrics.technique=ray_march");
  ASSERT_TRUE(becomes("volumetrics.technique", "ray_march"));
  ASSERT_TRUE(stepIs(1));
  const image::ByteImage marched = lookAtPicture();
  EXPECT_GT(changedShare(opened, marched), 0.3);

  // A slider, dragged. The search leaves what matches.
  click("search");
  input({"type", "--delay", "60", "exposure"});
  ASSERT_FALSE(waitFor([](const Json& s) { return !s["widgets"].contains("volumetrics.technique"); }, 20).is_null());
  const std::string exposure = setting("view.exposure");
  drag("view.exposure", 0.2, 0.75);
  ASSERT_TRUE(stepIs(2));  // one, whatever it passed
  const std::string dragged = setting("view.exposure");
  EXPECT_NE(dragged, exposure);
  const image::ByteImage exposed = lookAtPicture();
  EXPECT_NE(brightness(exposed) > brightness(marched), std::stod(dragged) < std::stod(exposure));
  EXPECT_GT(std::abs(brightness(exposed) - brightness(marched)), 2);

  // Undone: the same pixels. Redone: those.
  keys({"ctrl", "z"});
  ASSERT_TRUE(becomes("view.exposure", exposure));
  EXPECT_EQ(state()["history"]["present"], 1);
  EXPECT_LT(changedShare(marched, lookAtPicture()), kNothing);
  keys({"ctrl", "y"});
  ASSERT_TRUE(becomes("view.exposure", dragged));
  EXPECT_LT(changedShare(exposed, lookAtPicture()), kNothing);

  // A preset: what it names is set.
  std::ofstream(folder_ / "p.json")
      << R"({"volumetrics.technique": "ray_march", "volumetrics.steps": 9, "shadows.resolution": 256, "view.exposure": 0.2})";
  choose("l", folder_ / "p.json");
  ASSERT_TRUE(becomes("volumetrics.steps", "9")) << state()["message"];
  EXPECT_EQ(setting("view.exposure"), "0.2");
  EXPECT_EQ(setting("volumetrics.columns"), "64") << "what it does not name stays";
  ASSERT_TRUE(stepIs(3));
  const image::ByteImage preset = lookAtPicture();
  EXPECT_LT(brightness(preset), brightness(marched) * 0.8);

  // A debug view, from the list.
  click("debug view");
  ASSERT_TRUE(appears("show normal"));
  click("show normal");
  ASSERT_FALSE(waitFor([](const Json& s) { return s["debug_view"] == "normal"; }, 20).is_null());
  const image::ByteImage normals = lookAtPicture();
  EXPECT_GT(changedShare(preset, normals), 0.9);

  // A capture, with the numbers of the view: what is in the files is what is on the screen, and the command makes it
  // again.
  openCapture();
  click("capture view");
  const std::string command = capture();
  const fs::path captured = folder_ / "hall-001.png", again = folder_ / "again.png";
  ASSERT_TRUE(fs::exists(captured)) << state()["message"];
  EXPECT_TRUE(fs::exists(folder_ / "hall-001.json"));
  EXPECT_NE(command.find("volumetrics.steps=9"), std::string::npos) << command;
  auto picture = image::readPng(captured);
  ASSERT_TRUE(picture) << picture.error().message;
  // Below the bar in the viewport's corner.
  const Area below{0, 40, picture->width, picture->height};
  ASSERT_EQ(picture->width, normals.width);
  ASSERT_EQ(picture->height, normals.height);
  EXPECT_LT(changedShare(part(*picture, below), part(normals, below)), kNothing);
  auto numbers = image::readExr(folder_ / "hall-001-view.exr");
  ASSERT_TRUE(numbers) << numbers.error().message;
  ASSERT_EQ(numbers->width, picture->width);
  ASSERT_EQ(numbers->channels, 3u);
  std::size_t unit = 0;
  for (std::size_t i = 0; i < numbers->values.size(); i += 3) {
    const float *n = &numbers->values[i], length = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    unit += std::abs(length - 1) < 1e-3f;
  }
  EXPECT_EQ(unit * 3, numbers->values.size());  // they are normals
  ASSERT_EQ(rerun(command, captured, again), 0);
  EXPECT_TRUE(pixelsOf(captured) == pixelsOf(again));
  quit();
}

TEST_F(ShowTest, F1ShowsEveryKeyAndTakesThemAway) {
  startTiny("640x420");
  const image::ByteImage before = look();
  keys({"F1"});
  ASSERT_TRUE(appears("keys"));
  const Area area = Area::of(state()["widgets"]["keys"].get<std::vector<double>>());
  EXPECT_GT(changedShare(part(before, area), part(look(), area)), 0.3);  // the panel behind it is of the same grey
  for (const char* key :
       {"Ctrl+O", "Ctrl+L", "Ctrl+S", "Ctrl+D", "Ctrl+P", "Ctrl+Z", "Ctrl+Shift+Z", "Ctrl+F", "Ctrl+Q", "F1"})
    EXPECT_NE(fact("keys").find(std::string(key) + ";"), std::string::npos) << key;
  keys({"F1"});
  ASSERT_FALSE(waitFor([](const Json& s) { return !s["widgets"].contains("keys"); }, 20).is_null());
  EXPECT_LT(changedShare(part(before, area), part(look(), area)), kNothing);
  quit();
}

// Names as the command line takes them. A preset for speed leaves the fog alone.
TEST_F(ShowTest, NamesOfPresetsAndLevelsCanBeTyped) {
  startTiny("640x420", {"--set", "medium.sigma_t=0.07"});
  choose("l", "fast");
  ASSERT_TRUE(becomes("volumetrics.columns", "256")) << state()["message"];
  EXPECT_EQ(setting("medium.sigma_t"), "0.07");
  choose("o", "terrain");
  ASSERT_FALSE(waitFor([](const Json& s) { return s["level"] == "terrain"; }, 60).is_null()) << state()["message"];
  EXPECT_EQ(setting("medium.sigma_t"), "0.07");
  quit();
}

TEST_F(ShowTest, RecentLevelsAreOpenedFromTheMenuAndRemembered) {
  const std::string other = (folder_ / "other.glb").string();
  startTiny("640x420");
  fs::copy_file(tiny(), other);
  choose("o", other);
  ASSERT_FALSE(waitFor([&](const Json& s) { return s["level"] == other; }, 20).is_null()) << state()["message"];
  click("menu File");
  ASSERT_TRUE(appears("Recent levels"));
  click("Recent levels");
  ASSERT_TRUE(appears("level " + tiny().string()));
  click("level " + tiny().string());
  ASSERT_FALSE(waitFor([&](const Json& s) { return s["level"] == tiny().string(); }, 20).is_null())
      << state()["message"];
  quit();
  std::ifstream kept(folder_ / "settings.json");
  EXPECT_EQ(Json::parse(kept, nullptr, false)["recent_levels"], Json({tiny().string(), other}));
}

}  // namespace
}  // namespace tyndall::editor_test
