#include <gtest/gtest.h>

#include "report/markup.hpp"
#include "report/text.hpp"

namespace tyndall::bench::report {
namespace {

TEST(Figure, HasThreeDigitsAndSaysNoMore) {
  EXPECT_EQ(figure(0), "0");
  EXPECT_EQ(figure(0.018649), "0.0186");
  EXPECT_EQ(figure(0.0185), "0.0185");
  EXPECT_EQ(figure(1), "1.00");
  EXPECT_EQ(figure(9.996), "10.0");
  EXPECT_EQ(figure(99.96), "100");
  EXPECT_EQ(figure(204.6), "205");
  EXPECT_EQ(figure(1234.4), "1,234");
  EXPECT_EQ(figure(-0.5), "−0.500");
  EXPECT_EQ(figure(1.239e-7), "1.24e−7");
  EXPECT_EQ(figure(3.2e9), "3.20e9");
  EXPECT_EQ(figure(0.2, 1), "0.2");
}

TEST(Figure, WholeNumbersKeepAllDigits) {
  EXPECT_EQ(whole(1048576), "1,048,576");
  EXPECT_EQ(whole(999), "999");
  EXPECT_EQ(whole(-1000), "−1,000");
  EXPECT_EQ(bytes(24.1e6), "24.1 MB");
  EXPECT_EQ(percent(0.1234), "12.3 %");
}

TEST(Lists, ReadAsASentence) {
  EXPECT_EQ(list({}), "");
  EXPECT_EQ(list({"a"}), "a");
  EXPECT_EQ(list({"a", "b", "c"}), "a, b and c");
  EXPECT_EQ(plural(1, "point"), "point");
  EXPECT_EQ(plural(0, "point"), "points");
  EXPECT_EQ(shortId("volumetrics.columns"), "columns");
  EXPECT_EQ(shortId("plain"), "plain");
}

TEST(Markup, CoordinatesAreShort) {
  EXPECT_EQ(coordinate(12), "12");
  EXPECT_EQ(coordinate(12.345), "12.35");
  EXPECT_EQ(coordinate(-0.001), "0");
  EXPECT_EQ(coordinate(1.5), "1.5");
}

TEST(MarkupDeathTest, AnElementLeftOpenIsOurBug) {
  Markup m;
  m.open("p");
  EXPECT_DEATH(m.take(), "<p> is still open");
}

}  // namespace
}  // namespace tyndall::bench::report
