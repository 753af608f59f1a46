#include "fly_camera.hpp"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace tyndall::editor {
namespace {

constexpr float kRadiansPerPixel = 0.004f;    // a drag across 1280 pixels turns by 290 degrees
constexpr float kSpeedPerNotch = 1.25f;       // three notches double the speed
constexpr float kFast = 4;                    // with Shift
constexpr float kMaxPitch = glm::half_pi<float>() - 0.01f;  // straight up has no horizon
constexpr float kMinSpeed = 0.01f, kMaxSpeed = 10000;       // m/s

}  // namespace

FlyCamera::FlyCamera(float reach) : speed_(std::clamp(reach / 10, 0.1f, 100.0f)) {}

glm::vec3 FlyCamera::forward() const {
  return {std::sin(yaw_) * std::cos(pitch_), std::sin(pitch_), -std::cos(yaw_) * std::cos(pitch_)};
}

void FlyCamera::takeOff(const scene::CameraView& file) {
  const glm::vec3 ahead = -glm::vec3(file.worldFromView[2]);
  position_ = glm::vec3(file.worldFromView[3]);
  yaw_ = std::atan2(ahead.x, -ahead.z);
  pitch_ = std::clamp(std::asin(std::clamp(ahead.y, -1.0f, 1.0f)), -kMaxPitch, kMaxPitch);
  flown_ = true;
}

bool FlyCamera::fly(const Flight& flight, float seconds, const scene::CameraView& file) {
  if (flight.wheel != 0) speed_ = std::clamp(speed_ * std::pow(kSpeedPerNotch, flight.wheel), kMinSpeed, kMaxSpeed);
  const bool moves = flight.push != glm::vec3(0) || flight.look != glm::vec2(0);
  if (!moves) return false;
  if (!flown_) takeOff(file);
  yaw_ = std::remainder(yaw_ + flight.look.x * kRadiansPerPixel, glm::two_pi<float>());
  pitch_ = std::clamp(pitch_ - flight.look.y * kRadiansPerPixel, -kMaxPitch, kMaxPitch);
  if (flight.push != glm::vec3(0)) {
    const glm::vec3 right{std::cos(yaw_), 0, std::sin(yaw_)};
    const glm::vec3 direction = flight.push.x * right + flight.push.y * glm::vec3(0, 1, 0) + flight.push.z * forward();
    const float length = glm::length(direction);  // 0 when forward and up cancel out
    if (length > 1e-6f) position_ += direction / length * (speed_ * (flight.fast ? kFast : 1) * seconds);
  }
  return true;
}

scene::CameraView FlyCamera::view(const scene::CameraView& file) const {
  if (!flown_) return file;
  scene::CameraView view = file;
  view.worldFromView = glm::inverse(glm::lookAt(position_, position_ + forward(), glm::vec3(0, 1, 0)));
  return view;
}

}  // namespace tyndall::editor
