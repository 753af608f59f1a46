// What part of a ray a spot or point light reaches, and angles at the light: against sampling and against higher
// precision.
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "lib/cpp.hpp"

using namespace tyndall::lib;

namespace {

struct Case {
  glm::dvec3 light, axis, direction;
  double cosOuter, range, closest, pass, along, across;
};

Case random(std::mt19937& source) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  const auto vector = [&] { return glm::dvec3(normal(source), normal(source), normal(source)); };
  Case c;
  c.light = 5.0 * vector();
  c.axis = glm::normalize(vector());
  c.direction = glm::normalize(vector());
  c.cosOuter = std::cos(0.01 + 1.55 * uniform(source));
  c.range = uniform(source) < 0.5 ? 0 : 10 * uniform(source);
  c.closest = glm::dot(c.light, c.direction);
  const glm::dvec3 nearest = c.closest * c.direction - c.light;
  c.pass = glm::length(nearest);
  c.along = glm::dot(c.direction, c.axis);
  c.across = glm::dot(nearest, c.axis);
  return c;
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
    const f64::Real2 whole(-c.closest, end - c.closest);
    const f64::Real2 part =
        f64::clipToCone(f64::clipToRange(whole, c.pass, c.range), c.pass, c.along, c.across, c.cosOuter);
    const f32::Real2 rough = f32::clipToCone(f32::clipToRange(f32::Real2(whole), float(c.pass), float(c.range)),
                                             float(c.pass), float(c.along), float(c.across), float(c.cosOuter));
    for (int k = 0; k < 50; ++k) {
      const double t = end * (k + 0.5) / 50, s = t - c.closest;
      const glm::dvec3 w = t * c.direction - c.light;
      const double margin = glm::dot(w, c.axis) - c.cosOuter * glm::length(w);
      const double inRange = c.range == 0 ? 1 : c.range - glm::length(w);
      if (std::abs(margin) < 1e-4 || std::abs(inRange) < 1e-4) continue;
      const bool inside = margin > 0 && inRange > 0;
      ++all;
      lit += inside;
      wrong += inside != (s > part.x && s < part.y);
      wrongFloat += inside != (s > rough.x && s < rough.y);
    }
  }
  EXPECT_GT(lit, all / 50);
  EXPECT_EQ(wrong, 0);
  EXPECT_LE(wrongFloat, all / 100000) << all;
}

// Rays that no random case meets: along the axis, through the light, parallel to the cone's side.
TEST(LocalLightMaths, SpecialRaysThroughACone) {
  const f64::Real2 whole(-10, 10);
  const double c = std::cos(0.5), s = std::sin(0.5);
  // Along the axis, 1 m beside it: inside from where the cone is 1 m wide.
  f64::Real2 part = f64::clipToCone(whole, 1, 1, 0, c);
  EXPECT_NEAR(part.x, c / s, 1e-12);
  EXPECT_EQ(part.y, 10);
  part = f64::clipToCone(whole, 1, -1, 0, c);
  EXPECT_EQ(part.x, -10);
  EXPECT_NEAR(part.y, -c / s, 1e-12);
  // Through the light itself, along and across the axis.
  part = f64::clipToCone(whole, 0, 1, 0, c);
  EXPECT_NEAR(part.x, 0, 1e-12);
  EXPECT_EQ(part.y, 10);
  part = f64::clipToCone(whole, 0, 0, 0, c);
  EXPECT_GE(part.x, part.y);
  // Across the axis 1 m before and behind the light.
  part = f64::clipToCone(whole, 1, 0, 1, c);
  EXPECT_NEAR(part.x, -s / c, 1e-12);
  EXPECT_NEAR(part.y, s / c, 1e-12);
  part = f64::clipToCone(whole, 1, 0, -1, c);
  EXPECT_GE(part.x, part.y);
  // Parallel to the side (along = cos), met once, and everything ahead (behind) is inside; on the other side of the
  // light, never.
  part = f64::clipToCone(whole, 1, c, s, c);
  EXPECT_NEAR(part.x, 1 / std::tan(1.0), 1e-12);
  EXPECT_EQ(part.y, 10);
  part = f64::clipToCone(whole, 1, -c, s, c);
  EXPECT_EQ(part.x, -10);
  EXPECT_NEAR(part.y, -1 / std::tan(1.0), 1e-12);
  part = f64::clipToCone(whole, 1, -c, -s, c);
  EXPECT_GE(part.x, part.y);
  part = f64::clipToCone(whole, 1, c, -s, c);
  EXPECT_GE(part.x, part.y);
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

// KHR_lights_punctual's formulas, written out.
TEST(LocalLightMaths, AttenuationIsTheExtensions) {
  const double inner = 0.3, outer = 0.6;
  const double scale = 1 / std::max(0.001, std::cos(inner) - std::cos(outer)), offset = -std::cos(outer) * scale;
  EXPECT_EQ(f64::localAttenuation(4, 0, -1, 0, 1), 1);
  EXPECT_NEAR(f64::localAttenuation(4, 4, -1, 0, 1), 1 - std::pow(2.0 / 4, 4), 1e-14);
  EXPECT_EQ(f64::localAttenuation(25, 4, -1, 0, 1), 0);
  EXPECT_EQ(f64::localAttenuation(1, 0, std::cos(0.2), scale, offset), 1);
  EXPECT_EQ(f64::localAttenuation(1, 0, std::cos(0.7), scale, offset), 0);
  const double share = (std::cos(0.45) - std::cos(outer)) / (std::cos(inner) - std::cos(outer));
  EXPECT_NEAR(f64::localAttenuation(1, 0, std::cos(0.45), scale, offset), share * share, 1e-12);
}
