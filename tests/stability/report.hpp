// The stress table: a test adds its rows, the program's end prints them.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>

namespace tyndall::stability {

struct Row {
  std::string routine;
  std::string precision;  ///< of what is stored, or of the numbers
  std::uint64_t cases = 0;
  double error = NAN;        ///< worst, float (or the device) against long double on the same input
  double doubleError = NAN;  ///< the same of double
  double violation = NAN;    ///< worst of (lower bound - truth, truth - upper bound, error - its proven bound)
  double safeBias = NAN;     ///< smallest found
  double paperBias = NAN;
  double bias = NAN;  ///< the one used
};

/// Adds a row to the table that is printed (Markdown) when the program ends.
void report(const Row& row);

/// Cases of one run over all routines: 10^6, or TYNDALL_STRESS_CASES.
std::uint64_t stressCases();
/// The part of stressCases() that one routine gets.
inline std::uint64_t shareOfCases(double share) {
  return static_cast<std::uint64_t>(static_cast<double>(stressCases()) * share) + 1;
}

/// The larger, and not-a-number if either is (std::max would lose it).
inline void raise(double& worst, double value) {
  if (!(value <= worst)) worst = value;
}

}  // namespace tyndall::stability
