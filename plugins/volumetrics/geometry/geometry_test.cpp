// The epipolar frame against brute force: every view ray and every light ray that matters lies inside the bounds.
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <glm/gtc/type_ptr.hpp>

#include "geometry/camera_rays.hpp"
#include "geometry/convex.hpp"
#include "geometry/epipolar_frame.hpp"
#include "geometry/linear_frame.hpp"
#include "lib/cpp.hpp"

namespace {

using namespace volumetrics;

struct Scenario {
  RectificationInput input;
  std::mt19937 random;
  double uniform(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); }
  glm::dvec3 direction() {
    glm::dvec3 v;
    do v = {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
    while (glm::dot(v, v) > 1 || glm::dot(v, v) < 0.01);
    return glm::normalize(v);
  }

  explicit Scenario(unsigned seed) : random(seed) {
    const glm::dvec3 forward = direction();
    const glm::dvec3 right = glm::normalize(glm::cross(forward, direction()));
    RayBlock& rays = input.rays;
    rays.eye = glm::vec3(uniform(-20, 20), uniform(-20, 20), uniform(-20, 20));
    rays.forward = glm::vec3(forward);
    rays.right = glm::vec3(right * uniform(0.1, 2));
    rays.up = glm::vec3(glm::cross(right, forward) * uniform(0.1, 1.5));
    rays.znear = 0.1f;
    rays.zfar = static_cast<float>(uniform(5, 500));
    input.towards = glm::vec3(seed % 5 == 0 ? forward * (seed % 2 ? 1.0 : -1.0) : direction());
    const glm::vec3 low(uniform(-30, 0), uniform(-30, 0), uniform(-30, 0));
    const glm::vec3 high = low + glm::vec3(uniform(1, 60), uniform(0.1, 60), uniform(1, 60));
    for (int i = 0; i < 8; ++i)
      input.casterCorners[i] = {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z};
  }
  glm::dvec3 pixelRay() {
    return glm::normalize(glm::dvec3(input.rays.forward) + uniform(-1, 1) * glm::dvec3(input.rays.right) +
                          uniform(-1, 1) * glm::dvec3(input.rays.up));
  }
};

double azimuth(const RectificationBlock& block, const glm::dvec3& d) {
  return std::atan2(glm::dot(d, glm::dvec3(block.e2)), glm::dot(d, glm::dvec3(block.e1)));
}

}  // namespace

TEST(EpipolarFrame, EveryViewRayIsInsideTheBounds) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    Scenario s(seed);
    const RectificationBlock block = epipolarBlock(s.input);
    ASSERT_NEAR(glm::dot(block.e1, s.input.towards), 0, 1e-5);
    ASSERT_NEAR(glm::dot(block.e1, block.e2), 0, 1e-5);
    double low = 10, high = -10;
    for (int i = 0; i < 2000; ++i) {
      const glm::dvec3 d = s.pixelRay();
      const double theta = std::acos(std::clamp(glm::dot(d, glm::dvec3(s.input.towards)), -1.0, 1.0));
      low = std::min(low, theta);
      high = std::max(high, theta);
      const double depth = (theta - block.depthLow) * block.depthScale;
      ASSERT_GE(depth, -1e-4) << seed;
      ASSERT_LE(depth, 1 + 1e-4) << seed;
      const double slice = (azimuth(block, d) - block.sliceLow) / block.sliceStep;
      ASSERT_GE(slice, -0.01) << seed;
      ASSERT_LE(slice, block.slices + 0.01) << seed;
    }
    // Sharp: no more than the guard band and what random rays miss of the corners.
    EXPECT_LT(low - block.depthLow, 0.06 * (high - low) + 0.25) << seed;
    EXPECT_LT(block.depthLow + 1 / block.depthScale - high, 0.06 * (high - low) + 0.25) << seed;
  }
}

TEST(EpipolarFrame, FullCircleExactlyWhenAnEpipoleIsInView) {
  int full = 0, partial = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    Scenario s(seed);
    const RectificationBlock block = epipolarBlock(s.input);
    const auto onScreen = [&](double sign) {
      const glm::dvec3 a = sign * glm::dvec3(s.input.towards);
      const double depth = glm::dot(a, glm::dvec3(s.input.rays.forward));
      const glm::dvec3 r(s.input.rays.right), u(s.input.rays.up);
      return depth > 0 && std::abs(glm::dot(a, r)) <= depth * glm::dot(r, r) &&
             std::abs(glm::dot(a, u)) <= depth * glm::dot(u, u);
    };
    EXPECT_EQ(block.fullCircle != 0, onScreen(1) || onScreen(-1)) << seed;
    (block.fullCircle ? full : partial)++;
  }
  EXPECT_GT(full, 30);
  EXPECT_GT(partial, 30);
}

