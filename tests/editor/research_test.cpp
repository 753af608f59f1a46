// The research panels: what they show is what the command line computes of the same view.
#include <cmath>
#include <cstdio>
#include <sstream>

#include "display.hpp"
#include "image/image_io.hpp"
#include "image/metrics.hpp"

namespace tyndall::editor_test {
namespace {

using Json = nlohmann::json;

const std::vector<std::string> kSettings = {"--set", "volumetrics.columns=64", "--set", "volumetrics.slices=64",
                                            "--set", "shadows.resolution=256"};

std::vector<double> numbers(const std::string& text) {
  std::istringstream stream(text);
  std::vector<double> list;
  for (double value; stream >> value;) list.push_back(value);
  return list;
}

std::string fact(const Json& state, const std::string& name) {
  return state.contains("facts") && state["facts"].contains(name) ? state["facts"][name].get<std::string>() : "";
}

class ResearchTest : public EditorTest {
 protected:
  void SetUp() override {
    EditorTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    ASSERT_TRUE(haveProgram("xdotool"));
    std::vector<std::string> arguments = {"hall", "--size", "600x240"};
    arguments.insert(arguments.end(), kSettings.begin(), kSettings.end());
    startEditor(arguments);
    const Json started = waitFor([](const Json& s) { return s["frames"] >= 4; });
    ASSERT_FALSE(started.is_null()) << errors();
    focus();
    viewport_ = started["widgets"]["viewport"].get<std::vector<double>>();
    size_ = std::to_string(static_cast<int>(viewport_[2])) + "x" + std::to_string(static_cast<int>(viewport_[3]));
  }
  void quit() {
    input({"keydown", "ctrl", "keydown", "q", "sleep", "1", "keyup", "q", "keyup", "ctrl"});
    EXPECT_EQ(waitEditor(60), 0) << errors();
  }
  /// The program `tyndall` on the view that the window shows.
  void commandLine(const std::string& command, const std::vector<std::string>& options) {
    std::vector<std::string> words = {std::string(TYNDALL_BIN_DIR) + "/tyndall", command, "hall", "--size", size_};
    words.insert(words.end(), kSettings.begin(), kSettings.end());
    words.insert(words.end(), options.begin(), options.end());
    Process program;
    program.start(words, "", folder_ / "tyndall.err");
    ASSERT_EQ(program.wait(120), 0);
  }
  image::FloatImage exr(const std::string& name) const {
    auto picture = image::readExr(folder_ / name);
    EXPECT_TRUE(picture) << picture.error().message;
    return picture ? picture.take() : image::FloatImage{};
  }
  void moveTo(double x, double y) {
    input({"search", "--name", "Tyndall", "mousemove", "--window", "%1", std::to_string(static_cast<int>(x)),
           std::to_string(static_cast<int>(y))});
    const int now = state()["frames"];
    waitFor([=](const Json& s) { return s["frames"] >= now + 3; }, 30);
  }
  Json waitForFact(const std::string& name, const std::string& value, double seconds = 90) {
    return waitFor([&](const Json& s) { return fact(s, name) == value; }, seconds);
  }

