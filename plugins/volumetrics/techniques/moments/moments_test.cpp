// The moment bounds under stress: random, single-depth, nearly equal, clamped and sorted distributions; in double
// (bounds must hold), in float (results finite, in [0, 1] and near the double ones), after quantisation at every
// precision.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

#include "lib/cpp.hpp"
#include "techniques/moments/storage.hpp"

namespace {

using namespace tyndall::lib;
using volumetrics::momentStorage;
using volumetrics::MomentStorage;
using volumetrics::Precision;

/// SplitMix64 (Steele et al. 2014).
struct Random {
  std::uint64_t state;
  double next() {
    std::uint64_t z = state += 0x9e3779b97f4a7c15ull;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }
};

struct Case {
  std::array<double, 7> b{};  ///< b[0] = 1
  double zf = 0;
  double lowTruth = 0;   ///< share of the mass strictly beyond zf
  double highTruth = 0;  ///< share at or beyond zf
};

Case makeCase(Random& random) {
  const int kind = static_cast<int>(random.next() * 6);
  const int count = kind == 1 ? 1 : 1 + static_cast<int>(random.next() * 16);
  std::vector<double> z(count), w(count);
  double total = 0;
  const double centre = 2 * random.next() - 1;
  for (int i = 0; i < count; ++i) {
    z[i] = 2 * random.next() - 1;
    if (kind == 2) z[i] = std::clamp(centre + 1e-4 * (random.next() - 0.5), -1.0, 1.0);  // nearly equal
    if (kind == 3) z[i] = random.next() < 0.5 ? -1 : 1;                                  // clamped at both ends
    if (kind == 4) z[i] = std::clamp(3 * z[i], -1.0, 1.0);                               // many clamped
    w[i] = kind == 5 ? std::pow(random.next(), 8) + 1e-12 : random.next() + 1e-3;        // very uneven weights
    total += w[i];
  }
  Case made;
  const double pick = random.next();
  made.zf = pick < 0.3   ? z[static_cast<std::size_t>(random.next() * count)]
            : pick < 0.4 ? (random.next() < 0.5 ? -1 : 1)
                         : 2 * random.next() - 1;
  for (int i = 0; i < count; ++i) {
    double power = 1;
    for (double& b : made.b) {
      b += w[i] / total * power;
      power *= z[i];
    }
    made.highTruth += z[i] >= made.zf ? w[i] / total : 0;
    made.lowTruth += z[i] > made.zf ? w[i] / total : 0;
  }
  return made;
}

int caseCount() {
  const char* wanted = std::getenv("TYNDALL_STRESS_CASES");
  return wanted ? std::atoi(wanted) : 1000000;
}

template <class Real>
Real unorm(Real x, int bits) {
  const Real top = static_cast<Real>((1 << bits) - 1);
  return std::round(std::clamp(x, Real(0), Real(1)) * top) / top;
}

/// What the prefix images of `storage` give back for exact moments, as 32-bit numbers.
struct Stored {
  glm::vec4 four;
  glm::vec3 odd, even;
};
Stored throughStorage(const Case& c, int moments, Precision precision) {
  const MomentStorage s = momentStorage(moments, precision);
  const int bits = s.first == TY_FORMAT_A2B10G10R10_UNORM ? 10 : 16;
  glm::vec4 four(c.b[1], c.b[2], c.b[3], c.b[4]);
  glm::vec3 odd(c.b[1], c.b[3], c.b[5]), even(c.b[2], c.b[4], c.b[6]);
  if (s.quantise) {
    four = f32::quantise4(four);
    odd = f32::quantise6Odd(odd);
    even = f32::quantise6Even(even);
    for (int i = 0; i < 4; ++i) four[i] = unorm(four[i], bits);
    for (int i = 0; i < 3; ++i) odd[i] = unorm(odd[i], bits), even[i] = unorm(even[i], bits);
    four = f32::dequantise4(four);
    odd = f32::dequantise6Odd(odd);
    even = f32::dequantise6Even(even);
  }
  return {four, odd, even};
}

}  // namespace

