// The epipolar frame of a directional light, fitted to the view (Peters et al. 2017, section 5.1.1 and appendix A).
// Deviation from appendix A, for accuracy: columns do not run from the eye to the far plane, but, slice by slice, over the
// part in which a light ray can be blocked at all (frustum and casters, both seen along the light); the rest is fully lit.
#pragma once

#include <array>

#include <glm/glm.hpp>

#include "stages/blocks.h"

namespace volumetrics {

using namespace tyndall::shared;

struct EpipolarInput {
  RayBlock rays;
  glm::vec3 towards;                          ///< unit, to the light
  std::array<glm::vec3, 8> casterCorners;     ///< box of all casters, world
  std::uint32_t columns = 1024, slices = 1024;
};

/// Extreme inclinations over the frustum (appendix A): at corners, on edges of the far plane, or 0 and pi when the light or its
/// antipode is in view. Radians.
struct InclinationRange {
  double min = 0, max = 0;
};
InclinationRange inclinationRange(const RayBlock& rays, const glm::vec3& towards);

/// Everything but shadowAlong, which the caller sets from the light's map.
EpipolarBlock epipolarBlock(const EpipolarInput& input);

}  // namespace volumetrics