  std::vector<double> viewport_;
  std::string size_;
};

TEST_F(ResearchTest, AViewerReadsOutTheNumbersAndZoomsAboutTheCursor) {
  click("views");
  ASSERT_FALSE(waitFor([](const Json& s) { return s["widgets"].contains("open view scatter"); }, 30).is_null());
  click("open view scatter");
  ASSERT_FALSE(waitFor([](const Json& s) { return fact(s, "view scatter").ends_with("current"); }).is_null())
      << state().dump();
  const auto canvas = state()["widgets"]["view scatter canvas"].get<std::vector<double>>();
  moveTo(canvas[0] + canvas[2] * 0.55, canvas[1] + canvas[3] * 0.4);
  const Json before = state();
  const auto read = numbers(fact(before, "view scatter value"));
  ASSERT_EQ(read.size(), 6u) << before.dump();
  for (int notch = 0; notch < 4; ++notch) {
    const int frame = state()["frames"];
    input({"click", "4"});
    waitFor([=](const Json& s) { return s["frames"] >= frame + 2; }, 30);
  }
  const Json zoomed = state();
  EXPECT_NEAR(std::stod(fact(zoomed, "view scatter scale")) / std::stod(fact(before, "view scatter scale")),
              std::pow(1.25, 4), 1e-3);
  EXPECT_EQ(fact(zoomed, "view scatter value"),
            fact(before, "view scatter value"));  // the texel under the cursor stays
  commandLine("render", {"--scatter", (folder_ / "scatter.exr").string(), "--out", (folder_ / "slice.png").string(),
                         "--debug-view", "slice"});
  const image::FloatImage scatter = exr("scatter.exr");
  for (std::uint32_t c = 0; c < 4; ++c)
    EXPECT_FLOAT_EQ(static_cast<float>(read[2 + c]),
                    scatter.at(static_cast<std::uint32_t>(read[0]), static_cast<std::uint32_t>(read[1]), c))
        << c;

  // The same pixel of the picture lies in the slice that the command line's debug view shows.
  click("rows");
  moveTo(300, 42);  // between the bar and the windows
  const Json linked = waitFor([](const Json& s) { return !fact(s, "link").empty(); });
  ASSERT_FALSE(linked.is_null()) << state().dump();
  const auto place = numbers(fact(linked, "link"));
  ASSERT_EQ(place.size(), 6u);
  EXPECT_NEAR(place[0], 300, 1);
  EXPECT_NEAR(place[1], 42 - linked["widgets"]["viewport"][1].get<double>(), 1);  // below the menu
  auto slices = image::readPng(folder_ / "slice.png");
  ASSERT_TRUE(slices) << slices.error().message;
  const auto pixel = static_cast<std::size_t>(place[1]) * slices->width + static_cast<std::size_t>(place[0]);
  EXPECT_NEAR(place[2] * 255, slices->values[pixel * slices->channels], 1);
  quit();
}

TEST_F(ResearchTest, ReferenceAndPlotAgreeWithTheCommandLine) {
  click("reference");
  ASSERT_FALSE(waitFor([](const Json& s) { return s["widgets"].contains("reference start"); }, 30).is_null());

  // Many samples, to be cancelled in the middle.
  click("reference samples");
  ASSERT_FALSE(waitFor([](const Json& s) { return s["widgets"].contains("reference samples 4096"); }, 30).is_null());
  click("reference samples 4096");
  ASSERT_FALSE(waitForFact("reference samples", "4096", 30).is_null());
  click("reference start");
  ASSERT_FALSE(waitFor([](const Json& s) { return s["widgets"].contains("reference cancel"); }, 30).is_null());
  click("reference cancel");
  ASSERT_FALSE(
      waitFor([](const Json& s) { return fact(s, "reference") == "idle" && fact(s, "background") == "idle"; }, 30)
          .is_null())
      << state().dump();
  EXPECT_NE(fact(state(), "reference made"), "full");

  click("reference samples");
  ASSERT_FALSE(waitFor([](const Json& s) { return s["widgets"].contains("reference samples 64"); }, 30).is_null());
  click("reference samples 64");
  ASSERT_FALSE(waitForFact("reference samples", "64", 30).is_null());
  click("reference start");
  ASSERT_FALSE(waitFor([](const Json& s) { return !fact(s, "error").empty(); }).is_null()) << state().dump();
  if (state()["widgets"].contains("reference cancel")) click("reference cancel");
  ASSERT_FALSE(waitFor([](const Json& s) { return s["widgets"].contains("reference start"); }, 30).is_null());
  click("reference start");  // anew, while the figures of the last stand
  const Json done = waitFor([&](const Json& s) {
    const auto error = numbers(fact(s, "error"));
    return fact(s, "reference made") == "full" && fact(s, "background") == "idle" && !error.empty() &&
           error[0] == std::floor(viewport_[2]);
  });
  ASSERT_FALSE(done.is_null()) << state().dump();
  const auto shown = numbers(fact(done, "error"));
  ASSERT_EQ(shown.size(), 6u);
  commandLine("truth", {"--samples", "64", "--out", (folder_ / "truth.exr").string()});
  commandLine("render", {"--scatter", (folder_ / "scatter.exr").string()});
  const auto computed = image::compare(exr("scatter.exr"), exr("truth.exr"));
  ASSERT_TRUE(computed) << computed.error().message;
  EXPECT_NEAR(shown[2], computed->nRmse, 1e-6);
  EXPECT_NEAR(shown[3], computed->p99, 1e-6);
  EXPECT_NEAR(shown[4], computed->max, 1e-5);

  click("plot");
  ASSERT_FALSE(waitFor([](const Json& s) { return s["widgets"].contains("plot measure"); }, 30).is_null());
  click("plot measure");
  ASSERT_FALSE(waitForFact("plot state", "measuring", 30).is_null());
  const Json plotted = waitForFact("plot state", "idle", 200);
  ASSERT_FALSE(plotted.is_null()) << state().dump();
  std::istringstream entries(fact(plotted, "plot"));
  std::size_t count = 0;
  double own = 0;
  for (std::string entry; std::getline(entries, entry, ';'); ++count) {
    std::istringstream words(entry);
    std::string name;
    double milliseconds = 0, error = 0;
    words >> name >> milliseconds >> error;
    EXPECT_GT(milliseconds, 0) << entry;
    EXPECT_GT(error, 0) << entry;
    if (name == plotted["settings"]["volumetrics.technique"]) own = error;
  }
  EXPECT_GE(count, 6u) << fact(plotted, "plot");
  EXPECT_NEAR(own, computed->nRmse, 1e-6);  // the technique in use, with its settings
  quit();
}

}  // namespace
}  // namespace tyndall::editor_test
