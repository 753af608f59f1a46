// A changed setting does not hold up the frames: some that need new pipelines, with caches that know none of them.
#include <algorithm>
#include <cstdio>

#include <gtest/gtest.h>

#include "hitch.hpp"

namespace tyndall::hitch {
namespace {

struct Case {
  Settings start;
  std::string id, value;  ///< a change that needs pipelines which were never made
};

const Case kCases[] = {
    {{"volumetrics.technique=ray_march"}, "volumetrics.technique", "moments6"},
    {{"volumetrics.technique=fourier", "volumetrics.basis_count=16"}, "volumetrics.basis_count", "32"},
    {{"volumetrics.technique=moments4"}, "volumetrics.reference_rays", "1"},
    {{"volumetrics.technique=moments4"}, "shadows.mode", "moments"},
    {{"volumetrics.technique=moments4", "shadows.mode=moments"}, "shadows.precision", "128"},
};

void print(const Change& c) {
  std::printf(
      "%-45s before %5.0f ms, after %5.0f, worst %5.0f: ratio %.2f (%s); processor %.0f, %.0f, %.0f: %.2f; %d frames "
      "in between, %.2f s, %d late\n",
      c.what.c_str(), c.before, c.after, c.worst, c.ratio(), c.slowestPass.c_str(), c.cpuBefore, c.cpuAfter, c.cpuWorst,
      c.cpuRatio(), c.frames, c.seconds, c.late);
}

TEST(Hitch, ChangedSettingsDoNotHoldUpFrames) {
  Bench bench("hall", 160, 90, true);
  for (const Case& test : kCases) {
    bench.settle(test.start);
    const Change change = bench.change(test.id, test.value);
    print(change);
    EXPECT_GT(change.frames, 0) << change.what << ": nothing was built beside the frames";
    EXPECT_EQ(change.late, 0) << change.what << ": code that was not compiled ahead";
    // The promise is about the clock. Where a machine made a frame wait for a processor, which is not ours, the time of
    // the processors tells; that alone would count what the driver's threads spend on the new images, whether a frame
    // waits for it or not.
    EXPECT_LE(std::min(change.ratio(), change.cpuRatio()), 2.0) << change.what;
  }
}

// Settings of the engine's own frame are followed once their pipelines are there, and then show what they show without
// all that.
TEST(Hitch, TheEnginesSettingsAreFollowedInTime) {
  const Settings start = {"volumetrics.enabled=false"};
  const auto pictureOf = [&](const Settings& more) {
    Bench atOnce("hall", 96, 54, false);
    Settings all = start;
    all.insert(all.end(), more.begin(), more.end());
    atOnce.settle(all);
    return atOnce.shoot().values;
  };
  const auto before = pictureOf({}), moments = pictureOf({"shadows.mode=moments"});
  ASSERT_NE(before, moments);
  Bench bench("hall", 96, 54, true);
  bench.settle(start);
  ASSERT_EQ(bench.shoot().values, before);
  params::Table& table = bench.session().table();
  ASSERT_TRUE(table.setText("shadows.mode", "moments"));
  EXPECT_EQ(bench.shoot().values, before) << "the settings before go on";
  EXPECT_NE(bench.session().background(), app::Session::Background::kIdle);
  // Taken back, nothing is waited for.
  ASSERT_TRUE(table.setText("shadows.mode", "pcf"));
  EXPECT_EQ(bench.shoot().values, before);
  EXPECT_EQ(bench.session().background(), app::Session::Background::kIdle);
  ASSERT_TRUE(table.setText("shadows.mode", "moments"));
  int frames = 0;
  auto last = before;
  while (last == before && ++frames < 2000) last = bench.shoot().values;
  EXPECT_EQ(last, moments);
  EXPECT_EQ(bench.session().background(), app::Session::Background::kIdle);
}

}  // namespace
}  // namespace tyndall::hitch
