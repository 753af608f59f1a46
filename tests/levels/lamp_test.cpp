// The lamps of vault and cage: kinds and values, and that they are shadowed by what is built around them, in part.
#include <algorithm>

#include <gtest/gtest.h>

#include "levels/cage_plan.hpp"
#include "levels/lattice_plan.hpp"
#include "levels/levels.hpp"
#include "levels/town_plan.hpp"
#include "levels/vault_plan.hpp"
#include "triangles.hpp"

namespace tyndall::levels {
namespace {

std::vector<scene::LightView> lightsOf(const scene::Scene& scene, double seconds = 0) {
  return scene::placedLights(scene, seconds);
}

/// A direction within `angle` of the axis, uniform over the solid angle.
glm::vec3 withinCone(TestRandom& random, const glm::vec3& axis, float angle) {
  for (;;) {
    const glm::vec3 d = glm::normalize(axis + 2.0f * glm::tan(angle) * random.direction());
    if (glm::dot(d, axis) > glm::cos(angle)) return d;
  }
}

/// Share of rays from the light that pass everything up to `reach` metres.
template <class Direction>
float passing(const std::vector<Triangle>& triangles, const glm::vec3& from, float reach, Direction direction) {
  constexpr int kRays = 3000;
  int passed = 0;
  for (int i = 0; i < kRays; ++i) {
    const std::optional<float> hit = nearest(triangles, from, direction());
    passed += hit && *hit < reach ? 0 : 1;
  }
  return static_cast<float>(passed) / kRays;
}

auto named(std::initializer_list<const char*> names) {
  return [list = std::vector<std::string>(names.begin(), names.end())](const scene::Node& node) {
    return std::find(list.begin(), list.end(), node.name) != list.end();
  };
}

TEST(VaultLamps, AreTwoSpotsOneWithACookie) {
  const scene::Scene scene = makeVault();
  const std::vector<scene::LightView> lights = lightsOf(scene);
  ASSERT_EQ(lights.size(), 2u);
  for (const scene::LightView& view : lights) {
    EXPECT_EQ(view.light.kind, scene::LightKind::kSpot);
    EXPECT_LT(view.light.innerConeAngle, view.light.outerConeAngle);
    EXPECT_TRUE(view.light.range);
  }
  EXPECT_FALSE(lights[0].light.cookie);
  ASSERT_TRUE(lights[1].light.cookie);
  const scene::Image& image = scene.images.at(scene.textures.at(lights[1].light.cookie->texture).image);
  EXPECT_GE(image.width, 512u);
  EXPECT_EQ(image.width, image.height);  // it spans a round cone
  // Coloured panes within the circle, black leads between, nothing outside.
  int black = 0, coloured = 0, inside = 0;
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; ++x) {
      const std::uint8_t* p = &image.rgba[(std::size_t{y} * image.width + x) * 4];
      const glm::vec2 at = (glm::vec2(x, y) + 0.5f) * (2.0f / static_cast<float>(image.width)) - 1.0f;
      const int most = std::max({p[0], p[1], p[2]}), least = std::min({p[0], p[1], p[2]});
      if (glm::length(at) > 1.0f) {
        EXPECT_EQ(most, 0);
        continue;
      }
      ++inside;
      black += most < 24 ? 1 : 0;
      coloured += most - least > 60 ? 1 : 0;
    }
  }
  EXPECT_GT(coloured, inside / 2);
  EXPECT_GT(black, inside / 20);
  EXPECT_LT(black, inside / 2);
}

