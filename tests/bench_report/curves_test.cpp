// The Pareto front against its definition, and interpolation against closed forms.
#include <cmath>
#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/curves.hpp"

namespace tyndall::bench {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsEmpty;

/// cost = scale · error^exponent at these errors.
std::vector<CostError> powerLaw(double scale, double exponent, std::initializer_list<double> errors) {
  std::vector<CostError> points;
  for (const double e : errors) points.push_back({scale * std::pow(e, exponent), e});
  return points;
}

TEST(ParetoFront, IsWhatTheDefinitionSaysOnRandomPoints) {
  std::mt19937 random(1);
  for (int round = 0; round < 2000; ++round) {
    // Small whole numbers, so that ties in one or both are common.
    std::uniform_int_distribution<int> count(0, 40), coordinate(0, 1 + round % 30);
    std::vector<CostError> points(static_cast<std::size_t>(count(random)));
    for (CostError& p : points) p = {1.0 * coordinate(random), 1.0 * coordinate(random)};
    std::vector<bool> expected(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      bool beaten = false;
      for (std::size_t j = 0; j < points.size(); ++j) {
        const bool noWorse = points[j].cost <= points[i].cost && points[j].error <= points[i].error;
        const bool better = points[j].cost < points[i].cost || points[j].error < points[i].error;
        beaten = beaten || (noWorse && (better || j < i));  // of equal points the first counts
      }
      expected[i] = !beaten;
    }
    const auto front = paretoFront(points);
    std::vector<bool> found(points.size());
    for (const std::size_t i : front) found[i] = true;
    ASSERT_EQ(found, expected) << "round " << round;
    for (std::size_t i = 1; i < front.size(); ++i) {
      ASSERT_LT(points[front[i - 1]].cost, points[front[i]].cost);
      ASSERT_GT(points[front[i - 1]].error, points[front[i]].error);
    }
  }
}

TEST(ParetoFront, LeavesOutWhatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  const std::vector<CostError> points = {{nan, 0}, {0, nan}, {infinite, 0}, {5, 5}, {-infinite, 9}};
  EXPECT_THAT(paretoFront(points), ElementsAre(3u));
  EXPECT_THAT(paretoFront({}), IsEmpty());
}

TEST(Interpolation, IsExactOnAPowerLaw) {
  const auto curve = powerLaw(0.7, -1.5, {0.5, 0.3, 0.04, 0.001});
  for (double e = 0.001; e <= 0.5; e *= 1.07) {
    const auto cost = costAtError(curve, e);
    ASSERT_TRUE(cost) << e;
    EXPECT_NEAR(*cost / (0.7 * std::pow(e, -1.5)), 1, 1e-12) << e;
    const auto back = errorAtCost(curve, *cost);
    ASSERT_TRUE(back) << e;
    EXPECT_NEAR(*back / e, 1, 1e-10);
  }
}

TEST(Interpolation, NeverExtrapolates) {
  const auto curve = powerLaw(1, -1, {0.5, 0.1});
  EXPECT_FALSE(costAtError(curve, 0.5000001));
  EXPECT_FALSE(costAtError(curve, 0.0999999));
  EXPECT_FALSE(errorAtCost(curve, 1.9999999));
  EXPECT_FALSE(errorAtCost(curve, 10.000001));
  EXPECT_DOUBLE_EQ(*costAtError(curve, 0.5), 2);
  EXPECT_DOUBLE_EQ(*costAtError(curve, 0.1), 10);
  EXPECT_DOUBLE_EQ(*errorAtCost(curve, 10), 0.1);
  EXPECT_FALSE(costAtError({}, 0.1));
}

TEST(Interpolation, GoesAlongTheFrontOnly) {
  // (50, 0.3) is beaten by (10, 0.2): at 0.3 the way is from (5, 0.4) to (10, 0.2).
  const std::vector<CostError> points = {{5, 0.4}, {50, 0.3}, {10, 0.2}, {0, 0.1}, {7, 0}};
  const double t = std::log(0.3 / 0.4) / std::log(0.2 / 0.4);
  EXPECT_NEAR(*costAtError(points, 0.3), 5 * std::pow(2, t), 1e-12);
  EXPECT_FALSE(costAtError(points, 0.1)) << "a cost of 0 has no logarithm";
}

TEST(Comparison, FindsWhereTwoPowerLawsCross) {
  // 1/e and 0.02/e² cross at e = 0.02: below it the second is dearer.
  const auto first = powerLaw(1, -1, {0.5, 0.05, 0.004}), second = powerLaw(0.02, -2, {0.3, 0.01, 0.001});
  const auto stretches = compareAtEqualError(first, second);
  ASSERT_EQ(stretches.size(), 2u);
  EXPECT_EQ(stretches[0].cheaper, Stretch::Cheaper::kFirst);
  EXPECT_NEAR(stretches[0].from, 0.004, 1e-12);
  EXPECT_NEAR(stretches[0].to, 0.02, 1e-9);
  EXPECT_NEAR(stretches[0].greatestRatio, 0.02 / 0.004, 1e-9);
  EXPECT_NEAR(stretches[0].leastRatio, 1, 1e-9);
  EXPECT_EQ(stretches[1].cheaper, Stretch::Cheaper::kSecond);
  EXPECT_NEAR(stretches[1].to, 0.3, 1e-12);
  EXPECT_NEAR(stretches[1].leastRatio, 0.02 / 0.3, 1e-9);
}

TEST(Comparison, NoiseMakesAStretchOfEqualCosts) {
  const auto first = powerLaw(1, -1, {0.5, 0.001}), second = powerLaw(0.02, -2, {0.5, 0.001});
  const auto stretches = compareAtEqualError(first, second, 1.25);
  ASSERT_EQ(stretches.size(), 3u);
  EXPECT_EQ(stretches[1].cheaper, Stretch::Cheaper::kEqual);
  EXPECT_NEAR(stretches[1].from, 0.02 / 1.25, 1e-9);  // second / first = 0.02 / e
  EXPECT_NEAR(stretches[1].to, 0.02 * 1.25, 1e-9);
  EXPECT_NEAR(stretches[1].greatestRatio, 1.25, 1e-9);
}

TEST(Comparison, OfCurvesWithoutACommonErrorIsEmpty) {
  EXPECT_TRUE(compareAtEqualError(powerLaw(1, -1, {0.5, 0.2}), powerLaw(1, -1, {0.1, 0.05})).empty());
  EXPECT_TRUE(compareAtEqualError({}, powerLaw(1, -1, {0.1, 0.05})).empty());
  const auto one = compareAtEqualError(powerLaw(1, -1, {0.5, 0.2}), powerLaw(3, -1, {0.2, 0.05}));
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].from, one[0].to);
  EXPECT_NEAR(one[0].leastRatio, 3, 1e-12);
}

