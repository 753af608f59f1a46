// Bounds of visibility from four and six moments under stress: stored at every precision, evaluated in float, double
// and long double, with moments that are exact and moments from the running average of a prefix.
#include <gtest/gtest.h>

#include "bias_search.hpp"
#include "distributions.hpp"
#include "prefix_row.hpp"

namespace tyndall::stability {
namespace {

/// Evaluates one texel in all numbers, checks the range, and gathers the worst.
class Worst {
 public:
  explicit Worst(const Format& format) : format_(format), bias_(storageOf(format).bias), ladder_(format) {}
  void add(const Texel& texel, float zf, const Truth& truth) {
    ++cases_;
    double bound[2];
    for (int side = 0; side < 2; ++side) {
      const float beta = static_cast<float>(side);
      bound[side] = static_cast<double>(visibility<float>(format_, texel, bias_, zf, beta));
      const double wide = visibility<double>(format_, texel, bias_, zf, beta);
      const double exact = static_cast<double>(visibility<long double>(format_, texel, bias_, zf, beta));
      ASSERT_TRUE(bound[side] >= 0 && bound[side] <= 1) << format_.name << ": " << bound[side];
      raise(error_, std::abs(bound[side] - exact));
      raise(doubleError_, std::abs(wide - exact));
    }
    raise(violation_, std::max(bound[0] - truth.high, truth.low - bound[1]));
    ladder_.add(texel, zf, truth);
  }
  Row row(const std::string& routine) const {
    return {.routine = routine,
            .precision = format_.name,
            .cases = cases_,
            .error = error_,
            .doubleError = doubleError_,
            .violation = violation_,
            .safeBias = ladder_.smallestSafe(),
            .paperBias = format_.paper,
            .bias = static_cast<double>(bias_)};
  }

 private:
  Format format_;
  float bias_;
  std::uint64_t cases_ = 0;
  double error_ = 0, doubleError_ = 0, violation_ = 0;
  BiasLadder ladder_;
};

std::array<float, 7> rounded(const std::array<double, 7>& b) {
  std::array<float, 7> r{};
  for (std::size_t i = 0; i < b.size(); ++i) r[i] = static_cast<float>(b[i]);
  return r;
}

std::string routineOf(const Format& format, const char* what) {
  return (format.moments == 4 ? "visibility4, " : "visibility6, ") + std::string(what);
}

/// What a bias explains and a slack; and a bias that is safe, yet not four times as large as need be.
void expectSafe(const Row& row) {
  report(row);
  EXPECT_LE(row.bias, 4 * row.safeBias) << row.routine << ' ' << row.precision;
  EXPECT_LT(row.violation, row.bias + kSlack) << row.routine << ' ' << row.precision;
  EXPECT_LE(row.safeBias, row.bias) << row.routine << ' ' << row.precision;
}

class MomentsStress : public testing::TestWithParam<Format> {};

TEST_P(MomentsStress, ExactMomentsHoldTheirBounds) {
  const Format format = GetParam();
  Worst worst(format);
  Random random{1};
  const std::uint64_t cases = shareOfCases(0.09);
  for (std::uint64_t i = 0; i < cases; ++i) {
    const Blockers blockers = makeBlockers(random);
    const float zf = rayDepth(random, blockers.z);
    Texel texel = stored(format, rounded(momentsOf(blockers)));
    Truth truth = visibilityAt(blockers, zf);
    if (random.next() < 0.3) {  // as a linear filter returns it, halfway to another
      const Blockers other = makeBlockers(random);
      const float t = static_cast<float>(random.below(257)) / 256;
      texel = filtered(texel, stored(format, rounded(momentsOf(other))), t);
      const Truth beyond = visibilityAt(other, zf);
      truth = {glm::mix(truth.low, beyond.low, static_cast<double>(t)),
               glm::mix(truth.high, beyond.high, static_cast<double>(t))};
    }
    worst.add(texel, zf, truth);
    if (HasFatalFailure()) return;
  }
  expectSafe(worst.row(routineOf(format, "exact moments, 30 % filtered")));
}

enum class Average { kPlain, kCompensated, kScanned };

/// Prefixes of rows of up to 4096 columns.
Row prefixRow(const Format& format, Average how, const char* what) {
  Worst worst(format);
  Random random{2};
  const int samples = 16;
  const std::uint64_t rows = shareOfCases(0.02) / samples + 1;
  for (std::uint64_t i = 0; i < rows && !testing::Test::HasFatalFailure(); ++i) {
    const int columns = static_cast<int>(random.decades(64, 4097));
    const MapRow row = makeRow(random, columns, storageOf(format).depth == volumetrics::DepthBits::k16 ? 16 : 32);
    const std::vector<float> weights = columnWeights(row);
    // basisAt() of moments_prefix.comp.glsl: z to z^4, z^5 and z^6.
    const auto powers = [&](std::size_t column) {
      const float z = 2.0f * row.depth[column] - 1.0f, z2 = z * z;
      return std::array{glm::vec4(z, z2, z * z2, z2 * z2), glm::vec4(z * (z2 * z2), z2 * (z2 * z2), 0, 0)};
    };
    std::vector<std::array<float, 7>> averages;
    const auto keep = [&](std::size_t, const std::array<glm::vec4, 2>& v) {
      averages.push_back({1, v[0].x, v[0].y, v[0].z, v[0].w, v[1].x, v[1].y});
    };
    if (how == Average::kScanned)
      scannedAverage<2>(weights, 16, powers, keep);
    else
      runningAverage<2>(weights, how == Average::kCompensated, powers, keep);
    for (int s = 0; s < samples; ++s) {
      const auto column =
          static_cast<std::size_t>(s == 0 ? columns - 1 : static_cast<int>(random.decades(1, columns)) - 1);
      const Blockers blockers = blockersOf(row, weights, column + 1);
      const float zf = rayDepth(random, blockers.z);
      worst.add(stored(format, averages[column]), zf, visibilityAt(blockers, zf));
    }
  }
  return worst.row(routineOf(format, what));
}

TEST_P(MomentsStress, CompensatedPrefixHoldsItsBounds) {
  expectSafe(prefixRow(GetParam(), Average::kCompensated, "compensated prefix"));
}

TEST_P(MomentsStress, ScannedPrefixHoldsItsBounds) {
  expectSafe(prefixRow(GetParam(), Average::kScanned, "compensated prefix by scan"));
}

// Why the averages need lostInSum(): the same without it. Finite and in [0, 1] all the same; the 10-bit format, whose
// bias outweighs the rounding, stays safe.
TEST_P(MomentsStress, PlainPrefixStaysInRange) {
  const Row row = prefixRow(GetParam(), Average::kPlain, "plain prefix");
  report(row);
  if (GetParam().moments == 6 && GetParam().precision == Precision::kCompact) {
    EXPECT_LT(row.violation, row.bias + kSlack);
  }
}

INSTANTIATE_TEST_SUITE_P(EveryFormat, MomentsStress, testing::ValuesIn(kFormats), [](const auto& given) {
  return (given.param.moments == 4 ? "Four" : "Six") +
         std::string(given.param.precision == Precision::kCompact    ? "Compact"
                     : given.param.precision == Precision::kStandard ? "Standard"
                                                                     : "Full");
});

}  // namespace
}  // namespace tyndall::stability