TEST(Moments, QuantisationInverts) {
  Random random{1};
  for (int i = 0; i < 1000; ++i) {
    const Case c = makeCase(random);
    const glm::dvec4 four(c.b[1], c.b[2], c.b[3], c.b[4]);
    const glm::dvec3 odd(c.b[1], c.b[3], c.b[5]), even(c.b[2], c.b[4], c.b[6]);
    EXPECT_LT(glm::length(f64::dequantise4(f64::quantise4(four)) - four), 1e-14);
    EXPECT_LT(glm::length(f64::dequantise6Odd(f64::quantise6Odd(odd)) - odd), 1e-14);
    EXPECT_LT(glm::length(f64::dequantise6Even(f64::quantise6Even(even)) - even), 1e-12);
    for (int j = 0; j < 4; ++j) EXPECT_NEAR(f64::quantise4(four)[j], 0.5, 0.5 + 1e-9);
    for (int j = 0; j < 3; ++j) {
      EXPECT_NEAR(f64::quantise6Odd(odd)[j], 0.5, 0.5 + 1e-7);
      EXPECT_NEAR(f64::quantise6Even(even)[j], 0.5, 0.5 + 1e-7);
    }
  }
}

TEST(Moments, CubicRootsAreRoots) {
  Random random{2};
  for (int i = 0; i < 100000; ++i) {
    std::array<double, 3> z{};
    for (double& root : z) root = 4 * random.next() - 2;
    std::sort(z.begin(), z.end());
    if (z[1] - z[0] < 1e-3 || z[2] - z[1] < 1e-3) continue;
    const double s = 2 * random.next() - 1 + 1e-3;
    const glm::dvec4 c(-s * z[0] * z[1] * z[2], s * (z[0] * z[1] + z[0] * z[2] + z[1] * z[2]),
                       -s * (z[0] + z[1] + z[2]), s);
    const glm::dvec3 roots = f64::cubicRoots(c);
    std::array<double, 3> found{roots.x, roots.y, roots.z};
    std::sort(found.begin(), found.end());
    for (int j = 0; j < 3; ++j) ASSERT_NEAR(found[j], z[j], 1e-6);
  }
}

// A far root must not cost the near ones their digits, in float: that broke the bounds where a ray's depth lies on a
// blocker's.
TEST(Moments, CubicRootsSurviveAFarRoot) {
  Random random{6};
  for (int i = 0; i < 100000; ++i) {
    const double low = -1 + 0.9 * random.next(), high = 0.1 + 0.9 * random.next();
    const double far = std::pow(10.0, 1 + 5 * random.next()) * (random.next() < 0.5 ? -1 : 1);
    // (z - low)(z - high)(1 - z / far)
    const glm::vec4 c(low * high, -low - high - low * high / far, 1 + (low + high) / far, -1 / far);
    const glm::vec3 roots = f32::cubicRoots(c);
    std::array<float, 3> found{roots.x, roots.y, roots.z};
    std::sort(found.begin(), found.end(), [](float a, float b) { return std::abs(a) < std::abs(b); });
    ASSERT_NEAR(std::min(found[0], found[1]), low, 2e-6) << far;
    ASSERT_NEAR(std::max(found[0], found[1]), high, 2e-6) << far;
    ASSERT_NEAR(found[2] / far, 1, 1e-5);
  }
}

