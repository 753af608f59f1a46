// Columns that grow away from the eye (lib/epipolar.glsl): the change of variables, the spacing by transmittance, and the weights that columns
// get by products, against closed forms.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "lib/cpp.hpp"

namespace {

using namespace tyndall::lib;

TEST(ColumnSpacing, ReachAndItsInverseCancelAndGrow) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 100'000; ++i) {
    const double nearest = 0.01 + 0.99 * uniform(random), at = uniform(random);
    EXPECT_NEAR(f64::columnsWithin(nearest, f64::columnsReach(nearest, at)), at, 1e-12);
    EXPECT_NEAR(f32::columnsWithin(float(nearest), f32::columnsReach(float(nearest), float(at))), at, 2e-6);
    const double step = 1e-6;
    const double width = (f64::columnsReach(nearest, at + step) - f64::columnsReach(nearest, at)) / step;
    EXPECT_NEAR(width, nearest + 2 * (1 - nearest) * at, 1e-5);
  }
  EXPECT_DOUBLE_EQ(f64::columnsReach(0.3, 1), 1);
  EXPECT_DOUBLE_EQ(f64::columnsWithin(1, 0.37), 0.37);
}

TEST(ColumnSpacing, TheFirstColumnPassesItsPartOfTheTransmittance) {
  // Along a row of optical depth x the first of N columns of equal transmittance spans -log(1 - (1 - exp(-x))/N)/x of it.
  for (const double x : {1e-6, 0.01, 0.5, 1.5, 4.0, 9.0}) {
    constexpr double kCount = 1e6;
    EXPECT_NEAR(f64::nearestForTransmittance(x), kCount * -std::log1p(std::expm1(-x) / kCount) / x, 1e-5) << x;
  }
  EXPECT_EQ(f64::nearestForTransmittance(1e6), f64::kLeastNearest);
  EXPECT_EQ(f64::nearestForTransmittance(0.0), 1.0);
}

TEST(ColumnSpacing, FullnessMakesTheMiddleTheIntegral) {
  for (double x = 1e-4; x <= 3; x *= 1.5) EXPECT_NEAR(f64::columnFullness(x) / (std::sinh(x / 2) / (x / 2)), 1, 1e-4) << x;
  EXPECT_TRUE(std::isfinite(f32::columnFullness(3e38f)));
}

// What the shaders do: the transmittance in a column's middle, by exp2 of a quadratic, times width and fullness.
TEST(ColumnSpacing, WeightsOfColumnsAreTheIntegralsOfTransmittance) {
  for (const double nearest : {1.0, 0.6, 0.1})
    for (const double depth : {0.01, 1.0, 30.0}) {
      constexpr int kCount = 256;
      const double first = f64::columnsReach(nearest, 1.0 / kCount), more = 2 * (1 - nearest) / (double(kCount) * kCount);
      const auto weight = [&](int u) {
        const double width = first + more * u;
        return std::exp(-depth * (first * u + 0.5 * more * u * u)) * width * f64::columnFullness(depth * width);
      };
      const auto integral = [&](int u) {
        return f64::transmittanceIntegral(depth, f64::columnsReach(nearest, double(u) / kCount), f64::columnsReach(nearest, double(u + 1) / kCount));
      };
      for (int u = 1; u < kCount; ++u) EXPECT_NEAR(weight(u) / weight(0), integral(u) / integral(0), 1e-9 * (1 + 2 * (1 / nearest))) << nearest << ' ' << depth << ' ' << u;
    }
}

}  // namespace
