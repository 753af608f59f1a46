#include "shadow_rays.hpp"

#include <algorithm>
#include <cmath>

namespace tyndall::truth {
namespace {

/// Points are rounded to float (2^-24 of their coordinates), and so may slip behind the surface on which they end:
/// rays start and stop this share of the coordinates before what they touch.
constexpr double kRelativeBias = 0x1p-21;

}  // namespace

ShadowRays::ShadowRays(const Occluders& occluders) : tree_(occluders.tree()), empty_(occluders.bounds().empty()) {
  rtcInitIntersectContext(&context_);
  context_.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  std::fill(std::begin(rays_.mask), std::end(rays_.mask), ~0u);
}

void ShadowRays::add(const glm::dvec3& point, const glm::dvec3& direction, double distance, const glm::dvec3& weight) {
  if (weight == glm::dvec3(0)) return;
  const double bias = kRelativeBias * std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
  if (empty_ || distance <= 2 * bias) {
    sum_ += weight;
    return;
  }
  const unsigned i = count_++;
  rays_.org_x[i] = static_cast<float>(point.x);
  rays_.org_y[i] = static_cast<float>(point.y);
  rays_.org_z[i] = static_cast<float>(point.z);
  rays_.dir_x[i] = static_cast<float>(direction.x);
  rays_.dir_y[i] = static_cast<float>(direction.y);
  rays_.dir_z[i] = static_cast<float>(direction.z);
  rays_.tnear[i] = static_cast<float>(bias);
  rays_.tfar[i] = static_cast<float>(distance - bias);
  weights_[i] = weight;
  if (count_ == kWidth) trace();
}

glm::dvec3 ShadowRays::finish() {
  if (count_ > 0) trace();
  const glm::dvec3 sum = sum_;
  sum_ = glm::dvec3(0);
  return sum;
}

void ShadowRays::trace() {
  alignas(32) int valid[kWidth];
  for (unsigned i = 0; i < kWidth; ++i) valid[i] = i < count_ ? -1 : 0;
  rtcOccluded8(valid, tree_, &context_, &rays_);
  // Embree sets tfar to minus infinity where something is in between.
  for (unsigned i = 0; i < count_; ++i)
    if (rays_.tfar[i] >= 0) sum_ += weights_[i];
  count_ = 0;
}

}  // namespace tyndall::truth
