// Light from a directional light scattered into one view ray.
#pragma once

#include <optional>

#include "cookie.hpp"
#include "medium.hpp"
#include "shadow_rays.hpp"
#include "truth/truth.hpp"

namespace tyndall::truth {

/// The part of the ray, from the eye up to `length` metres, that can lie in the shadow of anything inside `casters`:
/// where it meets the box swept along `travel` (unit, the way the light goes). None when it never does.
std::optional<Interval> shadowable(const Box& casters, const glm::dvec3& travel, const glm::dvec3& direction,
                                   double length);

/// Integral of exp(-sigma_t t) p V dt over [0, length], in m/sr: times sigma_s and the irradiance it is the radiance.
/// The lit ends are closed forms; the shadowable part is cut into `samples` strata of equal weight, each of which
/// counts if its middle (in transmittance) sees the sun. With an image (null: none) all parts are cut so, and the image
/// is looked up at the middles.
glm::dvec3 sunScatter(const glm::dvec3& travel, const LightImage* image, const glm::dvec3& direction, double length,
                      const Medium& medium, const Box& casters, std::uint32_t samples, ShadowRays& rays);

}  // namespace tyndall::truth
