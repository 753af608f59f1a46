// Sums the weights (one for each colour) of those points of a ray that see their light.
#pragma once

#include <array>

#include "occluders.hpp"

namespace tyndall::truth {

/// Collects shadow rays into packets of eight, which neighbouring points of one view ray suit well.
class ShadowRays {
 public:
  explicit ShadowRays(const Occluders& occluders);

  /// A ray from `point` (relative to the eye) along the unit vector `direction`, up to `distance` (may be infinite).
  /// `weight` counts if nothing is in between.
  void add(const glm::dvec3& point, const glm::dvec3& direction, double distance, const glm::dvec3& weight);

  /// The weights of all unoccluded rays since the last call.
  glm::dvec3 finish();

 private:
  static constexpr unsigned kWidth = 8;
  void trace();

  RTCScene tree_;
  bool empty_;  ///< nothing can occlude
  RTCIntersectContext context_;
  RTCRay8 rays_{};
  std::array<glm::dvec3, kWidth> weights_{};
  unsigned count_ = 0;
  glm::dvec3 sum_{0};
};

}  // namespace tyndall::truth
