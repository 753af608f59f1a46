// Axes hold what they are for; the front is what nothing beats.
#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "plot_axes.hpp"

namespace tyndall::editor {
namespace {

TEST(LogAxis, SharesAndValuesAreInverse) {
  const LogAxis axis{0.003, 7};
  for (const double value : {0.003, 0.01, 1.0, 7.0}) EXPECT_NEAR(axis.valueAt(axis.share(value)), value, 1e-12 * value);
  EXPECT_DOUBLE_EQ(axis.share(0.003), 0);
  EXPECT_DOUBLE_EQ(axis.share(7), 1);
}

TEST(LogAxis, TicksRiseWithinTheAxisAndPowersOfTenAreMajor) {
  const LogAxis axis{0.02, 300};
  const auto ticks = axis.ticks();
  std::size_t major = 0;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    EXPECT_GE(ticks[i].value, 0.02 * (1 - 1e-9));
    EXPECT_LE(ticks[i].value, 300 * (1 + 1e-9));
    if (i > 0) {
      EXPECT_GT(ticks[i].value, ticks[i - 1].value);
    }
    major += ticks[i].major;
  }
  EXPECT_EQ(major, 4u);  // 0.1, 1, 10, 100
  EXPECT_NEAR(ticks.front().value, 0.02, 1e-12);
  EXPECT_NEAR(ticks.back().value, 300, 1e-9);
  EXPECT_EQ(tickText(0.1), "0.1");
  EXPECT_EQ(tickText(200), "200");
  EXPECT_EQ(tickText(2000), "2000");
  EXPECT_EQ(tickText(0.0005), "0.0005");
}

TEST(LogAxis, HoldsItsValuesWithRoomAndIsNeverNarrow) {
  const LogAxis wide = axisFor({0.5, 40, 3});
  EXPECT_LT(wide.low, 0.5);
  EXPECT_GT(wide.high, 40);
  const LogAxis one = axisFor({2});
  EXPECT_NEAR(one.high / one.low, 4, 1e-9);
  EXPECT_NEAR(one.share(2), 0.5, 1e-9);
  const LogAxis none = axisFor({0, -1});
  EXPECT_LT(none.low, none.high);
}

TEST(Front, IsWhatNoOtherPointBeatsInBoth) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> value(0.01, 1);
  for (int round = 0; round < 200; ++round) {
    std::vector<PlotPoint> points(12);
    for (PlotPoint& point : points) point = {value(random), value(random)};
    const auto front = paretoFront(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool beaten = std::any_of(points.begin(), points.end(), [&](const PlotPoint& other) {
        return other.milliseconds < points[i].milliseconds && other.error < points[i].error;
      });
      EXPECT_EQ(std::count(front.begin(), front.end(), i), beaten ? 0 : 1);
    }
    for (std::size_t k = 1; k < front.size(); ++k) EXPECT_LT(points[front[k]].error, points[front[k - 1]].error);
  }
}

}  // namespace
}  // namespace tyndall::editor
