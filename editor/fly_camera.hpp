// A camera flown by hand. Until it is moved it follows the file's camera (which may be animated).
#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "app/pose.hpp"
#include "scene/scene.hpp"

namespace tyndall::editor {

/// What the user asks for in one frame.
struct Flight {
  glm::vec3 push{0};  ///< right, up (of the world), forward; each -1, 0 or 1
  bool fast = false;
  glm::vec2 look{0};   ///< pixels that the mouse was dragged: right, down
  glm::vec2 orbit{0};  ///< the same, to go round `pivot`, which stays where it is in the picture
  glm::vec3 pivot{0};  ///< world
  float wheel = 0;     ///< notches: speed
  bool any() const { return push != glm::vec3(0) || look != glm::vec2(0) || orbit != glm::vec2(0) || wheel != 0; }
};

class FlyCamera {
 public:
  /// `reach` is the level's size in metres: a second's flight crosses about a tenth of it at first.
  explicit FlyCamera(float reach);

  /// Moves by `seconds` of flight. True when the view changed.
  bool fly(const Flight& flight, float seconds, const scene::CameraView& file);
  /// Back to the file's camera.
  void reset() { pose_.reset(); }

  /// Lens and, unless flown, pose are the file's. Flown, the horizon is level: the file's roll is dropped.
  scene::CameraView view(const scene::CameraView& file) const;
  bool flown() const { return pose_.has_value(); }
  /// Where it was flown to; nothing while it follows the file's.
  const std::optional<app::Pose>& pose() const { return pose_; }
  void setPose(const std::optional<app::Pose>& pose) { pose_ = pose; }
  float speed() const { return speed_; }  ///< m/s

 private:
  std::optional<app::Pose> pose_;
  float speed_ = 1;
};

}  // namespace tyndall::editor
