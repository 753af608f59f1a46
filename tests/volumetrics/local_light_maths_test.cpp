// What part of a ray a spot or point light reaches, and angles at the light: against sampling and against higher
// precision.
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "lib/cpp.hpp"
#include "shared/lamp.h"

using namespace tyndall::lib;

namespace {

struct Case {
  glm::dvec3 light, axis, direction, nearest;
  double outer, range, closest, pass, aim;
};

Case random(std::mt19937& source) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  const auto vector = [&] { return glm::dvec3(normal(source), normal(source), normal(source)); };
  Case c;
  c.light = 5.0 * vector();
  c.direction = glm::normalize(vector());
  c.outer = std::exp(std::lerp(std::log(1.7e-4), std::log(1.56), uniform(source)));  // 0.01 to 89 degrees
  // A narrow cone meets few rays: aimed to pass this point by half of its width.
  c.aim = 12 * uniform(source);
  c.axis = uniform(source) < 0.2
               ? glm::normalize(vector())
               : glm::normalize(glm::normalize(c.aim * c.direction - c.light) + 0.5 * c.outer * vector());
  // The engine's directions are floats.
  c.axis = glm::normalize(glm::dvec3(glm::vec3(c.axis)));
  c.range = uniform(source) < 0.5 ? 0 : 10 * uniform(source);
  c.closest = glm::dot(c.light, c.direction);
  c.nearest = c.closest * c.direction - c.light;
  c.pass = glm::length(c.nearest);
  return c;
}

template <class Real>
glm::vec<2, Real> reachedPart(const Case& c, double end) {
  using Vector = glm::vec<3, Real>;
  const glm::vec<2, Real> whole(-c.closest, end - c.closest);
  const Vector direction(c.direction), nearest(c.nearest), axis(c.axis);
  const auto cosine = static_cast<Real>(std::cos(c.outer)), sine = static_cast<Real>(std::sin(c.outer));
  if constexpr (std::is_same_v<Real, double>)
    return f64::clipToCone(f64::clipToRange(whole, c.pass, c.range), direction, nearest, axis, cosine, sine);
  else
    return f32::clipToCone(f32::clipToRange(whole, Real(c.pass), Real(c.range)), direction, nearest, axis, cosine,
                           sine);
}

// The inverse of the tables in Vulkan's "Cube Map Face Selection": from face and place back to the direction.
TEST(CubeMap, FaceAndPlaceGiveTheDirectionBack) {
  const auto direction = [](unsigned face, double s, double t) {
    switch (face) {
      case 0: return glm::dvec3(1, -t, -s);
      case 1: return glm::dvec3(-1, -t, s);
      case 2: return glm::dvec3(s, 1, t);
      case 3: return glm::dvec3(s, -1, -t);
      case 4: return glm::dvec3(s, -t, 1);
      default: return glm::dvec3(-s, -t, -1);
    }
  };
  for (unsigned face = 0; face < 6; ++face)
    for (const double s : {-0.9, -0.3, 0.0, 0.7})
      for (const double t : {-0.8, 0.1, 0.95}) {
        const glm::dvec3 d = 2.5 * direction(face, s, t);
        ASSERT_EQ(f64::cubeFace(d), face);
        const f64::Real4 place = f64::cubePlace(face, d);
        EXPECT_NEAR(place.w, 2.5, 1e-12);
        EXPECT_NEAR(place.x / place.w, s, 1e-12) << face;
        EXPECT_NEAR(-place.y / place.w, t, 1e-12) << face;
      }
}

}  // namespace

