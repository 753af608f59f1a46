// The plot of error against time: every technique is a point, and the one in use has the error that the command line
// finds.
#include "research.hpp"

namespace tyndall::editor_test {
namespace {

class PlotTest : public ResearchTest {};

TEST_F(PlotTest, EveryTechniqueIsMeasured) {
  click("reference");
  ASSERT_FALSE(waitFor([](const Json& s) { return s["widgets"].contains("reference samples"); }, 30).is_null());
  click("reference samples");
  ASSERT_FALSE(waitFor([](const Json& s) { return s["widgets"].contains("reference samples 64"); }, 30).is_null());
  click("reference samples 64");
  ASSERT_FALSE(waitForFact("reference samples", "64", 30).is_null());
  commandLine("truth", {"--samples", "64", "--out", (folder_ / "truth.exr").string()});
  commandLine("render", {"--scatter", (folder_ / "scatter.exr").string()});
  const auto computed = image::compare(exr("scatter.exr"), exr("truth.exr"));
  ASSERT_TRUE(computed) << computed.error().message;
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
