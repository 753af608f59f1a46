// What the hand does to the camera.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_inverse.hpp>

#include "fly_camera.hpp"

namespace tyndall::editor {
namespace {

TEST(FlyCamera, AnOrbitLeavesItsPivotWhereItIsInThePicture) {
  scene::CameraView file;
  file.worldFromView[3] = glm::vec4(3, 2, 8, 1);
  const glm::vec3 pivot(-1, 0.5f, 2);
  const auto seen = [&](const FlyCamera& camera) {
    return glm::vec3(glm::affineInverse(camera.view(file).worldFromView) * glm::vec4(pivot, 1));
  };
  FlyCamera camera(10);
  const glm::vec3 before = seen(camera);
  Flight flight;
  flight.pivot = pivot;
  for (const glm::vec2 drag : {glm::vec2(80, 0), glm::vec2(0, 60), glm::vec2(-300, -90), glm::vec2(5, 900)}) {
    const glm::mat4 was = camera.view(file).worldFromView;
    flight.orbit = drag;
    ASSERT_TRUE(camera.fly(flight, 0, file));
    EXPECT_LT(glm::distance(seen(camera), before), 1e-3f);
    EXPECT_GT(glm::distance(was[3], camera.view(file).worldFromView[3]), 0.01f);
  }
  EXPECT_LT(camera.pose()->pitch, -89);  // dragged on and on: it stops before it would turn over
  flight.orbit = {0, 100};
  camera.fly(flight, 0, file);
  EXPECT_LT(glm::distance(seen(camera), before), 1e-3f);
}

}  // namespace
}  // namespace tyndall::editor