TEST(LocalLightMaths, ReachedPartIsWhatTheConeAndRangeHold) {
  std::mt19937 source(1);
  int lit = 0, wrong = 0, wrongFloat = 0, all = 0;
  for (int i = 0; i < 20000; ++i) {
    const Case c = random(source);
    const double end = 12;
    const glm::dvec2 part = reachedPart<double>(c, end);
    const glm::vec2 rough = reachedPart<float>(c, end);
    for (int k = 0; k < 50; ++k) {
      // Half of the points over the ray, half of them close to where the cone was aimed.
      const double beam = 4 * c.outer * glm::distance(c.aim * c.direction, c.light);
      const double t = k % 2 ? end * (k + 0.5) / 50 : c.aim + beam * (k / 25.0 - 1);
      if (t < 0 || t > end) continue;
      const double s = t - c.closest;
      const glm::dvec3 w = t * c.direction - c.light;
      const double angle = std::atan2(glm::length(glm::cross(w, c.axis)), glm::dot(w, c.axis));
      const double inRange = c.range == 0 ? 1 : c.range - glm::length(w);
      if (std::abs(angle / c.outer - 1) < 1e-4 || std::abs(inRange) < 1e-4) continue;
      const bool inside = angle < c.outer && inRange > 0;
      ++all;
      lit += inside;
      wrong += inside != (s > part.x && s < part.y);
      if (std::abs(angle / c.outer - 1) < 0.05) continue;
      wrongFloat += inside != (static_cast<float>(s) > rough.x && static_cast<float>(s) < rough.y);
    }
  }
  EXPECT_GT(lit, all / 50);
  EXPECT_EQ(wrong, 0);
  EXPECT_LE(wrongFloat, all / 10000) << all;
}

// Rays that no random case meets: along the axis, through the light, parallel to the cone's side.
TEST(LocalLightMaths, SpecialRaysThroughACone) {
  const f64::Real2 whole(-10, 10);
  const double c = std::cos(0.5), s = std::sin(0.5);
  const auto clipped = [&](const glm::dvec3& direction, const glm::dvec3& nearest) {
    return f64::clipToCone(whole, direction, nearest, {0, 0, 1}, c, s);
  };
  // Along the axis, 1 m beside it: inside from where the cone is 1 m wide.
  f64::Real2 part = clipped({0, 0, 1}, {1, 0, 0});
  EXPECT_NEAR(part.x, c / s, 1e-12);
  EXPECT_EQ(part.y, 10);
  part = clipped({0, 0, -1}, {1, 0, 0});
  EXPECT_EQ(part.x, -10);
  EXPECT_NEAR(part.y, -c / s, 1e-12);
  // Through the light itself, along and across the axis.
  part = clipped({0, 0, 1}, {0, 0, 0});
  EXPECT_NEAR(part.x, 0, 1e-12);
  EXPECT_EQ(part.y, 10);
  part = clipped({1, 0, 0}, {0, 0, 0});
  EXPECT_GE(part.x, part.y);
  // Across the axis 1 m before and behind the light.
  part = clipped({1, 0, 0}, {0, 0, 1});
  EXPECT_NEAR(part.x, -s / c, 1e-12);
  EXPECT_NEAR(part.y, s / c, 1e-12);
  part = clipped({1, 0, 0}, {0, 0, -1});
  EXPECT_GE(part.x, part.y);
  // Parallel to the side, met once, and everything ahead (behind) is inside; on the other side of the light, never.
  part = clipped({s, 0, c}, {-c, 0, s});
  EXPECT_NEAR(part.x, 1 / std::tan(1.0), 1e-12);
  EXPECT_EQ(part.y, 10);
  part = clipped({s, 0, -c}, {c, 0, s});
  EXPECT_EQ(part.x, -10);
  EXPECT_NEAR(part.y, -1 / std::tan(1.0), 1e-12);
  part = clipped({s, 0, -c}, {-c, 0, -s});
  EXPECT_GE(part.x, part.y);
  part = clipped({s, 0, c}, {c, 0, -s});
  EXPECT_GE(part.x, part.y);
  // Half a sphere ends at a plane.
  part = f64::clipToCone(whole, {0, 0, 1}, {1, 0, 0}, {0, 0, 1}, 0, 1);
  EXPECT_NEAR(part.x, 0, 1e-12);
  EXPECT_EQ(part.y, 10);
}