// A visible point that a caster shadows lies inside the polygon: the columns miss nothing.
TEST(EpipolarFrame, ShadowedPointsAreInsideTheRegion) {
  int shadowed = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    Scenario s(seed);
    const RectificationBlock block = epipolarBlock(s.input);
    for (int i = 0; i < 500; ++i) {
      const glm::dvec3 d = s.pixelRay();
      const double far = s.input.rays.zfar / glm::dot(d, glm::dvec3(s.input.rays.forward));
      const glm::dvec3 p = d * s.uniform(0, far);  // relative to the eye
      // Slab test of the ray from p towards the light against the casters' box.
      double t0 = 0, t1 = 1e30;
      for (int axis = 0; axis < 3; ++axis) {
        const double a = s.input.towards[axis];
        const double low = s.input.casterCorners[0][axis] - s.input.rays.eye[axis] - p[axis];
        const double high = s.input.casterCorners[7][axis] - s.input.rays.eye[axis] - p[axis];
        if (std::abs(a) < 1e-9) {
          if (low > 0 || high < 0) t1 = -1;
          continue;
        }
        t0 = std::max(t0, std::min(low / a, high / a));
        t1 = std::min(t1, std::max(low / a, high / a));
      }
      if (t1 <= t0) continue;
      ++shadowed;
      ASSERT_GT(block.polygonCount, 0u) << seed;
      const glm::dvec2 q(glm::dot(p, glm::dvec3(block.e1)), glm::dot(p, glm::dvec3(block.e2)));
      for (std::uint32_t j = 0; j < block.polygonCount; ++j)
        ASSERT_LE(glm::dot(q, glm::dvec2(block.polygon[j])) - block.polygon[j].z, 1e-3 * (1 + glm::length(p))) << seed;
    }
  }
  EXPECT_GT(shadowed, 1000);
}

// The inclination range of a slice (clipToFrustumPlane) contains the view rays that fall into it.
TEST(EpipolarFrame, SliceRangesContainTheirRays) {
  namespace lib = tyndall::lib::f64;
  for (unsigned seed = 0; seed < 100; ++seed) {
    Scenario s(seed);
    const RectificationBlock block = epipolarBlock(s.input);
    for (int i = 0; i < 300; ++i) {
      const glm::dvec3 d = s.pixelRay();
      const double phi = azimuth(block, d);
      const double theta = std::acos(std::clamp(glm::dot(d, glm::dvec3(s.input.towards)), -1.0, 1.0));
      glm::dvec2 interval(0, std::numbers::pi);
      for (std::uint32_t j = 0; j < block.planeCount; ++j) {
        const glm::dvec3 n(block.planes[j]);
        interval = lib::clipToFrustumPlane(interval, n.z, n.x * std::cos(phi) + n.y * std::sin(phi));
      }
      ASSERT_GE(theta, interval.x - 1e-4) << seed;
      ASSERT_LE(theta, interval.y + 1e-4) << seed;
    }
  }
}

