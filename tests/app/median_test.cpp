#include <gtest/gtest.h>

#include "app/median.hpp"

namespace tyndall::app {
namespace {

std::vector<render::PassTime> frame(double a, double b) { return {{"a", "engine", a}, {"b", "engine", b}}; }

TEST(Median, OfAnOddNumberIsTheOneInTheMiddle) {
  // The median of each pass on its own would be 2 and 5, which add up to no frame that was ever measured.
  const std::vector<std::vector<render::PassTime>> frames = {frame(1, 9), frame(2, 4), frame(3, 5)};
  EXPECT_EQ(totalMs(medianFrame(frames)), 8);
  EXPECT_EQ(medianFrame(frames)[0].milliseconds, 3);
}

TEST(Median, OfAnEvenNumberIsTheLowerOfTheTwo) {
  EXPECT_EQ(totalMs(medianFrame({frame(4, 0), frame(1, 0), frame(2, 0), frame(3, 0)})), 2);
}
TEST(Median, OfOneIsItself) { EXPECT_EQ(totalMs(medianFrame({frame(4, 1)})), 5); }

}  // namespace
}  // namespace tyndall::app
