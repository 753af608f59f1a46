#include "memory_growth.hpp"

#include <random>

#include <gtest/gtest.h>

namespace tyndall::editor {
namespace {

/// A hundred readings that rise to a level in the first tenth, then go up and down, and grow by so much a reading.
std::vector<double> readings(double slope, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, 25);
  std::vector<double> all;
  for (int i = 0; i < 101; ++i) all.push_back(300 + std::min(i, 10) * 15 + slope * i + noise(random));
  return all;
}

TEST(MemoryGrowth, TheWarmUpAndChanceAreNoGrowth) {
  int most = 0, single = 0;
  for (std::uint32_t seed = 0; seed < 1000; ++seed) {
    const std::vector<double> steady = readings(0, seed);
    most += growthOf(steady).grown() > 64;
    single += steady.back() - steady[20] > 64;
  }
  EXPECT_EQ(most, 0);
  EXPECT_GT(single, 20);  // two readings, which would be wrong now and then
}

TEST(MemoryGrowth, AMebibyteAReadingIsFound) {
  int found = 0;
  for (std::uint32_t seed = 0; seed < 1000; ++seed) found += growthOf(readings(1.24, seed)).grown() > 64;
  EXPECT_GT(found, 900);
  const MemoryGrowth exact = growthOf({100, 200, 300, 400, 500, 600, 700, 800, 900, 1000});
  EXPECT_EQ(exact.before, 300);
  EXPECT_EQ(exact.after, 1000);
}

TEST(MemoryGrowth, ShortRunsCompareWhatTheyHave) {
  EXPECT_EQ(growthOf({5, 9}).grown(), 4);
  EXPECT_EQ(growthOf({1, 7, 9}).grown(), 2);
  EXPECT_EQ(growthOf({3}).grown(), 0);
}

}  // namespace
}  // namespace tyndall::editor
