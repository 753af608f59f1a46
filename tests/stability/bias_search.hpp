// The smallest safe moment bias, from the violations seen at a ladder of biases.
#pragma once

#include <array>
#include <cmath>

#include "distributions.hpp"
#include "moment_storage.hpp"
#include "report.hpp"

namespace tyndall::stability {

/// A bias of alpha mixes alpha of another distribution in, so exact bounds may miss the truth by alpha and by no more.
/// A case counts as safe up to that and 1e-4 (a fortieth of a step of an 8-bit picture).
inline constexpr double kSlack = 1e-4;

/// Violations at biases from 1/16 of the paper's to 64 times it, steps of the square root of two. A ladder and not a
/// bisection: at too small a bias the worst violation jumps up and down, and "safe" must hold for every larger bias
/// too.
class BiasLadder {
 public:
  explicit BiasLadder(const Format& format) : format_(format) {
    for (int i = 0; i < kSteps; ++i) alpha_[i] = static_cast<float>(format.paper * std::exp2(0.5 * i - 4));
  }
  void add(const Texel& texel, float zf, const Truth& truth) {
    // From the top down to the smallest that was still safe: what lies below is known to be unsafe.
    for (int i = kSteps - 1; i >= 0; --i) {
      const double low = visibility<float>(format_, texel, alpha_[i], zf, 0);
      const double high = visibility<float>(format_, texel, alpha_[i], zf, 1);
      if (!(low - truth.high <= alpha_[i] + kSlack && truth.low - high <= alpha_[i] + kSlack))
        safe_ = std::max(safe_, i + 1);
      if (i <= safe_) break;
    }
  }
  /// Not a number if even the largest was unsafe.
  double smallestSafe() const { return safe_ < kSteps ? static_cast<double>(alpha_[safe_]) : NAN; }

 private:
  static constexpr int kSteps = 21;
  Format format_;
  std::array<float, kSteps> alpha_{};
  int safe_ = 0;
};

}  // namespace tyndall::stability
