// Error metrics against figures worked out by hand.
#include "image/metrics.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

using namespace tyndall::image;

namespace {

FloatImage filled(std::uint32_t width, std::uint32_t height, std::uint32_t channels, float value) {
  return {width, height, channels, std::vector<float>(std::size_t{width} * height * channels, value)};
}

}  // namespace

TEST(Metrics, areZeroForEqualPictures) {
  const auto metrics = compare(filled(8, 4, 4, 2), filled(8, 4, 4, 2));
  ASSERT_TRUE(metrics);
  EXPECT_EQ(metrics->nRmse, 0);
  EXPECT_EQ(metrics->p99, 0);
  EXPECT_EQ(metrics->max, 0);
  EXPECT_EQ(metrics->bias, 0);
  EXPECT_EQ(metrics->referenceMean, 2);
}

TEST(Metrics, ofAConstantOffset) {
  const auto metrics = compare(filled(8, 4, 3, 3), filled(8, 4, 4, 4));
  ASSERT_TRUE(metrics);
  EXPECT_DOUBLE_EQ(metrics->nRmse, 0.25);
  EXPECT_DOUBLE_EQ(metrics->p99, 0.25);
  EXPECT_DOUBLE_EQ(metrics->max, 0.25);
  EXPECT_DOUBLE_EQ(metrics->bias, -0.25);
}

// 300 values; three of them are wrong by 8, 9 and 10 means, so the 297th greatest is the first that is right.
TEST(Metrics, percentileLeavesOutOneInAHundred) {
  const FloatImage reference = filled(10, 10, 3, 1);
  FloatImage image = reference;
  image.values[17] = 9, image.values[150] = -8, image.values[299] = 11;
  const auto metrics = compare(image, reference);
  ASSERT_TRUE(metrics);
  EXPECT_EQ(metrics->p99, 0);
  EXPECT_DOUBLE_EQ(metrics->max, 10);
  EXPECT_DOUBLE_EQ(metrics->nRmse, std::sqrt((64.0 + 81.0 + 100.0) / 300.0));
  EXPECT_DOUBLE_EQ(metrics->bias, 9.0 / 300.0);
  image.values[3] = 8;
  EXPECT_DOUBLE_EQ(compare(image, reference)->p99, 7);
}

TEST(Metrics, alphaDoesNotCount) {
  FloatImage image = filled(4, 4, 4, 1);
  for (std::uint32_t i = 0; i < 4; ++i) image.at(i, i, 3) = 77;
  EXPECT_EQ(compare(image, filled(4, 4, 4, 1))->nRmse, 0);
  image.at(1, 2, 2) = 2;
  EXPECT_GT(compare(image, filled(4, 4, 4, 1))->nRmse, 0);
}

TEST(Metrics, refuseWhatCannotBeCompared) {
  EXPECT_FALSE(compare(filled(4, 4, 4, 1), filled(4, 5, 4, 1)));
  EXPECT_FALSE(compare(filled(4, 4, 1, 1), filled(4, 4, 3, 1)));
  EXPECT_FALSE(compare(filled(4, 4, 3, 1), filled(4, 4, 3, 0)));
  FloatImage image = filled(4, 4, 3, 1);
  image.at(2, 3, 1) = std::numeric_limits<float>::quiet_NaN();
  const auto metrics = compare(image, filled(4, 4, 3, 1));
  ASSERT_FALSE(metrics);
  EXPECT_NE(metrics.error().message.find("(2, 3)"), std::string::npos);
}
