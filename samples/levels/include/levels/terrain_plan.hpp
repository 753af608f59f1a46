// Measures of the dale with the aqueduct, in metres: y up, the sun stands low over +x. The tests read them too.
#pragma once

#include <glm/glm.hpp>

namespace tyndall::levels::terrain {

inline constexpr float kHalfSize = 200.0f;  ///< the height field reaches from -200 m to 200 m in x and z
inline constexpr float kRidgeX = 30.0f;     ///< the ridge before the sun runs along z here
inline constexpr float kAqueductX = 27.0f;  ///< middle of the aqueduct, which fills the ridge's gap
inline constexpr float kBay = 7.0f;         ///< of its lower tier, along z
inline constexpr int kBays = 9;             ///< of the lower tier; the upper has twice as many
inline constexpr float kLowerTop = 9.6f, kUpperTop = 13.6f;         ///< of the two tiers
inline constexpr float kSunElevation = 12.0f, kSunAzimuth = 14.0f;  ///< degrees; azimuth from +x towards -z

/// The ground's height; the height field's triangles lie within decimetres of it near the middle.
float groundY(float x, float z);

}  // namespace tyndall::levels::terrain
