// Measures of the store room with the cage, in metres: y up, the room runs along z. The tests read them too.
#pragma once

#include <glm/glm.hpp>

namespace tyndall::levels::cage {

inline constexpr float kHalfWidth = 6.0f;              ///< inner faces of the long walls at x = -6 and +6
inline constexpr float kHalfLength = 7.5f;             ///< inner faces of the end walls at z = -7.5 and +7.5
inline constexpr float kCeiling = 5.2f;                ///< underside of the ceiling's boards
inline constexpr float kThickness = 0.5f;              ///< of walls, floor and ceiling
inline constexpr float kDeck = 2.8f;                   ///< top of the loft at the -z end
inline constexpr float kLoftZ = -4.1f;                 ///< its front edge
inline constexpr float kLoftX = 1.9f;                  ///< it reaches from the -x wall to here
inline constexpr glm::vec3 kPivot{0.3f, 4.72f, 0.2f};  ///< the hook that the lamp swings from
inline constexpr float kDrop = 1.55f;                  ///< from the hook to the light
inline constexpr float kCageRadius = 0.36f;            ///< the widest ring's, about the light
inline constexpr float kCageHalf = 0.42f;              ///< from the light to the upper and lower ring
inline constexpr glm::vec3 kStove{4.5f, 0.0f, -6.1f};  ///< middle of the stove's foot; the light is kEmbers above
inline constexpr float kEmbers = 0.66f;

}  // namespace tyndall::levels::cage
