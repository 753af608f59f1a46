#include "fly_camera.hpp"

#include <algorithm>
#include <cmath>

#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

namespace tyndall::editor {
namespace {

constexpr float kDegreesPerPixel = 0.2291831f;         // 0.004 radians: a drag across 1280 pixels turns by 290 degrees
constexpr float kSpeedPerNotch = 1.25f;                // three notches double the speed
constexpr float kFast = 4;                             // with Shift
constexpr float kMaxPitch = 89.4f;                     // degrees; beyond it a drag would turn the head over
constexpr float kMinSpeed = 0.01f, kMaxSpeed = 10000;  // m/s
constexpr float kMaxPosition = 1e6f;                   // metres: what --pose takes

}  // namespace

FlyCamera::FlyCamera(float reach) : speed_(std::clamp(reach / 10, 0.1f, 100.0f)) {}

bool FlyCamera::fly(const Flight& flight, float seconds, const scene::CameraView& file) {
  if (flight.wheel != 0) speed_ = std::clamp(speed_ * std::pow(kSpeedPerNotch, flight.wheel), kMinSpeed, kMaxSpeed);
  const bool moves = flight.push != glm::vec3(0) || flight.look != glm::vec2(0) || flight.orbit != glm::vec2(0);
  if (!moves) return false;
  if (!pose_) {
    pose_ = app::poseOf(file);
    pose_->pitch = std::clamp(pose_->pitch, -kMaxPitch, kMaxPitch);
  }
  if (flight.orbit != glm::vec2(0)) {
    const float before = pose_->pitch, aside = glm::radians(flight.orbit.x * kDegreesPerPixel),
                yaw = glm::radians(pose_->yaw);
    pose_->pitch = std::clamp(before - flight.orbit.y * kDegreesPerPixel, -kMaxPitch, kMaxPitch);
    pose_->yaw = std::remainder(pose_->yaw + flight.orbit.x * kDegreesPerPixel, 360.0f);
    // Position and view turn alike: up about the view's right, then aside about the world's up (to the right: clockwise
    // from above).
    const glm::quat up =
        glm::angleAxis(glm::radians(pose_->pitch - before), glm::vec3(std::cos(yaw), 0, std::sin(yaw)));
    const glm::vec3 offset = glm::angleAxis(-aside, glm::vec3(0, 1, 0)) * (up * (pose_->position - flight.pivot));
    pose_->position = glm::clamp(flight.pivot + offset, -kMaxPosition, kMaxPosition);
  }
  pose_->yaw = std::remainder(pose_->yaw + flight.look.x * kDegreesPerPixel, 360.0f);
  pose_->pitch = std::clamp(pose_->pitch - flight.look.y * kDegreesPerPixel, -kMaxPitch, kMaxPitch);
  if (flight.push != glm::vec3(0)) {
    const float yaw = glm::radians(pose_->yaw);
    const glm::vec3 right{std::cos(yaw), 0, std::sin(yaw)};
    const glm::vec3 direction =
        flight.push.x * right + flight.push.y * glm::vec3(0, 1, 0) + flight.push.z * app::forwardOf(*pose_);
    const float length = glm::length(direction);  // 0 when forward and up cancel out
    if (length > 1e-6f) pose_->position += direction / length * (speed_ * (flight.fast ? kFast : 1) * seconds);
    pose_->position = glm::clamp(pose_->position, -kMaxPosition, kMaxPosition);
  }
  return true;
}

scene::CameraView FlyCamera::view(const scene::CameraView& file) const {
  return pose_ ? app::placed(file, *pose_) : file;
}

}  // namespace tyndall::editor
