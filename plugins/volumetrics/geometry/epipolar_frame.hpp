// The epipolar frame of a directional light, fitted to the view (Peters et al. 2017, section 5.1.1 and appendix A).
// Deviation from appendix A, for accuracy: columns do not run from the eye to the far plane, but, slice by slice, over
// the part in which a light ray can be blocked at all (frustum and casters, both seen along the light); the rest is
// fully lit.
#pragma once

#include <array>
#include <optional>

#include <glm/glm.hpp>

#include "geometry/convex.hpp"
#include "stages/blocks.h"

namespace volumetrics {

using namespace tyndall::shared;

/// Slices uniform in azimuth, or evenly spaced along the screen's border.
enum class SliceSpacing { kAzimuth, kBorder };

struct RectificationInput {
  RayBlock rays;
  glm::vec3 towards;                       ///< unit, to the light
  std::array<glm::vec3, 8> casterCorners;  ///< box of all casters, world
  std::uint32_t columns = 1024, slices = 1024;
  SliceSpacing spacing = SliceSpacing::kAzimuth;
  bool wholeView = false;  ///< rows hold all that is seen, not only what can be blocked
  glm::vec3 coneAxis{0};   ///< unit, the way a spot light shines; zero: light goes everywhere
  float sinOuter = 0;      ///< of its cone's half angle
};

/// The azimuths about `towards` that a cone from a point on that axis reaches: `middle` is the cone's own azimuth as a
/// direction. Nothing: all of them, because the axis lies within the cone.
struct ConeSector {
  glm::dvec3 middle;  ///< unit, perpendicular to the axis
  double halfWidth;   ///< rad, below pi/2
};
std::optional<ConeSector> coneSector(const glm::dvec3& towards, const glm::dvec3& coneAxis, double sinOuter);

/// Corners of the frustum as directions of length one along the optical axis, in order round the screen.
std::array<glm::dvec3, 4> cornerDirections(const RayBlock& rays);
/// Inward normals of the frustum's side planes through cornerDirections().
std::array<glm::dvec3, 4> sidePlanes(const std::array<glm::dvec3, 4>& corners);
/// True if `direction` lies inside the side planes.
bool inFrustum(const std::array<glm::dvec3, 4>& planes, const glm::dvec3& direction);

/// Extreme inclinations over the frustum (appendix A): at corners, on edges of the far plane, or 0 and pi when the
/// light or its antipode is in view. Radians.
struct InclinationRange {
  double min = 0, max = 0;
};
InclinationRange inclinationRange(const RayBlock& rays, const glm::vec3& towards);

/// Section 5.1.1: the range of depths is stretched by 10 %, half of it at each end, against leaking there.
constexpr double kDepthGuard = 0.05;
/// Range of the normalised depth and the mean inclination.
void fillDepths(const RectificationInput& input, RectificationBlock& block);

/// What both rectifications share once e1 is chosen: basis, the frustum's side planes and the region in which light can
/// be blocked (as half-planes; its corners are returned, metres along e1 and e2 from the eye).
Polygon fillFrame(const RectificationInput& input, const glm::dvec3& e1, RectificationBlock& block);

/// The epipolar rectification. Everything but shadowAlong and the segments, which the caller sets.
RectificationBlock epipolarBlock(const RectificationInput& input);

}  // namespace volumetrics
