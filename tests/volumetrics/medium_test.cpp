// The medium's closed forms against numeric integration and against each other in three precisions.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "lib/cpp.hpp"

using namespace tyndall::lib;

TEST(Medium, PhaseIsNormalisedAndItsMeanCosineIsG) {
  for (double g : {-0.9, -0.5, 0.0, 0.3, 0.76, 0.95}) {
    double sum = 0, mean = 0;
    const int n = 400000;
    for (int i = 0; i < n; ++i) {
      const double c = -1 + 2 * (i + 0.5) / n;
      const double p = f64::phaseHenyeyGreenstein(c, g) * 2 * std::numbers::pi * 2 / n;
      sum += p;
      mean += p * c;
    }
    EXPECT_NEAR(sum, 1, 1e-6) << "g " << g;
    EXPECT_NEAR(mean, g, 1e-6) << "g " << g;
  }
}

TEST(Medium, ForwardScatteringIsBrightTowardsTheLight) {
  EXPECT_GT(f64::phaseHenyeyGreenstein(1, 0.5), f64::phaseHenyeyGreenstein(-1, 0.5) * 10);
}

TEST(Medium, TransmittanceIntegralMatchesTheMidpointRule) {
  for (double sigma : {0.0, 1e-9, 1e-5, 0.03, 0.4, 5.0})
    for (double a : {0.0, 0.5, 20.0})
      for (double length : {1e-6, 0.01, 1.0, 300.0}) {
        double sum = 0;
        const int n = 20000;
        for (int i = 0; i < n; ++i) sum += std::exp(-sigma * (a + length * (i + 0.5) / n)) * length / n;
        EXPECT_NEAR(f64::transmittanceIntegral(sigma, a, a + length), sum, 2e-3 * sum + 1e-300)
            << sigma << ' ' << a << ' ' << length;
        // Exactly, by expm1.
        const double exact = sigma == 0 ? length : -std::expm1(-sigma * length) / sigma * std::exp(-sigma * a);
        const double rounded = f64::transmittanceIntegral(sigma, a, a + length);
        EXPECT_NEAR(rounded / exact, 1, 1e-8) << sigma << ' ' << a << ' ' << length;
        if (sigma * (a + length) < 50) {
          const float s = static_cast<float>(sigma), from = static_cast<float>(a),
                      to = from + static_cast<float>(length);
          EXPECT_NEAR(f32::transmittanceIntegral(s, from, to) / f64::transmittanceIntegral(s, from, to), 1, 2e-5);
        }
      }
}

TEST(Medium, DistanceAtShareInvertsTheIntegral) {
  for (double sigma : {0.0, 1e-7, 1e-3, 0.03, 2.0})
    for (double length : {0.1, 10.0, 1000.0})
      for (double u = 0.005; u < 1; u += 0.1) {
        const double t = f64::distanceAtTransmittanceShare(sigma, length, u);
        EXPECT_NEAR(f64::transmittanceIntegral(sigma, 0, t) / f64::transmittanceIntegral(sigma, 0, length), u, 2e-6)
            << sigma << ' ' << length << ' ' << u;
        const double single = f32::distanceAtTransmittanceShare(static_cast<float>(sigma), static_cast<float>(length),
                                                                static_cast<float>(u));
        const double wide = f64::distanceAtTransmittanceShare(static_cast<float>(sigma), static_cast<float>(length),
                                                              static_cast<float>(u));
        // In float, 1 - u (1 - e^-x) is rounded by up to 1.2e-7, which moves the point by that over sigma times the
        // transmittance there; a few such roundings are allowed.
        const double step = sigma * length < 1e-3 ? 0 : 1.2e-7 * std::exp(sigma * wide) / sigma;
        EXPECT_NEAR(single, wide, 1e-5 * wide + 3 * step) << sigma << ' ' << length << ' ' << u;
      }
}

TEST(Epipolar, RunningWeightsAddUpToTheTransmittanceWeights) {
  for (double x : {0.0, 1e-7, 1e-3, 0.2, 3.0}) {
    double average = 0, sum = 0, total = 0;
    for (int u = 0; u < 500; ++u) {
      const double value = std::sin(u * 0.7);
      average += (value - average) * f64::runningWeight(u, x);
      const double weight = x == 0 ? 1 : std::exp(-u * x) * -std::expm1(-x);
      sum += weight * value;
      total += weight;
      ASSERT_NEAR(average, sum / total, 1e-6) << x << ' ' << u;
    }
  }
}

// The coordinate of the reference rays grows with the cosecant and comes back to it, in float.
TEST(Epipolar, TheReferenceCoordinateIsInvertible) {
  for (const float kappa : {1e-2f, 0.3f, 5.0f, 1000.0f}) {
    float before = -1;
    for (float c = 1; c <= 50; c *= 1.07f) {
      const float coordinate = f32::referenceCoordinate(c, kappa);
      EXPECT_GT(coordinate, before) << kappa;
      before = coordinate;
      EXPECT_NEAR(f32::referenceCosecant(coordinate, kappa) / c, 1, 2e-5) << kappa << ' ' << c;
    }
  }
  EXPECT_FLOAT_EQ(f32::cosecant(1.5707963f), 1);
  EXPECT_FLOAT_EQ(f32::cosecant(0), 50);  // floored
}

TEST(Epipolar, LagrangeWeightsReproducePolynomials) {
  for (int count = 1; count <= 6; ++count)
    for (double x = -1; x <= 1; x += 0.13)
      for (int degree = 0; degree < count; ++degree) {
        double sum = 0;
        for (int k = 0; k < count; ++k)
          sum += f64::chebyshevLagrange(k, count, x) * std::pow(f64::chebyshevNode(k, count), degree);
        EXPECT_NEAR(sum, std::pow(x, degree), 1e-12);
      }
}
