// The Fourier basis under stress: the recurrences in float against long double direct sums, at every precision of
// storage, for 4 to 128 functions; and the reconstruction against the truth within the proven bound of the truncated
// series.
#include <gtest/gtest.h>

#include "distributions.hpp"
#include "prefix_row.hpp"
#include "report.hpp"

namespace tyndall::stability {
namespace {

constexpr long double kPi = 3.14159265358979323846264338327950288L;
constexpr int kLayersMost = 32;

/// What the basis textures hold for the blockers: averages of sines and cosines in [-1, 1].
using Basis = std::array<glm::vec4, kLayersMost>;

/// basisAt() of fourier_prefix.comp.glsl, a group of `groupLayers` layers at a time.
Basis basisAt(float depth, int layers, int groupLayers) {
  using namespace lib::f32;
  Basis basis{};
  const glm::vec2 turn = fourierTurn(depth);
  glm::vec2 phase{};
  for (int layer = 0; layer < layers; ++layer) {
    if (layer % groupLayers == 0) phase = fourierStart(depth, layer);
    const glm::vec2 second = fourierNext(phase, turn);
    basis[static_cast<std::size_t>(layer)] = fourierBasis(phase, second);
    phase = fourierNext(second, turn);
  }
  return basis;
}

/// visibilities() of fourier_evaluate.comp.glsl before its clamp.
template <class Real>
Real evaluate(const Basis& basis, float zf, int count) {
  using namespace lib::f32;
  using namespace lib::f64;
  using namespace lib::f80;
  const Real z = zf;
  Real sum = Real(0.5);
  const auto turn = fourierTurn(z);
  auto phase = fourierStart(z, 0);
  for (int layer = 0; 4 * layer < count; ++layer) {
    const auto second = fourierNext(phase, turn);
    // fourierMask() has no number of type Real among its arguments: its values are exact in float.
    const glm::vec<4, Real> mask(lib::f32::fourierMask(layer, count));
    sum += dot(fourierCoefficients(phase, second, layer) * mask,
               glm::vec<4, Real>(basis[static_cast<std::size_t>(layer)]));
    phase = fourierNext(second, turn);
  }
  return sum;
}

/// The same sum, each sine and cosine computed by itself.
long double direct(const Basis& basis, float zf, int count) {
  long double sum = 0.5L;
  for (int i = 0; i < count; ++i) {
    const long double c = (2 * (i / 2) + 1) * kPi;
    const long double value = basis[static_cast<std::size_t>(i / 4)][i % 4];
    sum += 2 / c *
           (i % 2 == 0 ? std::cos(c * static_cast<long double>(zf)) : -std::sin(c * static_cast<long double>(zf))) *
           value;
  }
  return sum;
}

/// Bound of |series - step| at distance x between ray and blocker, for count / 2 = m frequencies: the rest of sum
/// sin((2k+1) t) / (2k+1), t = pi x, is at most 1 / ((2m+1) sin t) by Abel summation; near the step 1/2 and beside it
/// Gibbs' overshoot, 0.09.
double seriesBound(double x, int count) {
  const double sine = std::sin(3.14159265358979 * std::abs(x));
  const double far = sine > 0 ? 2 / 3.14159265358979 / ((count + 1) * sine) : 1;
  return std::min(0.5, far);
}

struct Precisions {
  const char* name;
  int bits;  ///< 0: float
};

void PrintTo(const Precisions& precisions, std::ostream* out) { *out << precisions.name; }

class FourierStress : public testing::TestWithParam<Precisions> {};

TEST_P(FourierStress, AgreesWithDirectSumsAndTheSeriesBound) {
  const int bits = GetParam().bits;
  const double halfStep = bits == 0 ? 0 : 1.0 / ((1 << bits) - 1);  // of a value in [-1, 1]
  Random random{3};
  Row row{.routine = "fourier 4 to 128",
          .precision = GetParam().name,
          .cases = shareOfCases(0.02),
          .error = 0,
          .doubleError = 0,
          .violation = 0};
  for (std::uint64_t i = 0; i < row.cases; ++i) {
    const int count = 4 * static_cast<int>(random.decades(1, 32.99));
    Blockers blockers = makeBlockers(random);
    while (blockers.z.size() > 64) blockers = makeBlockers(random);
    for (float& z : blockers.z) z = 0.5f + 0.5f * z;  // depths in [0, 1]
    const float zf = std::min(std::max(rayDepth(random, blockers.z), 0.0f), 1.0f);
    std::array<glm::dvec4, kLayersMost> mean{};
    const int group = 1 + random.below(8);
    double bound = 0;
    for (std::size_t b = 0; b < blockers.z.size(); ++b) {
      const Basis basis = basisAt(blockers.z[b], (count + 3) / 4, group);
      for (std::size_t layer = 0; layer < basis.size(); ++layer)
        mean[layer] += glm::dvec4(basis[layer]) * blockers.share[b];
      bound += blockers.share[b] * seriesBound(static_cast<double>(blockers.z[b]) - static_cast<double>(zf), count);
    }
    Basis basis{};
    double storage = 0;  // what rounding the stored values can move the sum by
    for (int k = 0; k < count; ++k) {
      float& value = basis[static_cast<std::size_t>(k / 4)][k % 4];
      value = static_cast<float>(mean[static_cast<std::size_t>(k / 4)][k % 4]);
      if (bits > 0) {
        const float top = static_cast<float>((1 << bits) - 1);
        value = std::round((value * 0.5f + 0.5f) * top) / top * 2.0f - 1.0f;
      }
      storage += k % 2 == 0 ? 2 * std::sqrt(2.0) / ((2 * (k / 2) + 1) * 3.14159265) * halfStep : 0;
    }
    const long double exact = direct(basis, zf, count);
    const float sum = evaluate<float>(basis, zf, count);
    ASSERT_TRUE(std::isfinite(sum));
    raise(row.error, static_cast<double>(std::abs(static_cast<long double>(sum) - exact)));
    raise(row.doubleError,
          static_cast<double>(std::abs(static_cast<long double>(evaluate<double>(basis, zf, count)) - exact)));
    const double clamped = std::min(std::max(static_cast<double>(sum), 0.0), 1.0);
    const Truth truth = visibilityAt(blockers, zf);
    const double off = std::max({0.0, truth.low - clamped, clamped - truth.high});
    raise(row.violation, off - bound - storage);
  }
  report(row);
  // 6e-5: 64 frequencies by recurrence, each product rounding by 1.2e-7 (grows with the frequency), times 2/c, summed;
  // measured 2e-5.
  EXPECT_LT(row.error, 6e-5);
  EXPECT_LT(row.doubleError, 2e-13);
  EXPECT_LT(row.violation, 6e-5) << "beyond the proven bound of the truncated series and the storage";
}

INSTANTIATE_TEST_SUITE_P(EveryPrecision, FourierStress,
                         testing::Values(Precisions{"float", 0}, Precisions{"16 bit", 16}, Precisions{"8 bit", 8}),
                         [](const auto& given) {
                           return "Bits" + std::to_string(given.param.bits == 0 ? 32 : given.param.bits);
                         });

// A phase of the recurrence against the sine and cosine themselves, over all 64 frequencies in one run.
TEST(Stability, FourierPhasesStayAccurate) {
  Random random{4};
  Row row{.routine = "fourierNext, 64 frequencies", .precision = "float", .cases = shareOfCases(0.01), .error = 0};
  for (std::uint64_t i = 0; i < row.cases; ++i) {
    const float z =
        random.next() < 0.1 ? std::round(static_cast<float>(random.next())) : static_cast<float>(random.next());
    const int frequency = random.below(64);
    glm::vec2 phase = lib::f32::fourierStart(z, 0);
    const glm::vec2 turn = lib::f32::fourierTurn(z);
    for (int k = 0; k < frequency; ++k) phase = lib::f32::fourierNext(phase, turn);
    const long double c = (2 * frequency + 1) * kPi * static_cast<long double>(z);
    raise(row.error, static_cast<double>(std::abs(static_cast<long double>(phase.x) - std::cos(c))));
    raise(row.error, static_cast<double>(std::abs(static_cast<long double>(phase.y) - std::sin(c))));
  }
  report(row);
  EXPECT_LT(row.error, 4e-5);
}

// The running average of 32 functions in float, plain, against double: what the prefix loses before storage.
TEST(Stability, FourierPrefixLosesLessThanSixteenBits) {
  Random random{5};
  const std::uint64_t rows = shareOfCases(0.0002);
  Row row{.routine = "fourier prefix, 32 functions", .precision = "float", .error = 0};
  for (std::uint64_t i = 0; i < rows; ++i) {
    const MapRow map = makeRow(random, static_cast<int>(random.decades(64, 4097)), 32);
    const std::vector<float> weights = columnWeights(map);
    std::array<glm::dvec4, 8> sum{};
    double total = 0;
    const auto make = [&](std::size_t column) {
      const Basis basis = basisAt(map.depth[column], 8, 8);
      std::array<glm::vec4, 8> eight;
      std::copy_n(basis.begin(), 8, eight.begin());
      return eight;
    };
    runningAverage<8>(weights, false, make, [&](std::size_t column, const std::array<glm::vec4, 8>& average) {
      const auto next = make(column);
      total += static_cast<double>(weights[column]);
      ++row.cases;
      for (std::size_t layer = 0; layer < 8; ++layer) {
        sum[layer] += glm::dvec4(next[layer]) * static_cast<double>(weights[column]);
        const glm::dvec4 off = abs(sum[layer] / total - glm::dvec4(average[layer]));
        raise(row.error, std::max(std::max(off.x, off.y), std::max(off.z, off.w)));
      }
    });
  }
  report(row);
  // Standing still at half an ulp over 4096 columns: at most 2^-25 * 4096 = 1.2e-4 of a value up to 1; 8 bits resolve
  // 4e-3.
  EXPECT_LT(row.error, 1.3e-4);
}

}  // namespace
}  // namespace tyndall::stability
