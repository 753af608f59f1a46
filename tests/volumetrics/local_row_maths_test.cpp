// Rows of spot and point lights: the change of variables from distance to angle at the light, the interval of a cone in
// a slice, and the share of the screen that decides how large a further light's map is, each against a plain
// computation.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "lib/cpp.hpp"
#include "stages/local_lights.hpp"

namespace {

using namespace tyndall::lib;
constexpr double kPi = std::numbers::pi;

// In-scattering by distance, from its definition: p exp(-sigma (t + d))/d^2 and the window of the range, by a fine
// midpoint rule in t.
double byDistance(double theta, double D, double sigma, double g, double range, double end) {
  constexpr int kSteps = 400'000;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double t = (i + 0.5) / kSteps * end;
    const double x = t * std::sin(theta), z = D - t * std::cos(theta);  // from the light, across and towards the eye
    const double d2 = x * x + z * z, d = std::sqrt(d2);
    // Light travels along (x, -z)/d seen with the axis from eye to light; it is scattered back along the view ray.
    const double cosine = -(x * std::sin(theta) - z * std::cos(theta)) / d;
    const double q = range > 0 ? d2 / (range * range) : 0;
    sum += f64::phaseHenyeyGreenstein(cosine, g) * std::exp(-sigma * (t + d)) / d2 * std::clamp(1 - q * q, 0.0, 1.0);
  }
  return sum * end / kSteps;
}

double byAngle(double theta, double D, double sigma, double g, double range, double end) {
  constexpr int kSteps = 100'000;
  const double last = f64::angleAtLight(std::sin(theta), std::cos(theta), end, D);
  double sum = 0;
  for (int i = 0; i < kSteps; ++i)
    sum += f64::localWeight(theta, (i + 0.5) / kSteps * last, sigma * D, g, range / D, 1e9, 0.0);
  return sum * last / kSteps / (D * std::sin(theta));
}

TEST(LocalRow, TheIntegralOverTheAngleIsThatOverTheDistance) {
  for (const double theta : {0.1, 0.7, 1.6, 2.6, 3.1})
    for (const double D : {0.5, 4.0, 20.0})
      for (const double range : {0.0, 3.0, 12.0}) {
        const double expected = byDistance(theta, D, 0.05, 0.4, range, 30);
        const double found = byAngle(theta, D, 0.05, 0.4, range, 30);
        EXPECT_NEAR(found, expected, 2e-4 * expected + 1e-9) << theta << ' ' << D << ' ' << range;
      }
}

TEST(LocalRow, ConeAnglesAreThoseInsideTheCone) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  int inside = 0;
  for (int i = 0; i < 20'000; ++i) {
    // The axis in a frame in which the slice's half-plane is x > 0, y = 0, and the direction from eye to light is z.
    const double z = 2 * unit(random) - 1, turn = 2 * kPi * unit(random), r = std::sqrt(1 - z * z);
    const double x = r * std::cos(turn);
    const double cosOuter = 0.05 + 0.9 * unit(random), psi = kPi * unit(random);
    const f64::Real2 span = f64::coneAngles(-z, x, r * std::sin(turn), cosOuter, std::sqrt(1 - cosOuter * cosOuter));
    const double cosine = x * std::sin(psi) - z * std::cos(psi);
    if (std::abs(cosine - cosOuter) < 1e-9) continue;
    EXPECT_EQ(cosine > cosOuter, psi > span.x && psi < span.y) << z << ' ' << x << ' ' << cosOuter << ' ' << psi;
    inside += cosine > cosOuter ? 1 : 0;
  }
  EXPECT_GT(inside, 2000);
}

// A beam of a hundredth of a degree across the slice's plane, in float: as wide as it is, by spherical trigonometry.
TEST(LocalRow, NarrowConesKeepTheirWidth) {
  for (const double outer : {1.7e-4, 1e-3, 0.02})
    for (const double share : {0.0, 0.5, 0.9, 1.1})
      for (const double middle : {0.3, 1.2, 2.9}) {
        const double beside = std::sin(share * outer), within = std::cos(share * outer);
        const f32::Real2 span = f32::coneAngles(
            static_cast<float>(within * std::cos(middle)), static_cast<float>(within * std::sin(middle)),
            static_cast<float>(beside), static_cast<float>(std::cos(outer)), static_cast<float>(std::sin(outer)));
        const double half = share < 1 ? std::acos(std::cos(outer) / within) : -1;
        if (share > 1) {
          EXPECT_GT(span.x, span.y) << outer;
          continue;
        }
        EXPECT_NEAR(span.y - span.x, 2 * half, 0.01 * half) << outer << ' ' << share;
        EXPECT_NEAR(0.5f * (span.x + span.y), middle, 1e-6) << outer << ' ' << share;
      }
}

// The projected sphere's bounding rectangle, by points all over the sphere.
TEST(LocalRow, ScreenShareIsThatOfTheProjectedRange) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<float> unit(-1, 1);
  volumetrics::RayBlock rays{};
  rays.forward = {0, 0, -1};
  rays.right = {0.8f, 0, 0};
  rays.up = {0, 0.45f, 0};
  for (int i = 0; i < 200; ++i) {
    volumetrics::LocalBlock light{};
    light.position = {8 * unit(random), 6 * unit(random), -12 + 6 * unit(random)};
    light.range = 2 + 1.5f * unit(random);
    glm::vec2 low(1e9f), high(-1e9f);
    for (int a = 0; a <= 200; ++a)
      for (int b = 0; b < 400; ++b) {
        const double polar = a * kPi / 200, turn = b * kPi / 200;
        const glm::dvec3 n(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar));
        const glm::vec3 p = light.position + light.range * glm::vec3(n);
        const glm::vec2 at(p.x / -p.z / 0.8f, p.y / -p.z / 0.45f);
        low = glm::min(low, at), high = glm::max(high, at);
      }
    low = glm::clamp(low, -1.0f, 1.0f), high = glm::clamp(high, -1.0f, 1.0f);
    const double expected = std::max(1e-6f, (high.x - low.x) * (high.y - low.y) / 4);
    EXPECT_NEAR(volumetrics::screenShare(light, rays), expected, 0.01)
        << light.position.x << ' ' << light.position.y << ' ' << light.position.z;
  }
  volumetrics::LocalBlock around{};
  around.position = {0, 0, -1};
  around.range = 5;
  EXPECT_EQ(volumetrics::screenShare(around, rays), 1) << "the eye is within the range";
  around.range = 0;
  EXPECT_EQ(volumetrics::screenShare(around, rays), 1) << "no range";
}

}  // namespace
