// A changed setting does not hold up the frames: three that need new pipelines, with caches that know none of them.
#include <cstdio>

#include <gtest/gtest.h>

#include "hitch.hpp"

namespace tyndall::hitch {
namespace {

/// Each step is one change whose pipelines were never made before. Of three, the median: the machine has other things
/// to do.
void expectNoHitch(const Settings& start, const std::string& id, const std::vector<std::string>& values) {
  Bench bench("hall", 320, 180, true);
  bench.settle(start);
  std::vector<double> ratios;
  for (const std::string& value : values) {
    const Change change = bench.change(id, value);
    std::printf("%-50s before %6.1f ms, after %6.1f, worst %6.1f, ratio %.2f (%s), %d frames in between, %.2f s\n",
                change.what.c_str(), change.before, change.after, change.worst, change.ratio(), change.slowestPass.c_str(), change.frames,
                change.seconds);
    EXPECT_GT(change.frames, 0) << change.what << ": nothing was built beside the frames";
    ratios.push_back(change.ratio());
  }
  EXPECT_LE(median(ratios), 2.0);
}

TEST(Hitch, TechniqueChanges) {
  expectNoHitch({"volumetrics.technique=ray_march"}, "volumetrics.technique", {"moments6", "fourier", "exact"});
}
TEST(Hitch, BasisCountChanges) {
  expectNoHitch({"volumetrics.technique=fourier", "volumetrics.basis_count=8"}, "volumetrics.basis_count",
                {"16", "32", "64"});
}
TEST(Hitch, PrecisionChanges) {
  expectNoHitch({"volumetrics.technique=moments4", "volumetrics.precision=compact"}, "volumetrics.precision",
                {"standard", "full", "compact"});
}

}  // namespace
}  // namespace tyndall::hitch