// Spacing along the border: azimuth and slice are one-to-one both ways, growing, and every ray falls inside.
TEST(EpipolarFrame, BorderSlicesAreMonotoneAndInvertible) {
  int spaced = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    Scenario s(seed);
    s.input.rays.pixelScale = glm::vec2(2.0f / 320, 2.0f / 180);
    s.input.spacing = SliceSpacing::kBorder;
    const RectificationBlock block = epipolarBlock(s.input);
    if (block.slicing != kSlicesByBorder) continue;
    ++spaced;
    ASSERT_LE(block.edgeCount, kMaxBorderEdges);
    double end = 0;
    for (std::uint32_t i = 0; i < block.edgeCount; ++i) {
      const BorderEdge& edge = block.edges[i];
      EXPECT_NEAR(edge.sliceStart, end, 0.02) << seed;
      end = edge.sliceStart + edge.sliceCount;
      double before = edge.phiStart - 1e-4;
      for (int step = 0; step <= 20; ++step) {
        const glm::dvec2 p = glm::dvec2(edge.start) + glm::dvec2(edge.delta) * (step / 20.0);
        double phi = std::atan2(p.y, p.x);
        phi +=
            2 * std::numbers::pi * std::round((before - phi) / (2 * std::numbers::pi));  // -pi and pi are one direction
        EXPECT_GE(phi, before - 1e-3) << seed << ' ' << i;
        before = phi;
      }
      EXPECT_NEAR(before, edge.phiEnd, 2e-3) << seed << ' ' << i;
    }
    EXPECT_NEAR(end, block.slices, 0.1) << seed;
    for (int i = 0; i < 200; ++i) {
      const double phi = azimuth(block, s.pixelRay());
      EXPECT_GE(phi, block.edges[0].phiStart - 1e-3) << seed;
      EXPECT_LE(phi, block.edges[block.edgeCount - 1].phiEnd + 1e-3) << seed;
    }
  }
  EXPECT_GT(spaced, 200);
}

// The projective map: a view ray is a row of constant depth, columns grow along it uniformly in 1/x, and the clip
// matrix says the same as the block that shaders read.
TEST(LinearFrame, ViewRaysAreRowsOfConstantDepth) {
  int made = 0, none = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    Scenario s(seed);
    const auto frame = linearFrame(s.input, 1 + seed % 4);
    if (!frame) {
      ++none;
      continue;
    }
    const RectificationBlock& block = frame->block;
    if (block.polygonCount == 0) continue;
    ++made;
    for (int i = 0; i < 50; ++i) {
      const glm::dvec3 d = s.pixelRay();
      const double x = glm::dot(d, glm::dvec3(block.e1)), y = glm::dot(d, glm::dvec3(block.e2));
      ASSERT_GT(x, 0) << seed;
      const double row = (y / x - block.sliceLow) / block.sliceStep / block.slices;
      EXPECT_GE(row, -1e-4) << seed;
      EXPECT_LE(row, 1 + 1e-4) << seed;
      const double depth = (-glm::dot(d, glm::dvec3(s.input.towards)) / x - block.rasterLow) * block.rasterScale;
      EXPECT_GE(depth, -1e-4);
      EXPECT_LE(depth, 1 + 1e-4);
      for (std::uint32_t split = 0; split < block.splits; ++split) {
        const double share = s.uniform(0, 1);
        const double inverse =
            block.inverse[split] + share * (static_cast<double>(block.inverse[split + 1]) - block.inverse[split]);
        const glm::vec3 world = glm::vec3(glm::dvec3(s.input.rays.eye) + d / (x * inverse));
        const glm::vec4 clip = frame->clipFromWorld[split] * glm::vec4(world, 1);
        ASSERT_GT(clip.w, 0) << seed;
        // Float matrices far from the origin: the tolerance follows the size of what is subtracted.
        const double tolerance = 2e-3 + 2e-5 * (glm::length(world) + 60) / clip.w;
        EXPECT_NEAR(clip.x / clip.w, 2 * row - 1,
                    tolerance * (1 + 2 / (static_cast<double>(block.sliceStep) * block.slices)))
            << seed;
        EXPECT_NEAR(clip.z / clip.w, depth, tolerance * (1 + block.rasterScale)) << seed;
        if (frame->block.inverse[split] < 2 * frame->block.inverse[split + 1])
          continue;  // a thin split: ill-conditioned in float
        EXPECT_NEAR(clip.y / clip.w, 2 * share - 1, 10 * tolerance) << seed;
      }
    }
    // Columns grow within a split, so the longest is no shorter than if all were even; no split could be moved to
    // shorten it.
    EXPECT_GE(frame->longestColumn, frame->evenColumn * 0.99) << seed;
    for (std::uint32_t split = 0; split < block.splits; ++split) {
      const double a = 1.0 / block.inverse[split], b = 1.0 / block.inverse[split + 1];
      const double step = (1 / a - 1 / b) / block.columns;
      EXPECT_NEAR(b - 1 / (1 / b + step), frame->longestColumn, 0.02 * frame->longestColumn + 1e-4 * b)
          << seed << ' ' << split;
    }
  }
  EXPECT_GT(made, 60);
  EXPECT_GT(none, 60);  // every fifth scenario looks into or away from the light
}