TEST(LocalLightMaths, AnglesKeepTheirDigits) {
  for (float pass : {1e-3f, 0.1f, 2.0f, 300.0f})
    for (float from : {-900.0f, -50.0f, -0.01f, 0.0f, 3.0f, 100.0f})
      for (float length : {0.01f, 1.0f, 500.0f}) {
        const float to = from + length;
        const auto exact = static_cast<double>(std::atan2(static_cast<long double>(to), pass) -
                                               std::atan2(static_cast<long double>(from), pass));
        // The pole is where the light is passed at a distance that rounding of `to` can exceed.
        EXPECT_NEAR(f32::angleBetween(pass, from, to), exact, 2e-6 * exact + 1e-7 * std::abs(from) / pass * exact)
            << pass << ' ' << from << ' ' << to;
      }
  for (float angle : {-0.2f, 1e-6f, 0.003f, 0.1f, 0.2499f, 0.2501f, 1.0f, 3.1f}) {
    const f32::Real2 turn = f32::turnBy(angle);
    EXPECT_NEAR(turn.x, std::cos(static_cast<double>(angle)), 1e-7) << angle;
    EXPECT_NEAR(turn.y, std::sin(static_cast<double>(angle)), 1e-7 * std::min(1.0f, 2 * std::abs(angle))) << angle;
  }
}

// Strata of equal angle, each turned on from the last in float, end where the ray does.
TEST(LocalLightMaths, TurningOnThroughAllStrataArrivesAtTheEnd) {
  for (const int steps : {1, 7, 64, 1024, 16384})
    for (float pass : {1e-3f, 0.5f, 20.0f}) {
      const float from = -7, to = 60;
      f32::Real2 at = glm::normalize(f32::Real2(to, pass));
      const f32::Real2 turn = f32::turnBy(f32::angleBetween(pass, from, to) / static_cast<float>(steps));
      for (int i = 0; i < steps; ++i) at = f32::turned(at, turn);
      const double arrived = std::atan2(at.y, at.x), wanted = std::atan2(pass, from);
      EXPECT_NEAR(arrived, wanted, 3e-5) << steps << ' ' << pass;
    }
}

// KHR_lights_punctual's formulas, written out in long double, against float: 0.01 degrees to half a sphere, on the
// axis, inside the inner cone, between both, outside; and a hard edge.
TEST(LocalLightMaths, AttenuationIsTheExtensionsForConesOfAnyWidth) {
  std::mt19937 source(5);
  std::normal_distribution<double> normal;
  const auto vector = [&] { return glm::dvec3(normal(source), normal(source), normal(source)); };
  constexpr double kRadians = std::numbers::pi / 180;
  for (const double outer : {0.01 * kRadians, 0.2 * kRadians, 1 * kRadians, 3 * kRadians, 0.6, 90 * kRadians})
    for (const double innerShare : {0.0, 0.5, 0.98, 1.0})
      for (const double share : {0.0, 0.3, 0.49, 0.75, 0.96, 1.04, 1.9})
        for (int i = 0; i < 20; ++i) {
          const double inner = innerShare * outer, angle = share * outer;
          const glm::vec3 axis(glm::normalize(vector()));
          const glm::dvec3 z = glm::normalize(glm::dvec3(axis)), x = glm::normalize(glm::cross(vector(), z));
          const glm::vec3 from(5.0 * (std::cos(angle) * z + std::sin(angle) * x));
          const tyndall::shared::ConeFalloff cone = tyndall::shared::coneFalloff(inner, outer);
          const float d2 = glm::dot(from, from);
          const float found =
              f32::localAttenuation(d2, 0, f32::versineToAxis(from, axis, d2, 0), cone.outer, cone.scale);
          const long double cosInner = std::cos(static_cast<long double>(inner)),
                            cosOuter = std::cos(static_cast<long double>(outer)),
                            cosine = std::cos(static_cast<long double>(angle));
          const long double linear = cosInner == cosOuter
                                         ? (cosine > cosOuter ? 1 : 0)
                                         : std::clamp((cosine - cosOuter) / (cosInner - cosOuter), 0.0L, 1.0L);
          // Directions as floats are off by 1e-7 rad or so: by the slope, which is 2 angle/(outer^2 - inner^2).
          const double slope = 2 * angle / std::max(outer * outer - inner * inner, 1e-12);
          EXPECT_NEAR(found, static_cast<double>(linear * linear), 1e-5 + 2 * slope * 2e-7)
              << outer / kRadians << " degrees, inner " << innerShare << ", at " << share;
        }
  EXPECT_EQ(f64::localAttenuation(4, 0, 0, 1, 1), 1) << "a point light";
  EXPECT_NEAR(f64::localAttenuation(4, 4, 0, 1, 1), 1 - std::pow(2.0 / 4, 4), 1e-14);
  EXPECT_EQ(f64::localAttenuation(25, 4, 0, 1, 1), 0);
}
