// Measures of the hall, in metres: y up, the hall runs along z, the sun stands beyond +x. The tests use the openings
// to tell a leak in the shell from a window.
#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace tyndall::levels::hall {

inline constexpr float kHalfWidth = 7.0f;    ///< inner faces of the long walls at x = -7 and +7
inline constexpr float kHalfLength = 20.0f;  ///< inner faces of the end walls at z = -20 and +20
inline constexpr float kThickness = 0.6f;    ///< of all walls
inline constexpr float kWallTop = 9.2f;      ///< of the long walls, inside the roof slab
inline constexpr float kRidge = 12.4f;       ///< underside of the roof at x = 0
inline constexpr float kRoofSlope = 0.466f;  ///< fall of the roof per metre of x (25 degrees)
inline constexpr float kBay = 5.0f;          ///< distance of pillars, trusses and windows
inline constexpr int kBays = 8;
inline constexpr float kPillarX = 4.0f;
inline constexpr float kTieY = 8.35f;          ///< axis of the tie beams
inline constexpr float kGalleryZ = 15.7f;      ///< front edge of the gallery at the +z end
inline constexpr float kGalleryY = 4.0f;       ///< its deck
inline constexpr float kSunElevation = 30.0f;  ///< degrees
inline constexpr float kSunSlant = 19.0f;  ///< degrees between the sun's azimuth and the windows' normal (towards -z)

/// Underside of the roof above x.
inline float roofY(float x) { return kRidge - kRoofSlope * (x < 0 ? -x : x); }
/// z of the middle of bay 0..7; bay 0 lies at the -z end.
inline float bayZ(int bay) { return -kHalfLength + kBay * (static_cast<float>(bay) + 0.5f); }

/// Where light and view rays may leave: an axis-aligned box that holds the hole in the wall, from face to face.
struct Opening {
  glm::vec3 min, max;
};
std::vector<Opening> openings();

}  // namespace tyndall::levels::hall
