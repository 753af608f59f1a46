// How the prefix of moments is stored, by number of moments and precision, with the bias each needs (Peters et al.
// 2017, sections 2.4, 2.5 and 5.4.3).
#pragma once

#include "params/table.hpp"
#include "stages/rectify.hpp"
#include "tyndall/plugin.h"

namespace volumetrics {

struct MomentStorage {
  TyFormat first;      ///< four moments; or b1 b3 b5 (and b2)
  TyFormat second;     ///< TY_FORMAT_UNKNOWN for four moments; else b2 b4 b6, or b4 b6
  DepthBits depth;     ///< of the rectified map
  bool quantise;       ///< through the sparse quantisation transform
  bool threeAndThree;  ///< odd moments in `first`, even ones in `second`
  float bias;          ///< moment bias alpha_b
  float evenTarget;    ///< bias vector of four moments: (0, x, 0, x)
  bool compensated;    ///< averaged by lib/average.glsl: the drift of plain averages would outweigh the bias
};

/// `moments` is 4 or 6. The biases are those of the paper, each at most 2.5 times the smallest that the stress test
/// finds safe (docs/results/stress.md). Deviation: four moments in 32-bit float use 1e-6, not 3e-7. With 3e-7 rounding
/// the moments to float alone breaks the bounds by up to 0.4 where blockers lie close together; from 6e-7 on it does
/// not, and a device's arithmetic and filter get the rest. Six in 32-bit float use 1e-5, not 5e-6: of 10^8 cases some
/// need 7.1e-6, and at 5e-6 miss by up to 1.
constexpr MomentStorage momentStorage(int moments, Precision precision) {
  if (moments == 4) {
    if (precision == Precision::kCompact)
      return {TY_FORMAT_RGBA16_UNORM, TY_FORMAT_UNKNOWN, DepthBits::k16, true, false, 6e-5f, 0.628f, true};
    return {TY_FORMAT_RGBA32_FLOAT, TY_FORMAT_UNKNOWN, DepthBits::k32, false, false, 1e-6f, 0.375f, true};
  }
  switch (precision) {
    case Precision::kCompact:
      return {TY_FORMAT_A2B10G10R10_UNORM, TY_FORMAT_A2B10G10R10_UNORM, DepthBits::k16, true, true, 4e-3f, 0, false};
    case Precision::kStandard:
      return {TY_FORMAT_RGBA16_UNORM, TY_FORMAT_RG16_UNORM, DepthBits::k16, true, false, 8e-5f, 0, true};
    case Precision::kFull: break;
  }
  return {TY_FORMAT_RGBA32_FLOAT, TY_FORMAT_RG32_FLOAT, DepthBits::k32, false, false, 1e-5f, 0, true};
}

}  // namespace volumetrics
