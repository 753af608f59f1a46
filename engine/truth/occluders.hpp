// The level as Embree sees it: every opaque and MASK triangle in one tree, with the eye at the origin, so that floats
// are finest where the picture is.
#pragma once

#include <deque>
#include <memory>
#include <optional>

#include <embree3/rtcore.h>
#include <glm/glm.hpp>

#include "base/result.hpp"
#include "mask.hpp"
#include "scene/scene.hpp"

namespace tyndall::truth {

/// Axis-aligned, relative to the eye.
struct Box {
  glm::dvec3 min{1e300};
  glm::dvec3 max{-1e300};
  bool empty() const { return min.x > max.x; }
};

class Occluders {
 public:
  /// `eye` in world space. The scene must outlive the object (masks point into it). `threads` 0: all cores.
  static Result<std::unique_ptr<Occluders>> build(const scene::Scene& scene, double seconds, const glm::dvec3& eye,
                                                  unsigned threads);
  ~Occluders();
  Occluders(const Occluders&) = delete;
  Occluders& operator=(const Occluders&) = delete;

  /// Distance of the first surface that a camera sees along the unit vector `direction` within (near, far). Back faces
  /// of single-sided materials are not seen.
  std::optional<double> firstSeen(const glm::dvec3& direction, double near, double far) const;

  /// All casters.
  const Box& bounds() const { return bounds_; }
  /// For shadow rays (rtcOccluded*): both sides of every surface that casts shadows occlude, masks are respected.
  RTCScene tree() const { return tree_; }

 private:
  struct Surface {
    std::optional<Mask> mask;
    bool singleSided = false;
    bool casts = true;      ///< shadows
    bool mirrored = false;  ///< by its node: the front is clockwise
  };
  Occluders() = default;
  bool add(const scene::Scene& scene, const scene::Primitive& primitive, const glm::dmat4& eyeFromMesh, bool casts);
  static void filterSeen(const RTCFilterFunctionNArguments* arguments);
  static void filterShadow(const RTCFilterFunctionNArguments* arguments);

  RTCDevice device_ = nullptr;
  RTCScene tree_ = nullptr;
  std::deque<Surface> surfaces_;  ///< addresses stay valid: Embree keeps them
  Box bounds_;
};

}  // namespace tyndall::truth
