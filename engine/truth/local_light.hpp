// Light from a spot or point light scattered into one view ray.
#pragma once

#include <optional>

#include "cookie.hpp"
#include "medium.hpp"
#include "shadow_rays.hpp"
#include "truth/truth.hpp"

namespace tyndall::truth {

/// The integral diverges for a view ray that goes exactly through a point light; a ray that passes closer than this
/// counts as passing at this distance, metres.
inline constexpr double kClosestPass = 1e-3;

/// KHR_lights_punctual, relative to the eye. Its candela are left out.
class LocalLight {
 public:
  LocalLight(const scene::Scene& scene, const scene::LightView& light, const glm::dvec3& eye);

  /// Integral of exp(-sigma_t (t + d)) p V a dt over [0, length], in 1/(m sr), where d is the distance to the light and
  /// a its attenuation and its image's colour: times sigma_s and the candela it is the radiance. Strata of equal angle
  /// as seen from the light (Kulla and Fajardo 2012, "Importance Sampling Techniques for Path Tracing in Participating
  /// Media"), each weighted by Gaussian quadrature of the unshadowed integrand and counted if its middle sees the
  /// light.
  glm::dvec3 scatter(const glm::dvec3& direction, double length, const Medium& medium, std::uint32_t samples,
                     ShadowRays& rays) const;

  /// The part of the ray that the light's range and cone reach.
  std::optional<Interval> reached(const glm::dvec3& direction, double length) const;

 private:
  double attenuation(double distance, double cosineToAxis) const;

  glm::dvec3 position_;
  glm::dvec3 axis_;
  std::optional<double> range_;
  std::optional<LightImage> image_;
  bool spot_ = false;
  double cosOuter_ = -1;
  double angleScale_ = 0;  ///< the extension's lightAngleScale
};

}  // namespace tyndall::truth
