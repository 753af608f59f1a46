// Measures of the town, in metres: y up, the street runs along z towards the gate tower. The tests read them too.
#pragma once

#include <glm/glm.hpp>

namespace tyndall::levels::town {

inline constexpr float kFront = 4.3f;    ///< the houses' faces stand at x = -4.3 and +4.3, give or take 0.3
inline constexpr float kGround = 3.3f;   ///< height of a ground floor
inline constexpr float kStorey = 2.8f;   ///< of the floors above it
inline constexpr float kBay = 2.7f;      ///< distance of the windows
inline constexpr float kDepth = 4.0f;    ///< of the houses behind their faces
inline constexpr float kGateZ = -22.0f;  ///< face of the gate tower at the street's end
inline constexpr float kMoonElevation = 16.5f, kMoonAzimuth = 1.0f;  ///< degrees; azimuth from -z towards +x
inline constexpr glm::vec3 kLanternHook{0.35f, 5.2f, -4.2f};         ///< on the rope across the street
inline constexpr float kLanternDrop = 1.05f;                         ///< from the hook to the light

}  // namespace tyndall::levels::town