TEST(Comparison, CoversTheCommonErrorsWithoutGapsOnRandomCurves) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> log10(-3, 0);
  for (int round = 0; round < 500; ++round) {
    std::vector<CostError> a, b;
    for (int i = 0; i < 8; ++i) {
      a.push_back({std::pow(10, log10(random)), std::pow(10, log10(random))});
      b.push_back({std::pow(10, log10(random)), std::pow(10, log10(random))});
    }
    const auto stretches = compareAtEqualError(a, b, 1.1);
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      const Stretch& s = stretches[i];
      if (i > 0) {
        ASSERT_DOUBLE_EQ(s.from, stretches[i - 1].to);
        ASSERT_NE(s.cheaper, stretches[i - 1].cheaper);
      }
      // Anywhere within, the interpolated costs agree with what is said.
      for (const double t : {0.1, 0.5, 0.9}) {
        const double e = s.from * std::pow(s.to / s.from, t), ratio = *costAtError(b, e) / *costAtError(a, e);
        ASSERT_GE(ratio, s.leastRatio * (1 - 1e-9));
        ASSERT_LE(ratio, s.greatestRatio * (1 + 1e-9));
        if (s.cheaper == Stretch::Cheaper::kFirst) {
          ASSERT_GT(ratio, 1.1 * (1 - 1e-9));
        }
        if (s.cheaper == Stretch::Cheaper::kSecond) {
          ASSERT_LT(ratio, (1 + 1e-9) / 1.1);
        }
      }
    }
  }
}

}  // namespace
}  // namespace tyndall::bench