TEST(VaultLamps, GratingAndFanLetPartOfTheLightThrough) {
  const scene::Scene scene = makeVault();
  const auto lights = lightsOf(scene);
  TestRandom random(5);
  const auto cone = [&] { return withinCone(random, lights[0].direction, lights[0].light.outerConeAngle); };
  const float reach = vault::kWellLamp.y - vault::kApex + 0.2f;
  const float bars = passing(trianglesOf(scene, 0, named({"grating"})), lights[0].position, reach, cone);
  EXPECT_GT(bars, 0.5f);
  EXPECT_LT(bars, 0.9f);
  float sum = 0;
  for (const double seconds : {0.0, 0.7, 1.5, 2.2}) {
    const auto column = named({"grating", "fan", "fan stand", "chain", "well", "well lamp"});
    const float all = passing(trianglesOf(scene, seconds, column), lights[0].position, reach, cone);
    EXPECT_GT(all, 0.3f) << seconds;
    EXPECT_LT(all, 0.9f) << seconds;
    sum += all;
  }
  EXPECT_LT(sum, 4 * bars);  // the fan takes its part
}

TEST(VaultLamps, TheWindowLetsItsWholePictureThrough) {
  const scene::Scene scene = makeVault();
  const auto lights = lightsOf(scene);
  const std::vector<Triangle> triangles = trianglesOf(scene);
  TestRandom random(6);
  const float inner = passing(triangles, lights[1].position, 5.0f, [&] {
    return withinCone(random, lights[1].direction, glm::radians(vault::kWindowCone));
  });
  EXPECT_GT(inner, 0.99f);
  // And it ends in the room, on walls and floor, not in the chamber.
  const std::optional<float> hit = nearest(triangles, lights[1].position, lights[1].direction);
  ASSERT_TRUE(hit);
  EXPECT_GT(*hit, 8.0f);
}

TEST(CageLamps, AreTwoPointLightsWithARange) {
  const auto lights = lightsOf(makeCage());
  ASSERT_EQ(lights.size(), 2u);
  for (const scene::LightView& view : lights) {
    EXPECT_EQ(view.light.kind, scene::LightKind::kPoint);
    EXPECT_TRUE(view.light.range);
  }
  EXPECT_GT(lights[0].light.intensity, lights[1].light.intensity);
  EXPECT_GT(lights[1].light.color.r, 3 * lights[1].light.color.g);  // embers
}

TEST(CageLamps, TheCageThrowsShadowsAllAround) {
  const scene::Scene scene = makeCage();
  const auto lights = lightsOf(scene);
  const std::vector<Triangle> lamp = trianglesOf(scene, 0, named({"caged lamp"}));
  TestRandom random(7);
  const float all = passing(lamp, lights[0].position, 1.0f, [&] { return random.direction(); });
  EXPECT_GT(all, 0.3f);
  EXPECT_LT(all, 0.9f);
  // Round the belly light and shade take turns, once an upright.
  int falls = 0;
  bool before = true;
  constexpr int kSteps = 3600;
  for (int i = 0; i < kSteps; ++i) {
    const float angle = glm::radians(360.0f * (static_cast<float>(i) + 0.5f) / kSteps);
    const bool now =
        !blocked(lamp, lights[0].position, glm::normalize(glm::vec3(glm::cos(angle), 0.21f, glm::sin(angle))));
    falls += before && !now ? 1 : 0;
    before = now;
  }
  EXPECT_GE(falls, 12);
  EXPECT_LE(falls, 24);
}

TEST(CageLamps, TheLightSwingsWithItsCage) {
  const scene::Scene scene = makeCage();
  float most = 0;
  for (double seconds = 0; seconds < 4; seconds += 0.25) {
    const glm::vec3 now = lightsOf(scene, seconds)[0].position;
    most = glm::max(most, glm::distance(now, lightsOf(scene)[0].position));
    // In the middle of its cage at any time: nothing nearer than the wires, but the fitting above.
    const std::vector<Triangle> lamp = trianglesOf(scene, seconds, named({"caged lamp"}));
    TestRandom random(8);
    for (int i = 0; i < 200; ++i) {
      const glm::vec3 d = random.direction();
      const std::optional<float> hit = nearest(lamp, now, d);
      if (hit && d.y < 0.7f) {
        EXPECT_GT(*hit, 0.25f);
      }
      EXPECT_TRUE(!hit || *hit > 0.15f);
    }
  }
  EXPECT_GT(most, 0.15f);
}

