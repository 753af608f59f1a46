// The pictures of docs/editor.md, taken from the screen (label sweep). They go to the folder that
// TYNDALL_EDITOR_PICTURES names, as the target editor_pictures does, else to the test's own.
#include <chrono>
#include <cstdlib>
#include <set>
#include <thread>

#include "session.hpp"

namespace tyndall::editor_test {
namespace {

namespace fs = std::filesystem;

class PicturesTest : public SessionTest {
 protected:
  void open(const char* level) {
    start(level, "1280x720",
          {"--set", "volumetrics.technique=exact", "--set", "volumetrics.columns=512", "--set",
           "volumetrics.slices=512", "--set", "volumetrics.row_order=column", "--set", "shadows.resolution=2048"});
  }
  /// What is on the screen now, the mouse where it is.
  void keep(const char* name) {
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    const image::ByteImage window = part(readScreen(folder_ / "Xvfb_screen0"), {0, 0, 1280, 720});
    std::set<std::uint32_t> colours;
    for (std::size_t i = 0; i < window.values.size(); i += 3)
      colours.insert(std::uint32_t{window.values[i]} << 16 | std::uint32_t{window.values[i + 1]} << 8 |
                     window.values[i + 2]);
    EXPECT_GT(colours.size(), 1000u) << name;  // a picture with its panels, not an empty window
    const char* folder = std::getenv("TYNDALL_EDITOR_PICTURES");
    const auto written = image::writePng((folder ? fs::path(folder) : folder_) / name, window);
    EXPECT_TRUE(written) << written.error().message;
  }
};

TEST_F(PicturesTest, TheWindow) {
  open("hall");
  click("continuous");
  const int pictures = state()["pictures"];
  ASSERT_FALSE(waitFor([=](const Json& s) { return s["pictures"] >= pictures + 40; }, 200)
                   .is_null());  // fills the graph of times
  click("continuous");
  look();
  keep("editor.png");
  quit();
}

TEST_F(PicturesTest, TheLevelAndItsHandles) {
  open("vault");
  click("tab level");
  ASSERT_TRUE(appears("camera 0"));
  const Json listed = state();
  std::string spot;
  for (const auto& [name, place] : listed["widgets"].items())
    if (name.starts_with("light at ") && spot.empty()) spot = name;
  ASSERT_NE(spot, "");
  // The lights hang high: look up.
  input({"search", "--name", "Tyndall", "mousemove", "--window", "%1", "200", "450", "mousedown", "3"});
  waitFrames(3);
  move(200, 330);
  input({"mouseup", "3"});
  click(spot);
  ASSERT_TRUE(appears("aim") || appears("handle y"));
  look();
  keep("editor_level.png");
  quit();
}

TEST_F(PicturesTest, ARowAndItsWalk) {
  open("hall");
  click("rows");
  ASSERT_TRUE(appears("walk"));
  click("walk");
  move(760, 330);  // beside the windows
  ASSERT_FALSE(waitFor([](const Json& s) { return s["facts"].contains("walk"); }, 200).is_null()) << state()["facts"];
  keep("editor_walk.png");
  quit();
}

TEST_F(PicturesTest, MemoryByResource) {
  open("hall");
  pull("side edge", -180, 0);
  pull("figures edge", 0, -60);
  click("tab memory");
  ASSERT_TRUE(appears("memory filter"));
  look();
  keep("editor_memory.png");
  quit();
}

TEST_F(PicturesTest, ErrorsAndThePlot) {
  open("hall");
  click("reference");
  ASSERT_TRUE(appears("reference samples"));
  click("reference samples");
  ASSERT_TRUE(appears("reference samples 64"));
  click("reference samples 64");
  ASSERT_FALSE(waitFor([](const Json& s) { return s["facts"].value("reference samples", "") == "64"; }, 30).is_null());
  click("plot");
  ASSERT_TRUE(appears("plot measure"));
  // Away from the other window, by its title.
  const auto chart = state()["widgets"]["plot chart"].get<std::vector<double>>();
  move(chart[0] + 120, chart[1] - 36);
  input({"mousedown", "1"});
  waitFrames(2);
  move(chart[0] - 100, chart[1] + 20);
  move(140, 300);
  input({"mouseup", "1"});
  click("plot measure");
  ASSERT_TRUE(factBecomes("plot state", "measuring"));
  ASSERT_FALSE(waitFor([](const Json& s) { return s["facts"].value("plot state", "") == "idle"; }, 500).is_null());
  click("reference show error");
  look();
  keep("editor_truth.png");
  quit();
}

}  // namespace
}  // namespace tyndall::editor_test
