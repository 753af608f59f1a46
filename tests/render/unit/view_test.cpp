// makeView against hand-computed projections.
#include <cmath>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "render/frame.hpp"

namespace tyndall::render {
namespace {

scene::CameraView camera(float yfov, float znear, float zfar, const glm::mat4& worldFromView = glm::mat4(1)) {
  scene::CameraView view;
  view.worldFromView = worldFromView;
  view.camera.yfov = yfov;
  view.camera.znear = znear;
  view.camera.zfar = zfar;
  return view;
}

glm::dvec3 project(const View& view, const glm::vec3& world) {
  const glm::dvec4 clip = glm::dmat4(view.clipFromView) * glm::dmat4(view.viewFromWorld) * glm::dvec4(world, 1);
  return glm::dvec3(clip) / clip.w;
}

TEST(MakeView, DepthIsOneAtNearAndZeroAtFar) {
  const View view = makeView(camera(1.0f, 0.25f, 300.0f), 1280, 720);
  EXPECT_NEAR(project(view, {0, 0, -0.25f}).z, 1.0, 1e-6);
  EXPECT_NEAR(project(view, {0, 0, -300.0f}).z, 0.0, 1e-9);
  EXPECT_NEAR(project(view, {0, 0, -2.0f}).z, (0.25 / 299.75) * (300.0 - 2.0) / 2.0, 1e-7);
}

TEST(MakeView, FieldOfViewIsVerticalAndYPointsDown) {
  const View view = makeView(camera(1.2f, 0.1f, 100.0f), 200, 100);
  const float top = 10 * std::tan(0.6f);
  EXPECT_NEAR(project(view, {0, top, -10}).y, -1.0, 1e-6);
  EXPECT_NEAR(project(view, {2 * top, 0, -10}).x, 1.0, 1e-6) << "aspect ratio 2";
}

TEST(MakeView, InversesAreInverses) {
  const glm::mat4 pose =
      glm::rotate(glm::translate(glm::mat4(1), {3, -7, 11}), 0.8f, glm::normalize(glm::vec3(1, 2, 3)));
  const View view = makeView(camera(0.9f, 0.1f, 1000.0f, pose), 640, 480);
  EXPECT_EQ(view.eye, glm::vec3(3, -7, 11));
  const glm::mat4 a = view.viewFromClip * view.clipFromView, b = view.worldFromView * view.viewFromWorld;
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) {
      EXPECT_NEAR(a[c][r], c == r, 1e-6);
      EXPECT_NEAR(b[c][r], c == r, 2e-6);
    }
  }
}

TEST(MakeView, NoFarPlaneReachesAsFarAsTheLevel) {
  scene::CameraView c = camera(1.0f, 0.1f, 1.0f);
  c.camera.zfar.reset();
  EXPECT_EQ(makeView(c, 1, 1).zfar, 1000.0f);
  EXPECT_EQ(makeView(c, 1, 1, {{-10, -1, -10}, {10, 5, 10}}).zfar, 1000.0f) << "small levels keep their air";
  const scene::Bounds wide{{-3000, -2, -8000}, {4000, 900, 100}};
  for (const float yaw : {0.0f, 0.7f, 2.5f, 4.0f}) {
    c.worldFromView = glm::rotate(glm::translate(glm::mat4(1), {20, 60, -30}), yaw, glm::vec3(0, 1, 0));
    const View view = makeView(c, 64, 36, wide);
    EXPECT_EQ(view.zfar, makeView(camera(1.0f, 0.1f, view.zfar), 64, 36).zfar);
    for (int corner = 0; corner < 8; ++corner) {
      const glm::vec3 p(corner & 1 ? wide.max.x : wide.min.x, corner & 2 ? wide.max.y : wide.min.y,
                        corner & 4 ? wide.max.z : wide.min.z);
      const glm::dvec4 clip = glm::dmat4(view.clipFromView) * glm::dmat4(view.viewFromWorld) * glm::dvec4(p, 1);
      if (clip.w > view.znear) {
        EXPECT_GT(clip.z, 0) << "behind the far plane";
      }
    }
    EXPECT_LT(view.zfar, 1.01f * 9000) << "as far as the level, no farther";
  }
}

// Whatever a file may say, near and far: depths fall from 1 to 0, strictly between a tenth apart, and come back.
TEST(MakeView, EveryPairOfPlanesKeepsDepthsApart) {
  const scene::Bounds small{glm::vec3(-5), glm::vec3(5)};
  for (const float near : {1e-5f, 0.1f, 1.0f, 999.999f, 1000.0f, 2000.0f, 1e6f, 1e9f}) {
    for (const double factor : {0.0, 1.0000002, 1.001, 2.0, 1e3, 1e6, 1e12}) {
      scene::CameraView c = camera(1.0f, near, 0);
      const float far = static_cast<float>(std::max(near * factor, double{std::nextafter(near, 1e30f)}));
      if (factor > 0)
        c.camera.zfar = far;
      else
        c.camera.zfar.reset();
      const View view = makeView(c, 16, 9, small);
      ASSERT_GT(view.zfar, view.znear);
      ASSERT_TRUE(std::isfinite(view.zfar));
      double before = 1.5;
      for (double z = near; z <= view.zfar; z *= 1.1) {
        const glm::vec4 clip = view.clipFromView * glm::vec4(0, 0, -static_cast<float>(z), 1);
        const float depth = clip.z / clip.w;
        ASSERT_LT(depth, before) << near << ' ' << view.zfar << ' ' << z;
        ASSERT_GE(depth, -1e-6f * near / static_cast<float>(z));
        before = depth;
        const double read = double{view.znear} * view.zfar / (view.znear + double{depth} * (view.zfar - view.znear));
        ASSERT_NEAR(read, z, 1e-6 * z) << near << ' ' << view.zfar;
      }
    }
  }
}

}  // namespace
}  // namespace tyndall::render
