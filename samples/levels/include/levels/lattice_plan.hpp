// Measures of the shed, in metres: y up, it runs along z, and the sun stands low beyond its -z end. The tests read
// them too.
#pragma once

#include <glm/glm.hpp>

namespace tyndall::levels::lattice {

inline constexpr float kHalfWidth = 9.0f;    ///< inner faces of the long walls at x = -9 and +9
inline constexpr float kHalfLength = 12.0f;  ///< inner faces of the end walls at z = -12 and +12
inline constexpr float kCeiling = 7.0f;      ///< underside of the roof
inline constexpr float kBay = 3.6f;          ///< the sunny end's posts; five bays
inline constexpr float kFenceTop = 3.8f;     ///< of the fence below the sheets of that end
inline constexpr float kFanY = 5.45f, kFanRadius = 1.1f;
inline constexpr float kCageX = 2.2f, kCageZ = 6.0f,
                       kCageTop = 3.4f;                 ///< the fenced court: x above kCageX, z below kCageZ
inline constexpr float kMesh = 0.16f;                   ///< side to side of the fence's diamonds, metres
inline constexpr glm::vec3 kTower{-4.6f, 0.0f, -4.2f};  ///< middle of the lattice tower's foot
inline constexpr float kTowerHalf = 1.05f;
inline constexpr glm::vec3 kTowerLamp{-4.55f, 5.15f, -4.3f};
inline constexpr glm::vec3 kTripodLamp{3.75f, 1.75f, -0.9f};
inline constexpr float kSunElevation = 17.0f, kSunAzimuth = 11.0f;  ///< degrees; azimuth from -z towards +x

}  // namespace tyndall::levels::lattice
