// The fitted shadow maps against brute force: whatever can be seen and shadowed lies inside.
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "convex.hpp"
#include "shadow_fit.hpp"

namespace tyndall::render {
namespace {

using Random = std::mt19937;

float uniform(Random& random, float low, float high) {
  return std::uniform_real_distribution<float>(low, high)(random);
}

glm::vec3 unitVector(Random& random) {
  glm::vec3 v;
  do v = {uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
  while (glm::dot(v, v) > 1 || glm::dot(v, v) < 0.01f);
  return glm::normalize(v);
}

View randomView(Random& random, const glm::vec3& eye) {
  scene::CameraView camera;
  camera.worldFromView = glm::rotate(glm::translate(glm::mat4(1), eye), uniform(random, 0, 6.28f), unitVector(random));
  camera.camera.yfov = uniform(random, 0.3f, 2.0f);
  camera.camera.zfar = uniform(random, 5, 200);
  return makeView(camera, 320, 180);
}

glm::vec3 inBox(Random& random, const scene::Bounds& box) {
  return {uniform(random, box.min.x, box.max.x), uniform(random, box.min.y, box.max.y),
          uniform(random, box.min.z, box.max.z)};
}

// A point between the eye and the far plane (also before the near plane: the scattering integral starts at the eye).
glm::vec3 inFrustum(Random& random, const View& view) {
  const float z = view.zfar * std::cbrt(uniform(random, 0, 1));
  const glm::vec3 p(uniform(random, -1, 1) * z * view.viewFromClip[0][0],
                    uniform(random, -1, 1) * z * view.viewFromClip[1][1], -z);
  return glm::vec3(view.worldFromView * glm::vec4(p, 1));
}

// Is the line from `p` against the light's direction through the box? Slabs, independent of the fit's polygons.
bool lineMeets(const scene::Bounds& box, const glm::vec3& p, const glm::vec3& direction) {
  double enter = -1e30, leave = 1e30;
  for (int i = 0; i < 3; ++i) {
    if (std::abs(direction[i]) < 1e-12f) {
      if (p[i] < box.min[i] || p[i] > box.max[i]) return false;
      continue;
    }
    const double a = (box.min[i] - p[i]) / direction[i], b = (box.max[i] - p[i]) / direction[i];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}

struct Case {
  View view;
  glm::vec3 direction;
  scene::Bounds casters;
};

Case randomCase(Random& random) {
  Case c;
  const glm::vec3 center(uniform(random, -30, 30), uniform(random, -30, 30), uniform(random, -30, 30));
  glm::vec3 half(uniform(random, 0.1f, 40), uniform(random, 0.1f, 40), uniform(random, 0.1f, 40));
  if (random() % 4 == 0) half[static_cast<int>(random() % 3)] = 0;  // flat
  c.casters = {center - half, center + half};
  const bool inside = random() % 2 == 0;
  c.view = randomView(random,
                      inside ? inBox(random, c.casters)
                             : glm::vec3(uniform(random, -80, 80), uniform(random, -80, 80), uniform(random, -80, 80)));
  switch (random() % 4) {
    case 0:
      c.direction = glm::vec3(c.view.worldFromView[2]) * (random() % 2 ? 1.0f : -1.0f);
      break;  // along the view axis
    case 1:
      c.direction = glm::vec3(0);
      c.direction[static_cast<int>(random() % 3)] = random() % 2 ? 1.0f : -1.0f;
      break;
    default: c.direction = unitVector(random);
  }
  return c;
}

TEST(FitDirectional, HoldsEveryVisiblePointThatCanBeShadowed) {
  Random random(7);
  int shadowable = 0, useful = 0;
  for (int i = 0; i < 400; ++i) {
    const Case c = randomCase(random);
    const ShadowFit fit = fitDirectional(c.view, c.direction, c.casters, 512);
    useful += fit.useful;
    for (int j = 0; j < 200; ++j) {
      const glm::vec3 p = inFrustum(random, c.view);
      if (!lineMeets(c.casters, p, c.direction)) continue;
      ++shadowable;
      ASSERT_TRUE(fit.useful) << "case " << i;
      const glm::vec4 clip = fit.clipFromWorld[0] * glm::vec4(p, 1);
      ASSERT_LE(std::abs(clip.x), 1.0f) << "case " << i;
      ASSERT_LE(std::abs(clip.y), 1.0f) << "case " << i;
    }
  }
  EXPECT_GT(shadowable, 5000);
  EXPECT_GT(useful, 200);
}

TEST(FitDirectional, DepthSpansTheCastersAndNeverStoresOne) {
  Random random(8);
  for (int i = 0; i < 300; ++i) {
    const Case c = randomCase(random);
    const ShadowFit fit = fitDirectional(c.view, c.direction, c.casters, 512);
    for (int j = 0; j < 50; ++j) {
      const glm::vec4 clip = fit.clipFromWorld[0] * glm::vec4(inBox(random, c.casters), 1);
      ASSERT_GE(clip.z, 0.0f);
      ASSERT_LT(clip.z, 1.0f);
    }
    // Depth grows along the light.
    const glm::vec4 step = fit.clipFromWorld[0] * glm::vec4(c.direction, 0);
    ASSERT_GT(step.z, 0.0f);
    ASSERT_NEAR(step.x, 0, 1e-4 * (1 + std::abs(fit.clipFromWorld[0][0][0])));
  }
}

double mapArea(const ShadowFit& fit) {
  const glm::dmat4 m(fit.clipFromWorld[0]);
  const auto row = [&](int r) { return glm::length(glm::dvec3(m[0][r], m[1][r], m[2][r])); };
  return 4 / (row(0) * row(1));
}

TEST(FitDirectional, IsNoLargerThanAnAxisAlignedFit) {
  Random random(9);
  double turnedSum = 0, alignedSum = 0;
  for (int i = 0; i < 300; ++i) {
    const Case c = randomCase(random);
    const ShadowFit fit = fitDirectional(c.view, c.direction, c.casters, 4096);
    if (!fit.useful) continue;
    // The same fit without turning: the box, seen along an arbitrary but fixed pair of axes, of what must be inside.
    const glm::dvec3 z = glm::normalize(glm::dvec3(c.direction));
    const glm::dvec3 x = glm::normalize(glm::cross(std::abs(z.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0), z)),
                     y = glm::cross(z, x);
    std::vector<glm::dvec2> box, frustum{{glm::dot(glm::dvec3(c.view.eye), x), glm::dot(glm::dvec3(c.view.eye), y)}};
    scene::Bounds thick = c.casters;  // as the fit thickens it
    const glm::vec3 skin(1e-4f * glm::distance(thick.min, thick.max) + 1e-3f);
    thick.min -= skin;
    thick.max += skin;
    for (const glm::vec3& p : boxCorners(thick, {}))
      box.emplace_back(glm::dot(glm::dvec3(p), x), glm::dot(glm::dvec3(p), y));
    for (int k = 0; k < 4; ++k) {
      const float f = c.view.zfar;
      const glm::vec3 corner((k & 1 ? f : -f) * c.view.viewFromClip[0][0], (k & 2 ? f : -f) * c.view.viewFromClip[1][1],
                             -f);
      const glm::dvec3 p(c.view.worldFromView * glm::vec4(corner, 1));
      frustum.emplace_back(glm::dot(p, x), glm::dot(p, y));
    }
    const Polygon shared = intersect(convexHull(box), convexHull(frustum));
    if (shared.size() < 3) continue;
    glm::dvec2 low(1e30), high(-1e30);
    for (const glm::dvec2& p : shared) low = glm::min(low, p), high = glm::max(high, p);
    const double aligned = (high.x - low.x) * (high.y - low.y), turned = mapArea(fit);
    EXPECT_LE(turned, aligned * 1.003 + 1e-6) << "case " << i;
    turnedSum += turned;
    alignedSum += aligned;
  }
  EXPECT_LT(turnedSum, 0.95 * alignedSum) << "turning should pay on the whole";
}

TEST(FitDirectional, NothingToShadowGivesAFiniteMatrix) {
  scene::CameraView camera;
  camera.camera.zfar = 10.0f;
  const View view = makeView(camera, 64, 64);  // looks down -Z from the origin
  scene::Bounds behind{{-1, -1, 50}, {1, 1, 52}};
  for (const scene::Bounds& casters : {behind, scene::Bounds{}}) {
    const ShadowFit fit = fitDirectional(view, {0, -1, 0}, casters, 256);
    EXPECT_FALSE(fit.useful);
    for (int i = 0; i < 16; ++i) EXPECT_TRUE(std::isfinite(fit.clipFromWorld[0][i / 4][i % 4]));
    EXPECT_NE(glm::determinant(glm::dmat4(fit.clipFromWorld[0])), 0.0);
  }
}

scene::LightView localLight(scene::LightKind kind) {
  scene::LightView light;
  light.light.kind = kind;
  light.light.outerConeAngle = 0.6f;
  light.position = {1, 2, 3};
  light.direction = glm::normalize(glm::vec3(1, -2, 0.5f));
  return light;
}

TEST(FitSpot, TheConeFillsTheMapAndDepthGrows) {
  const scene::LightView light = localLight(scene::LightKind::kSpot);
  const ShadowFit fit = fitSpot(light, {{-5, -5, -5}, {8, 1, 8}}, 1024);
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const glm::vec3 d = unitVector(random);
    const glm::vec4 clip = fit.clipFromWorld[0] * glm::vec4(light.position + 4.0f * d, 1);
    const bool inCone = glm::dot(d, light.direction) > std::cos(0.6f);
    if (inCone) {
      EXPECT_GT(clip.w, 0);
      EXPECT_LE(glm::length(glm::vec2(clip)), clip.w);
    }
    EXPECT_NEAR(clip.w, 4 * glm::dot(d, light.direction), 1e-4);
  }
  const auto depth = [&](float t) {
    const glm::vec4 clip = fit.clipFromWorld[0] * glm::vec4(light.position + t * light.direction, 1);
    return clip.z / clip.w;
  };
  EXPECT_LT(depth(1), depth(2));
  EXPECT_LT(depth(2), depth(10));
  EXPECT_LT(depth(10), 1);
}

TEST(FitSpot, AnImpossiblyWideConeIsSaid) {
  scene::LightView light = localLight(scene::LightKind::kSpot);
  light.light.outerConeAngle = 1.5707963f;
  EXPECT_NE(fitSpot(light, {{-5, -5, -5}, {8, 1, 8}}, 1024).note, "");
  light.light.outerConeAngle = 1.5f;
  EXPECT_EQ(fitSpot(light, {{-5, -5, -5}, {8, 1, 8}}, 1024).note, "");
}

TEST(FitPoint, EachDirectionFallsIntoItsMajorAxisFace) {
  const scene::LightView light = localLight(scene::LightKind::kPoint);
  const ShadowFit fit = fitPoint(light, {{-5, -5, -5}, {8, 8, 8}}, 256);
  ASSERT_EQ(fit.faceCount, 6u);
  Random random(4);
  for (int i = 0; i < 2000; ++i) {
    const glm::vec3 d = unitVector(random);
    int face = 0;
    float longest = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(d[axis]) <= longest) continue;
      longest = std::abs(d[axis]);
      face = 2 * axis + (d[axis] < 0);
    }
    for (int f = 0; f < 6; ++f) {
      const glm::vec4 clip = fit.clipFromWorld[static_cast<std::size_t>(f)] * glm::vec4(light.position + 3.0f * d, 1);
      const bool inside = clip.w > 0 && std::abs(clip.x) < clip.w * 0.9999f && std::abs(clip.y) < clip.w * 0.9999f;
      if (inside) {
        EXPECT_EQ(f, face);
      }
      if (f == face) {
        EXPECT_GT(clip.w, 0);
        EXPECT_LE(std::abs(clip.x), clip.w * 1.0001f);
        EXPECT_LE(std::abs(clip.y), clip.w * 1.0001f);
      }
    }
  }
}

TEST(FitPoint, NoCasterOfTheBoxIsBeyondTheFarPlane) {
  const scene::LightView light = localLight(scene::LightKind::kPoint);
  const scene::Bounds casters{{-50, -5, -5}, {8, 8, 8}};
  const ShadowFit fit = fitPoint(light, casters, 256);
  for (const glm::vec3& corner : boxCorners(casters, {})) {
    for (const glm::mat4& m : fit.clipFromWorld) {
      const glm::vec4 clip = m * glm::vec4(corner, 1);
      if (clip.w > 0) {
        EXPECT_LT(clip.z / clip.w, 1);
      }
    }
  }
}

}  // namespace
}  // namespace tyndall::render
