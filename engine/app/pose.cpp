#include "app/pose.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

namespace tyndall::app {
namespace {

// Beyond this a float's steps are coarser than 6 cm, and no level is as large.
constexpr float kMaxPosition = 1e6f;  // metres
constexpr float kMaxYaw = 360;        // degrees

}  // namespace

glm::vec3 forwardOf(const Pose& pose) {
  const float yaw = glm::radians(pose.yaw), pitch = glm::radians(pose.pitch);
  return {std::sin(yaw) * std::cos(pitch), std::sin(pitch), -std::cos(yaw) * std::cos(pitch)};
}

Pose poseOf(const scene::CameraView& view) {
  const glm::vec3 ahead = -glm::vec3(view.worldFromView[2]);
  Pose pose;
  pose.position = glm::vec3(view.worldFromView[3]);
  pose.yaw = glm::degrees(std::atan2(ahead.x, -ahead.z));
  pose.pitch = glm::degrees(std::asin(std::clamp(ahead.y, -1.0f, 1.0f)));
  return pose;
}

scene::CameraView placed(const scene::CameraView& lens, const Pose& pose) {
  const float yaw = glm::radians(pose.yaw);
  // The horizon gives the right hand, so that looking straight up is a view like any other.
  const glm::vec3 forward = forwardOf(pose), right{std::cos(yaw), 0, std::sin(yaw)};
  scene::CameraView view = lens;
  view.worldFromView = glm::mat4(glm::vec4(right, 0), glm::vec4(glm::normalize(glm::cross(right, forward)), 0),
                                 glm::vec4(-forward, 0), glm::vec4(pose.position, 1));
  return view;
}

Result<Pose> readPose(const std::string& option, const std::string& text) {
  const Error wrong =
      badCall(option + " '" + text +
              "': must be X,Y,Z,YAW,PITCH: metres within 1000000, degrees, yaw within 360 and pitch within 90");
  std::array<float, 5> numbers{};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0 && (at == end || *at++ != ',')) return wrong;
    const auto [next, code] = std::from_chars(at, end, numbers[i]);
    if (code != std::errc{} || !std::isfinite(numbers[i])) return wrong;
    at = next;
  }
  const Pose pose{{numbers[0], numbers[1], numbers[2]}, numbers[3], numbers[4]};
  const bool inside = std::abs(pose.position.x) <= kMaxPosition && std::abs(pose.position.y) <= kMaxPosition &&
                      std::abs(pose.position.z) <= kMaxPosition && std::abs(pose.yaw) <= kMaxYaw &&
                      std::abs(pose.pitch) <= 90;
  if (at != end || !inside) return wrong;
  return pose;
}

std::string poseText(const Pose& pose) {
  std::string text;
  for (const float number : {pose.position.x, pose.position.y, pose.position.z, pose.yaw, pose.pitch}) {
    char digits[32];  // the shortest text that reads back to the same float
    const auto end = std::to_chars(digits, digits + sizeof digits, number);
    text += (text.empty() ? "" : ",") + std::string(digits, end.ptr);
  }
  return text;
}

}  // namespace tyndall::app