// Lower <= truth <= upper, in double with a bias just above rounding. The bias moves the bounds by at most about itself
// times the condition of the problem: 1e-9 bias, 1e-4 allowed; a wrong formula misses by tenths.
TEST(Moments, BoundsHoldInDouble) {
  Random random{3};
  double worst4 = 0, worst6 = 0;
  for (int i = 0; i < caseCount(); ++i) {
    const Case c = makeCase(random);
    const double bias = 1e-9;
    const auto v4 = [&](double beta) {
      return f64::visibility4(f64::bias4({c.b[1], c.b[2], c.b[3], c.b[4]}, bias, 0.375), c.zf, beta);
    };
    const auto v6 = [&](double beta) {
      return f64::visibility6(f64::bias6Odd({c.b[1], c.b[3], c.b[5]}, bias),
                              f64::bias6Even({c.b[2], c.b[4], c.b[6]}, bias), c.zf, beta);
    };
    // A mass exactly at zf is inside [lower, upper] on both conventions.
    worst4 = std::max({worst4, v4(0) - c.highTruth, c.lowTruth - v4(1)});
    worst6 = std::max({worst6, v6(0) - c.highTruth, c.lowTruth - v6(1)});
    ASSERT_GE(v4(1), v4(0) - 1e-9);
    ASSERT_GE(v6(1), v6(0) - 1e-6);
  }
  EXPECT_LT(worst4, 1e-4);
  EXPECT_LT(worst6, 1e-4);
  RecordProperty("worst4", std::to_string(worst4));
  RecordProperty("worst6", std::to_string(worst6));
}

// Six moments know more than four: their bounds are never wider (up to rounding and bias).
TEST(Moments, SixBoundAtLeastAsTightlyAsFour) {
  Random random{4};
  double sum4 = 0, sum6 = 0;
  for (int i = 0; i < 100000; ++i) {
    const Case c = makeCase(random);
    const auto four = f64::bias4({c.b[1], c.b[2], c.b[3], c.b[4]}, 1e-9, 0.375);
    const auto odd = f64::bias6Odd({c.b[1], c.b[3], c.b[5]}, 1e-9);
    const auto even = f64::bias6Even({c.b[2], c.b[4], c.b[6]}, 1e-9);
    const double width4 = f64::visibility4(four, c.zf, 1) - f64::visibility4(four, c.zf, 0);
    const double width6 = f64::visibility6(odd, even, c.zf, 1) - f64::visibility6(odd, even, c.zf, 0);
    EXPECT_LT(width6, width4 + 1e-3);
    sum4 += width4;
    sum6 += width6;
  }
  EXPECT_LT(sum6, 0.9 * sum4);
}

// At every precision, through storage and with the biases of storage.hpp, float results are finite, in [0, 1], and
// violate the bounds by no more than the bias explains, which mixes that much of another distribution in, and 1e-4
// (tests/stability has the harder cases).
TEST(Moments, FloatIsSafeAtEveryPrecision) {
  struct Row {
    int moments;
    Precision precision;
  };
  for (const Row row : {Row{4, Precision::kCompact}, Row{4, Precision::kFull}, Row{6, Precision::kCompact},
                        Row{6, Precision::kStandard}, Row{6, Precision::kFull}}) {
    const MomentStorage s = momentStorage(row.moments, row.precision);
    Random random{5};
    double worst = 0;
    for (int i = 0; i < caseCount() / 2; ++i) {
      const Case c = makeCase(random);
      const Stored stored = throughStorage(c, row.moments, row.precision);
      std::array<float, 2> bound{};
      for (int side = 0; side < 2; ++side) {
        const float zf = static_cast<float>(c.zf), beta = static_cast<float>(side);
        bound[side] = row.moments == 4 ? f32::visibility4(f32::bias4(stored.four, s.bias, s.evenTarget), zf, beta)
                                       : f32::visibility6(f32::bias6Odd(stored.odd, s.bias),
                                                          f32::bias6Even(stored.even, s.bias), zf, beta);
        ASSERT_TRUE(bound[side] >= 0 && bound[side] <= 1) << row.moments << ' ' << bound[side];
      }
      worst = std::max({worst, bound[0] - c.highTruth, c.lowTruth - bound[1]});
    }
    EXPECT_LT(worst, static_cast<double>(s.bias) + 1e-4)
        << row.moments << " moments, precision " << static_cast<int>(row.precision);
    std::printf("moments %d, precision %d: worst bound violation %.4f over %d cases\n", row.moments,
                static_cast<int>(row.precision), worst, caseCount() / 2);
  }
}