// Why column edges come from the matrix: Klehm et al. 2014, equation 12 lets columns grow by one factor, taken from the
// first three texel centres. They are uniform in 1/x, so the factor rises along the row, and the columns of that
// equation end far before the row.
TEST(LinearFrame, ItsShareFallsFromAllToNone) {
  LinearFrame frame;
  frame.evenColumn = 0.01;
  frame.longestColumn = 0.03;
  frame.widestSlice = 1.2;
  EXPECT_EQ(linearShare(frame), 1);
  double before = 1;
  for (double columns = 3; columns < 4.2; columns += 0.01) {
    frame.longestColumn = columns * frame.evenColumn;
    const double share = linearShare(frame);
    EXPECT_LE(share, before);
    EXPECT_GE(share, before - 0.05) << "a jump is seen";
    if (columns >= 4) {
      EXPECT_EQ(share, 0) << "columns of more than four epipolar ones";
    }
    before = share;
  }
  frame.longestColumn = 0.03;
  frame.widestSlice = 1.36;
  const double between = linearShare(frame);
  EXPECT_GT(between, 0);
  EXPECT_LT(between, 1);
  frame.widestSlice = 1.41;
  EXPECT_EQ(linearShare(frame), 0);
  // Where nothing can be blocked there are no columns to compare.
  frame.evenColumn = frame.longestColumn = 0;
  frame.widestSlice = 1;
  EXPECT_EQ(linearShare(frame), 1);
}

// Cameras that turn until the light, or its antipode, comes on the screen, past an edge or a corner of it: where the
// projective map still has a share, its slices, depths and columns are bounded, and the share never jumps, also not to
// where there is no map at all.
TEST(LinearFrame, HoldsOnlyWhereItIsWellConditionedAndLetsGoSmoothly) {
  int held = 0, faded = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    Scenario s(seed);
    const glm::dvec3 towards(s.input.towards), axis = s.direction();
    const std::uint32_t splits = 1 + seed % 4;
    double before = -1;
    for (double turn = 0; turn < 2 * std::numbers::pi; turn += 0.001) {
      // Rodrigues' rotation of the light about the camera, which says the same as a turn of the camera.
      const glm::dvec3 turned = towards * std::cos(turn) + glm::cross(axis, towards) * std::sin(turn) +
                                axis * glm::dot(axis, towards) * (1 - std::cos(turn));
      s.input.towards = glm::vec3(glm::normalize(turned));
      const auto frame = linearFrame(s.input, splits);
      // Casters that come into the region of sight, or leave it, are another matter than the singularity.
      const double share = !frame ? 0.0 : frame->block.polygonCount == 0 ? -1.0 : linearHold(*frame);
      if (share >= 0 && before >= 0 && frame) {
        EXPECT_LT(std::abs(share - before), 0.15) << seed << ' ' << turn;
      }
      if (share > 0) {
        ++held;
        faded += share < 1 ? 1 : 0;
        const RectificationBlock& block = frame->block;
        EXPECT_LT(frame->widestSlice, 20) << seed << ' ' << turn;
        EXPECT_LT(1 / block.rasterScale, 60) << seed << ' ' << turn;
        const double first = 1 / block.inverse[splits - 1], last = 1 / block.inverse[splits];
        const double column = last - 1 / (1 / last + (1 / first - 1 / last) / block.columns);
        EXPECT_LT(column, 0.91 * (last - 1 / block.inverse[0])) << seed << ' ' << turn;
        EXPECT_LE(linearShare(*frame), share);
      }
      before = share;
    }
  }
  EXPECT_GT(held, 1000);
  EXPECT_GT(faded, 300);
}

