// Distributions of blockers that put the reconstructions of visibility under stress, and depths of rays among them.
#pragma once

#include <array>
#include <vector>

#include "random.hpp"

namespace tyndall::stability {

/// Depths in [-1, 1] (floats, as the shaders see them) and shares that sum to 1.
struct Blockers {
  std::vector<float> z;
  std::vector<double> share;
};

enum class Kind {
  kFew,           ///< 1 to 16 anywhere, even or very uneven shares
  kSingle,        ///< one depth
  kNearlyEqual,   ///< 2 to 6 within 1e-1 to 1e-7 of each other
  kEnds,          ///< only -1 and 1: what clamping leaves (Peters et al. 2017, section 2.5)
  kClamped,       ///< many at the ends, some between
  kNearSingular,  ///< as few depths as make the Hankel matrix singular, and crumbs of 1e-2 to 1e-8 elsewhere
  kClusters,      ///< two to four clumps, each 1e-2 to 1e-6 wide
  kFoliage,       ///< 32 to 512 with heavy tails
  kCount
};

Blockers makeBlockers(Random& random, Kind kind);
inline Blockers makeBlockers(Random& random) {
  return makeBlockers(random, static_cast<Kind>(random.below(static_cast<int>(Kind::kCount))));
}

/// A ray's depth on a blocker, within 1e-4 to 1e-8 of one, between two, anywhere, at an end, or beyond all of them.
float rayDepth(Random& random, const std::vector<float>& z);

/// Visibility at a depth: the share strictly beyond it, and the share at or beyond it. A blocker at the ray's own depth
/// may count as either.
struct Truth {
  double low = 0, high = 0;
};
Truth visibilityAt(const Blockers& blockers, float zf);

/// Moments 0 to 6 in double: exact to 1e-15.
std::array<double, 7> momentsOf(const Blockers& blockers);

}  // namespace tyndall::stability
