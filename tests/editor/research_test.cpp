// The research panels: what they show is what the command line computes of the same view.
#include "research.hpp"

namespace tyndall::editor_test {
namespace {

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

  // The viewer's own numbers, from its button.
  click("view scatter exr");
  ASSERT_FALSE(
      waitFor([](const Json& s) { return s["message"].get<std::string>().starts_with("wrote "); }, 20).is_null());
  const std::string written = state()["message"].get<std::string>().substr(6);
  auto saved = image::readExr(written);
  std::filesystem::remove(written);
  ASSERT_TRUE(saved) << saved.error().message;
  EXPECT_EQ(saved->values, scatter.values);

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

  // The walk of the same pixel: as many blockers as a row of 64 columns can have, and a share of the weight.
  ASSERT_TRUE(linked["widgets"].contains("walk"));
  click("walk");
  moveTo(300, 42);
  const Json walked = waitFor([](const Json& s) { return !fact(s, "walk").empty(); });
  ASSERT_FALSE(walked.is_null()) << state().dump();
  const auto walk = numbers(fact(walked, "walk"));
  ASSERT_EQ(walk.size(), 7u);
  EXPECT_EQ(walk[0], std::floor(place[2] * 64));
  EXPECT_EQ(walk[1], std::floor(place[3] * 64));
  EXPECT_LE(walk[3], walk[1]);
  EXPECT_GE(walk[5], 0);
  EXPECT_LE(walk[5], 1.0001);
  quit();
}

TEST_F(ResearchTest, TheReferenceAgreesWithTheCommandLine) {
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
  quit();
}

}  // namespace
}  // namespace tyndall::editor_test