TEST(LinearFrame, AConstantGrowthFactorFallsShort) {
  const double near = 0.1, far = 90;
  const int columns = 1024;
  const auto edge = [&](double i) { return 1 / (1 / near - i / columns * (1 / near - 1 / far)); };
  const double growth = (edge(2.5) - edge(1.5)) / (edge(1.5) - edge(0.5));
  const double first = edge(1) - edge(0);
  const double reach = near + first * (std::pow(growth, columns) - 1) / (growth - 1);
  std::printf("equation 12: columns from %.1f m reach %.2f m instead of %.0f m\n", near, reach, far);
  EXPECT_NEAR(edge(columns), far, 1e-9);
  EXPECT_LT(reach, 1.0);
  // Where far is twice near it is a fair approximation.
  const auto mild = [&](double i) { return 1 / (1 - i / columns * 0.5); };
  const double d = (mild(2.5) - mild(1.5)) / (mild(1.5) - mild(0.5));
  const double mildReach = 1 + (mild(1) - mild(0)) * (std::pow(d, columns) - 1) / (d - 1);
  EXPECT_GT(mildReach, 1.8);
  EXPECT_LT(mildReach, 2.0);
}

TEST(Convex, IntersectionMatchesPointSampling) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto contains = [](const Polygon& polygon, const glm::dvec2& p) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) < 0) return false;
    }
    return polygon.size() >= 3;
  };
  for (int test = 0; test < 200; ++test) {
    std::vector<glm::dvec2> a(8), b(8);
    const glm::dvec2 shift(u(random), u(random));
    for (auto& p : a) p = {u(random), u(random)};
    for (auto& p : b) p = glm::dvec2(u(random), u(random)) + shift;
    const Polygon ha = convexHull(a), hb = convexHull(b), both = intersectConvex(ha, hb);
    EXPECT_GT(area(ha), 0);
    int inside = 0;
    const int n = 4000;
    for (int i = 0; i < n; ++i) {
      const glm::dvec2 p(2 * u(random), 2 * u(random));
      const bool expected = contains(ha, p) && contains(hb, p);
      inside += expected;
      EXPECT_EQ(contains(both, p), expected);
    }
    EXPECT_NEAR(both.size() >= 3 ? area(both) : 0, 16.0 * inside / n, 0.25);
  }
}

// The rays of the block are those of the view's matrices.
TEST(CameraRays, AgreeWithTheMatrices) {
  TyView view{};
  view.width = 320;
  view.height = 180;
  view.znear = 0.2f;
  view.zfar = 50;
  const float f = 1.7f, aspect = 320.0f / 180.0f;
  view.clip_from_view[0] = f / aspect;
  view.clip_from_view[5] = -f;
  for (int i = 0; i < 4; ++i) view.world_from_view[i * 5] = 1;
  view.world_from_view[12] = 3;
  view.eye[0] = 3;
  const RayBlock rays = rayBlock(view, readSettings(nullptr, 0));
  // Centre of pixel (0, 0): ndc (-1 + 1/320, -1 + 1/180) in Vulkan's y-down clip space, so up in view space.
  const glm::vec3 d = rays.forward + (-1 + 1 / 320.0f) * rays.right - (-1 + 1 / 180.0f) * rays.up;
  EXPECT_NEAR(d.x, (-1 + 1 / 320.0f) * aspect / f, 1e-6);
  EXPECT_NEAR(d.y, (1 - 1 / 180.0f) / f, 1e-6);
  EXPECT_NEAR(d.z, -1, 1e-6);
  EXPECT_FLOAT_EQ(rays.sigma_t, 0.03f);
}

// A sun's affine map equals the matrix it came from.
TEST(CameraRays, SunBlockIsTheShadowMatrix) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> u(-1, 1);
  TyLight light{};
  light.direction[1] = -1;
  light.shadow_size = 512;
  for (int i = 0; i < 15; ++i) light.shadow_clip_from_world[0][i] = 0.1f * u(random);
  light.shadow_clip_from_world[0][3] = light.shadow_clip_from_world[0][7] = light.shadow_clip_from_world[0][11] = 0;
  light.shadow_clip_from_world[0][15] = 1;
  const glm::vec3 eye(1, 2, 3), v(0.3f, -4, 7);
  const SunBlock sun = sunBlock(light, eye);
  const glm::vec4 clip = glm::make_mat4(light.shadow_clip_from_world[0]) * glm::vec4(eye + v, 1);
  const glm::vec3 got = sun.shadowEye + sun.shadowX * v.x + sun.shadowY * v.y + sun.shadowZ * v.z;
  EXPECT_NEAR(got.x, (clip.x * 0.5f + 0.5f) * 512, 1e-2);
  EXPECT_NEAR(got.y, (clip.y * 0.5f + 0.5f) * 512, 1e-2);
  EXPECT_NEAR(got.z, clip.z, 1e-4);
}
