// A query's walk through the wavelet matrix of a row, step by step, from what the debug views with the roles
// TY_VIEW_WALK_* hold (Claude, Navarro, Ordonez 2015, "The wavelet matrix"; shaders/lib/wavelet.glsl). Needs no window.
#pragma once

#include <cstdint>
#include <vector>

namespace tyndall::editor {

/// The maps of one slice.
struct WalkRow {
  struct Texel {
    float zeros = 0;  ///< elements of the node up to here that go on into its first half
    float share = 0;  ///< of their weight
  };
  std::vector<float> before;  ///< by bin of the depth, and one more: how many of the row's depths lie before it
  std::vector<std::vector<Texel>> levels;  ///< by level, then by position; 2^n positions
};

struct WalkStep {
  std::uint32_t first = 0, last = 0;  ///< ranks of the node: [first, last)
  std::uint32_t elements = 0;         ///< of the row's first columns that are in the node
  std::uint32_t zeros = 0;            ///< of those: in its first half
  float share = 0;                    ///< of their weight
  bool second = false;                ///< the walk goes on in the second half: the first lies before the ray
  double blocked = 0, undecided = 0;  ///< after the step, shares of the weight of all columns asked for
};

struct Walk {
  double rank = 0;             ///< of the ray's depth among those of the row
  std::uint32_t elements = 0;  ///< columns asked for, from the eye on
  std::vector<WalkStep> steps;
  std::uint32_t blockers = 0;  ///< columns found to be blocked before the ray
  std::uint32_t left = 0;      ///< columns of ranks that the last node does not tell apart
  double blocked = 0;          ///< share of the weight
};

/// The first `elements` columns of the row, asked which of their blockers lie before `depth`.
Walk walkOf(const WalkRow& row, std::uint32_t elements, float depth);

}  // namespace tyndall::editor
