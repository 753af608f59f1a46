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

TEST(MakeView, NoFarPlaneMeansAThousandMetres) {
  scene::CameraView c = camera(1.0f, 0.1f, 1.0f);
  c.camera.zfar.reset();
  EXPECT_EQ(makeView(c, 1, 1).zfar, 1000.0f);
}

}  // namespace
}  // namespace tyndall::render
