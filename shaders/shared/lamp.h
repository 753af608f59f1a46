// What the engine and its plugins both make of a spot or point light (KHR_lights_punctual).
// The cone is kept as 1 - cos(angle) = 2 sin^2(angle/2), not as the cosine, which has no digits left for narrow cones:
// a float's cosine knows 0.01 degrees from 0 by a quarter of its last digit.
#ifndef TYNDALL_SHARED_LAMP_H
#define TYNDALL_SHARED_LAMP_H
#include "shared/types.h"

#ifdef __cplusplus
#include <algorithm>
#include <cmath>
#define TY_LAMP_CONSTANT inline constexpr
#else
#define TY_LAMP_CONSTANT const
#endif
TY_SHARED_BEGIN

// The inverse square ends here, m: a surface nearer to a lamp counts as being this far off, a view ray that passes
// nearer as passing at this distance (docs/conventions.md, "Near a lamp"). Without it light at the lamp itself would be
// infinite.
TY_LAMP_CONSTANT float kLeastLampDistance = 1e-3f;

#ifdef __cplusplus
/// 1 - cos(angle), radians.
inline double versine(double angle) { return 2 * std::sin(angle / 2) * std::sin(angle / 2); }

/// The cone's falloff: ((outer - versine of the angle to the axis) * scale), clamped to [0, 1] and squared.
struct ConeFalloff {
  float outer = 1, scale = 1;  ///< of a point light, whose angle counts as 0: everywhere 1
};
/// 0 <= inner <= outer <= pi/2. Equal angles make a hard edge; the scale stays finite.
inline ConeFalloff coneFalloff(double inner, double outer) {
  return {static_cast<float>(versine(outer)), static_cast<float>(1 / std::max(1e-30, versine(outer) - versine(inner)))};
}
#endif

TY_SHARED_END
#undef TY_LAMP_CONSTANT
#endif
