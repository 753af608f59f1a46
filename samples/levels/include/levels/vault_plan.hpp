// Measures of the vault, in metres: y up, the crypt runs along z under a flat barrel vault. A well in the vault holds
// one lamp above a grating; a round window in the +x wall has the other lamp behind it. The tests read them too.
#pragma once

#include <glm/glm.hpp>

namespace tyndall::levels::vault {

inline constexpr float kHalfWidth = 4.5f;   ///< inner faces of the long walls at x = -4.5 and +4.5
inline constexpr float kHalfLength = 7.0f;  ///< inner faces of the end walls at z = -7 and +7
inline constexpr float kThickness = 0.6f;   ///< of all walls
inline constexpr float kSpring = 3.4f;      ///< where the vault leaves the long walls
inline constexpr float kApex = 5.0f;        ///< underside of the vault at x = 0
inline constexpr float kBay = 3.5f;         ///< distance of the ribs; four bays
inline constexpr float kWellHalf = 0.85f;   ///< the well is square, upright
inline constexpr float kWellZ = 1.75f;      ///< middle of the well, at x = 0
inline constexpr float kWellTop = 7.6f;
inline constexpr float kGratingY = 5.35f;  ///< of the bars in the well
inline constexpr float kFanY = 5.8f;       ///< of the blades behind them
inline constexpr float kWindowZ = -1.75f, kWindowY = 2.45f, kWindowRadius = 1.0f;
inline constexpr glm::vec3 kWellLamp{0.42f, 7.0f, 1.85f};       ///< the spot light behind the grating
inline constexpr glm::vec3 kWellAim{-1.33f, 0.0f, 1.60f};       ///< where its axis meets the floor
inline constexpr glm::vec3 kWindowLamp{7.9f, 3.3f, kWindowZ};   ///< the spot light with the rose window's picture
inline constexpr float kWellCone = 18.5f, kWindowCone = 14.0f;  ///< half angles, degrees

/// Underside of the vault above x: an arc of a circle through springs and apex.
inline float vaultY(float x) {
  constexpr float kRise = kApex - kSpring;
  constexpr float kRadius = (kHalfWidth * kHalfWidth + kRise * kRise) / (2 * kRise);
  return kApex - kRadius + glm::sqrt(kRadius * kRadius - x * x);
}

}  // namespace tyndall::levels::vault
