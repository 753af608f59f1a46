// Closed forms of the medium and the epipolar frame under stress: float against long double, over 30 decades of input.
#include <gtest/gtest.h>

#include "medium_cases.hpp"
#include "prefix_row.hpp"
#include "report.hpp"

namespace tyndall::stability {
namespace {

class MediumStress : public testing::TestWithParam<int> {};

TEST_P(MediumStress, FloatAgreesWithLongDouble) {
  const auto routine = static_cast<Routine>(GetParam());
  const RoutineRow& about = kRoutines[static_cast<std::size_t>(GetParam())];
  Random random{static_cast<std::uint64_t>(100 + GetParam())};
  Row row{.routine = about.name, .precision = "float", .cases = shareOfCases(0.018), .error = 0};
  MediumCase worst{routine};
  for (std::uint64_t i = 0; i < row.cases; ++i) {
    const MediumCase c = makeMediumCase(random, routine);
    const auto got = evaluate<float>(c);
    ASSERT_TRUE(std::isfinite(got[0]) && std::isfinite(got[1])) << c.in[0] << ' ' << c.in[1] << ' ' << c.in[2];
    const double error = errorOf(c, got);
    if (!(error <= row.error)) worst = c;
    raise(row.error, error);
  }
  report(row);
  EXPECT_LT(row.error, about.allowed) << about.name << " of " << worst.in[0] << ' ' << worst.in[1] << ' ' << worst.in[2]
                                      << ' ' << worst.in[3];
}

INSTANTIATE_TEST_SUITE_P(EveryRoutine, MediumStress, testing::Range(0, static_cast<int>(Routine::kCount)));

// The weights of a prefix come from a power that is multiplied on from column to column.
TEST(Stability, PrefixWeightsDriftLittle) {
  Random random{9};
  Row row{.routine = "prefix weights, 4096 columns, relative / (1 + depth)", .precision = "float", .error = 0};
  const std::uint64_t rows = shareOfCases(0.00003);
  for (std::uint64_t i = 0; i < rows; ++i) {
    const MapRow map = makeRow(random, 4096, 16);
    const std::vector<float> weights = columnWeights(map);
    const long double x = map.opticalDepth;
    for (std::size_t column = 0; column < weights.size(); ++column) {
      const long double depth = x * static_cast<long double>(column);
      if (depth > 60) break;  // e^-60: nothing is left
      const long double truth = std::exp(-depth) * (x == 0 ? 1 : -std::expm1(-x) / x);
      raise(row.error,
            static_cast<double>(std::abs(static_cast<long double>(weights[column]) / truth - 1) / (1 + depth)));
      ++row.cases;
    }
  }
  report(row);
  // Half an ulp of e^-x a column, at worst all of one sign: 4096 * 6e-8.
  EXPECT_LT(row.error, 2.5e-4);
}

}  // namespace
}  // namespace tyndall::stability