TEST(CageLamps, TheStoveLetsItsLightOutBetweenItsBarsOnly) {
  const scene::Scene scene = makeCage();
  const auto lights = lightsOf(scene);
  const std::vector<Triangle> stove = trianglesOf(scene, 0, named({"stove"}));
  TestRandom random(9);
  const float share = passing(stove, lights[1].position, 1.2f, [&] { return random.direction(); });
  EXPECT_GT(share, 0.02f);
  EXPECT_LT(share, 0.25f);
}

TEST(TownLamps, AreManyOfEveryKindWithinTheirRanges) {
  const auto lights = lightsOf(makeTown());
  ASSERT_EQ(lights.size(), 9u);
  int suns = 0, points = 0, spots = 0, cookies = 0;
  for (const scene::LightView& view : lights) {
    suns += view.light.kind == scene::LightKind::kDirectional ? 1 : 0;
    points += view.light.kind == scene::LightKind::kPoint ? 1 : 0;
    spots += view.light.kind == scene::LightKind::kSpot ? 1 : 0;
    cookies += view.light.cookie ? 1 : 0;
    if (view.light.kind == scene::LightKind::kDirectional) continue;
    ASSERT_TRUE(view.light.range);
    EXPECT_LE(*view.light.range, 15.0f);  // so that a frame may skip those out of reach
  }
  EXPECT_EQ(suns, 1);
  EXPECT_EQ(points, 1);
  EXPECT_EQ(spots, 7);
  EXPECT_EQ(cookies, 3);
}

/// A window's light stands in its room, and its axis passes the window into the street.
TEST(TownLamps, WindowsShineIntoTheStreet) {
  const scene::Scene scene = makeTown();
  const std::vector<Triangle> triangles = trianglesOf(scene);
  for (const scene::LightView& view : lightsOf(scene)) {
    if (!view.light.cookie) continue;
    EXPECT_GT(glm::abs(view.position.x), town::kFront + 1.0f);
    const std::optional<float> hit = nearest(triangles, view.position, view.direction);
    ASSERT_TRUE(hit);
    EXPECT_LT(glm::abs((view.position + 3.0f * view.direction).x), town::kFront);
    EXPECT_GT(*hit, 3.0f) << view.position.x << ' ' << view.position.y << ' ' << view.position.z;
    EXPECT_LT(*hit, *view.light.range);
  }
}

/// Wires take about a fifth of the lamp's light, each a shadow of its own: along a level line light and shade take
/// turns twice a diamond. The line runs half way between the wires' bends.
TEST(LatticeLamps, TheTripodsLightIsCutByWire) {
  const scene::Scene scene = makeLattice();
  const auto lights = lightsOf(scene);
  const auto lamp = std::find_if(lights.begin(), lights.end(), [](const scene::LightView& view) {
    return view.light.kind == scene::LightKind::kSpot;
  });
  ASSERT_NE(lamp, lights.end());
  // Cut-out panels count as whole here: real wire only, between the posts of the panels before the lamp.
  std::vector<Triangle> wires = trianglesOf(scene, 0, named({"fence"}));
  std::erase_if(wires, [](const Triangle& t) { return glm::length(t.edge1) > 0.5f || glm::length(t.edge2) > 0.5f; });
  int falls = 0, shaded = 0;
  bool before = false;
  constexpr int kSteps = 6000;
  for (int i = 0; i < kSteps; ++i) {
    const float z = -0.5f + static_cast<float>(i) / kSteps;  // one metre of the fence
    const bool now =
        blocked(wires, lamp->position, glm::normalize(glm::vec3(lattice::kCageX, 1.5075f, z) - lamp->position));
    falls += now && !before ? 1 : 0;
    shaded += now ? 1 : 0;
    before = now;
  }
  EXPECT_NEAR(falls, 2.0f / lattice::kMesh, 3.0f);
  EXPECT_GT(shaded, kSteps / 10);
  EXPECT_LT(shaded, kSteps / 2);
}

}  // namespace
}  // namespace tyndall::levels
