// Two depths from three moments (algorithm 2) under stress.
#include <gtest/gtest.h>

#include <glm/gtc/type_precision.hpp>

#include "distributions.hpp"
#include "lib/cpp.hpp"
#include "report.hpp"

namespace tyndall::stability {
namespace {

/// Finite, inside the range, ordered, shares in [0, 1] that sum to 1.
template <class Vector>
void expectWellFormed(const Vector& d) {
  ASSERT_TRUE(d.x >= -1 && d.x <= d.y && d.y <= 1) << d.x << ' ' << d.y;
  ASSERT_TRUE(d.z >= 0 && d.z <= 1 && d.w >= 0 && d.w <= 1) << d.z << ' ' << d.w;
  ASSERT_NEAR(static_cast<double>(d.z + d.w), 1, 1e-6);
}

/// Worst miss of moments 1 to 3.
double missed(const glm::vec4& d, const std::array<double, 7>& b) {
  double worst = 0;
  for (int power = 1; power <= 3; ++power) {
    const double found = static_cast<double>(d.z) * std::pow(static_cast<double>(d.x), power) +
                         static_cast<double>(d.w) * std::pow(static_cast<double>(d.y), power);
    raise(worst, std::abs(found - b[static_cast<std::size_t>(power)]));
  }
  return worst;
}

TEST(Stability, TwoDepthsKeepTheMoments) {
  Random random{6};
  Row row{.routine = "twoDepths, moments 1 to 3 kept", .precision = "float", .cases = shareOfCases(0.08), .error = 0};
  for (std::uint64_t i = 0; i < row.cases; ++i) {
    const Blockers blockers = makeBlockers(random);
    const auto b = momentsOf(blockers);
    const glm::vec4 found = lib::f32::twoDepths(glm::vec4(b[1], b[2], b[3], b[4]));
    expectWellFormed(found);
    if (HasFatalFailure()) return;
    raise(row.error, missed(found, b));
  }
  report(row);
  // A variance of 1e-6, dropped as rounding, moves b2 by 1e-6 and b3 by three times that.
  EXPECT_LT(row.error, 4e-6);
}

TEST(Stability, TwoDepthsFindTwoSurfaces) {
  Random random{7};
  Row row{.routine = "twoDepths, depth x share of two surfaces",
          .precision = "float",
          .cases = shareOfCases(0.04),
          .error = 0};
  for (std::uint64_t i = 0; i < row.cases; ++i) {
    double low = random.between(-1, 1), high = random.between(-1, 1);
    if (low > high) std::swap(low, high);
    const double share = random.next();
    if (share * (1 - share) * (high - low) * (high - low) < 1e-5) continue;
    const auto mean = [&](int power) { return (1 - share) * std::pow(low, power) + share * std::pow(high, power); };
    const glm::vec4 found = lib::f32::twoDepths(glm::vec4(mean(1), mean(2), mean(3), 0));
    // A faint surface's depth is vague, so its share weighs the miss.
    raise(row.error, std::abs(static_cast<double>(found.x) - low) * (1 - share));
    raise(row.error, std::abs(static_cast<double>(found.y) - high) * share);
  }
  report(row);
  EXPECT_LT(row.error, 0.01);
}

// What a texture may return that no distribution has: rounded, filtered, clamped or plain wrong moments.
TEST(Stability, TwoDepthsAreWellFormedForAnyInput) {
  Random random{8};
  const std::uint64_t cases = shareOfCases(0.04);
  for (std::uint64_t i = 0; i < cases; ++i) {
    glm::vec4 b;
    for (int j = 0; j < 4; ++j) {
      const double size = random.next() < 0.5 ? 1.0 : random.decades(1e-30, 1e30);
      b[j] = static_cast<float>(random.next() < 0.1 ? std::round(random.between(-1, 1)) : size * random.between(-1, 1));
    }
    expectWellFormed(lib::f32::twoDepths(b));
    if (HasFatalFailure()) FAIL() << b.x << ' ' << b.y << ' ' << b.z;
  }
  report({.routine = "twoDepths, any input well-formed", .precision = "float", .cases = cases});
}

}  // namespace
}  // namespace tyndall::stability
