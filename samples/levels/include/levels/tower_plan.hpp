// Measures of the bell tower and its square, in metres: y up, the tower's middle at the origin, the sun behind it (-z)
// for whoever stands on the square (+z). The tests read them too.
#pragma once

#include <glm/glm.hpp>

namespace tyndall::levels::tower {

inline constexpr float kHalf = 2.7f;                         ///< outer faces of the tower at x and z = -2.7 and 2.7
inline constexpr float kBelfry = 10.0f, kBelfryTop = 15.8f;  ///< floor and ceiling of the open storey
inline constexpr float kSill = 10.6f, kSpring = 13.0f;       ///< of its openings, one on each side
inline constexpr float kOpeningHalf = 1.25f;                 ///< half their width; their arches are equilateral
inline constexpr float kSpire = 26.5f;                       ///< tip of the spire
inline constexpr glm::vec3 kPivot{0.0f, 14.7f, 0.0f};        ///< the bell swings about this
inline constexpr float kSunElevation = 20.0f, kSunAzimuth = 84.0f;  ///< degrees; azimuth from +x towards -z

}  // namespace tyndall::levels::tower
