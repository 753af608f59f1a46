#include "local_light.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tyndall::truth {
namespace {

/// Difference of the cosines of a cone with a hard edge, far below what double tells apart.
constexpr double kLeastFalloff = 1e-30;

/// Gauss-Legendre on [-1, 1], exact up to the fifth power: {place, weight}.
const std::array<std::array<double, 2>, 3> kGauss{
    {{-std::sqrt(0.6), 5.0 / 9.0}, {0.0, 8.0 / 9.0}, {std::sqrt(0.6), 5.0 / 9.0}}};

}  // namespace

LocalLight::LocalLight(const scene::Scene& scene, const scene::LightView& light, const glm::dvec3& eye)
    : position_(glm::dvec3(light.position) - eye),
      axis_(glm::normalize(glm::dvec3(light.direction))),
      image_(LightImage::of(scene, light, eye)) {
  if (light.light.range) range_ = double{*light.light.range};
  if (light.light.kind != scene::LightKind::kSpot) return;
  spot_ = true;
  cosOuter_ = std::cos(double{light.light.outerConeAngle});
  const double cosInner = std::cos(double{light.light.innerConeAngle});
  angleScale_ = 1 / std::max(cosInner - cosOuter_, kLeastFalloff);
}

double LocalLight::attenuation(double distance, double cosineToAxis) const {
  double value = 1 / (distance * distance);
  if (range_) {
    const double share = distance * distance / (*range_ * *range_);
    value *= std::clamp(1 - share * share, 0.0, 1.0);
  }
  if (spot_) {
    const double angular = std::clamp((cosineToAxis - cosOuter_) * angleScale_, 0.0, 1.0);
    value *= angular * angular;
  }
  return value;
}

std::optional<Interval> LocalLight::reached(const glm::dvec3& direction, double length) const {
  Interval part{0, length};
  const double middle = glm::dot(position_, direction);
  if (range_) {
    const double passSquared = glm::dot(position_, position_) - middle * middle;
    const double half = *range_ * *range_ - passSquared;
    if (half <= 0) return std::nullopt;
    part.begin = std::max(part.begin, middle - std::sqrt(half));
    part.end = std::min(part.end, middle + std::sqrt(half));
  }
  if (spot_ && part.begin < part.end) {
    // The cone's boundary: (w . axis)^2 = cos^2 |w|^2 for w = t direction - position. Its two roots cut the ray into at
    // most three pieces, of which at most one is inside, as the cone is convex (outer angle <= 90 degrees).
    const double c2 = cosOuter_ * cosOuter_;
    const double da = glm::dot(direction, axis_), pa = glm::dot(position_, axis_);
    const double a = da * da - c2, halfB = c2 * middle - da * pa, c = pa * pa - c2 * glm::dot(position_, position_);
    std::array<double, 4> cuts{part.begin, part.end, part.end, part.end};
    if (const double root = halfB * halfB - a * c; root >= 0) {
      // The stable pair of formulas; an infinite or undefined root (a = 0, or both 0) is no cut.
      const double q = -(halfB + std::copysign(std::sqrt(root), halfB));
      if (const double t = q / a; t > part.begin && t < part.end) cuts[1] = t;
      if (const double t = c / q; t > part.begin && t < part.end) cuts[2] = t;
    }
    std::sort(cuts.begin(), cuts.end());
    const Interval whole = part;
    part.end = part.begin;
    for (int i = 0; i < 3; ++i) {
      const Interval piece{cuts[i], cuts[i + 1]};
      const glm::dvec3 w = (piece.begin + piece.end) / 2 * direction - position_;
      if (piece.length() > 0 && glm::dot(w, axis_) > cosOuter_ * glm::length(w)) part = piece;
    }
    if (part.length() <= 0 && whole.length() > 0) return std::nullopt;
  }
  if (part.begin >= part.end) return std::nullopt;
  return part;
}

glm::dvec3 LocalLight::scatter(const glm::dvec3& direction, double length, const Medium& medium, std::uint32_t samples,
                               ShadowRays& rays) const {
  const auto part = reached(direction, length);
  if (!part) return glm::dvec3(0);
  const double closest = glm::dot(position_, direction);
  const double pass = std::max(glm::length(glm::cross(position_, direction)), kClosestPass);
  const double firstAngle = std::atan2(part->begin - closest, pass);
  const double lastAngle = std::atan2(part->end - closest, pass);
  const double half = (lastAngle - firstAngle) / (2.0 * samples);  // half a stratum, radians

  // The unshadowed integrand times dt/dangle = distance^2 / pass.
  const auto unshadowed = [&](double angle) {
    const double offset = pass * std::tan(angle);
    const double distance = std::sqrt(offset * offset + pass * pass);
    const double t = closest + offset;
    const double cosineToAxis = glm::dot(t * direction - position_, axis_) / distance;
    const double value = std::exp(-medium.sigma_t * (t + distance)) * phase(medium.g, -offset / distance) *
                         attenuation(distance, cosineToAxis) * distance * distance / pass;
    return image_ ? value * image_->colorTowards(t * direction) : glm::dvec3(value);
  };
  for (std::uint32_t i = 0; i < samples; ++i) {
    const double middle = firstAngle + (2.0 * i + 1) * half;
    glm::dvec3 weight(0);
    for (const auto& [place, share] : kGauss) weight += share * half * unshadowed(middle + place * half);
    const glm::dvec3 point = (closest + pass * std::tan(middle)) * direction;
    const glm::dvec3 toLight = position_ - point;
    const double distance = glm::length(toLight);
    rays.add(point, distance > 0 ? toLight / distance : direction, distance, weight);
  }
  return rays.finish();
}

}  // namespace tyndall::truth
