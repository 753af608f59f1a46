// A camera placed by hand: what --pose says and the editor flies.
#pragma once

#include <string>

#include "base/result.hpp"
#include "scene/scene.hpp"

namespace tyndall::app {

/// Position in metres, angles in degrees. Yaw 0 looks down -Z and grows to the right; pitch grows upwards, in [-90,
/// 90]. The horizon is level.
struct Pose {
  glm::vec3 position{0};
  float yaw = 0, pitch = 0;
  bool operator==(const Pose&) const = default;
};

/// The pose that looks as `view` does; its roll is dropped.
Pose poseOf(const scene::CameraView& view);
/// The lens of `lens` at `pose`.
scene::CameraView placed(const scene::CameraView& lens, const Pose& pose);
/// The direction that the pose looks in, unit length.
glm::vec3 forwardOf(const Pose& pose);

/// "X,Y,Z,YAW,PITCH"; a bad call that names the option for anything else. Reads back what poseText wrote to the bit.
Result<Pose> readPose(const std::string& option, const std::string& text);
std::string poseText(const Pose& pose);

}  // namespace tyndall::app
