// One running engine on one level, for tests that render many settings: no process and no level load a picture.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "app/pose.hpp"
#include "app/readback.hpp"
#include "app/session.hpp"
#include "image/image_io.hpp"
#include "image/metrics.hpp"

namespace tyndall::figures {

using Settings = std::vector<std::string>;  ///< "id=value"
Settings operator+(Settings a, const Settings& b);

/// One picture with the times of its passes.
struct Shot {
  image::FloatImage scatter;
  std::vector<render::PassTime> passes;
  /// Of the passes that the plugin owns, ms; 0 if there is none whose name starts with `name` ("": all).
  double pluginMs(const std::string& name = "") const;
};

/// Errors end the program's test by a thrown std::runtime_error: a laboratory without a device has nothing to say.
class Laboratory {
 public:
  Laboratory(const std::string& level, std::uint32_t camera, std::uint32_t width, std::uint32_t height);

  /// Defaults but for shadows.reuse=true, then `settings`; two frames, the second is kept (the first compiles).
  Shot shoot(const Settings& settings);
  /// A debug view by name with defaults and `settings`.
  image::ByteImage look(const Settings& settings, const std::string& view);
  /// `frames` more of the present settings, times only.
  std::vector<Shot> again(int frames);
  /// Ray-traced, `samples` shadow rays a view ray; kept in the cache folder of the build, since it costs minutes.
  image::FloatImage truth(std::uint32_t samples);
  /// Time of the level's animations, s.
  void at(double seconds) { request_.seconds = seconds; }
  /// Turns the camera about the world's vertical by `degrees` from where it was.
  void turn(double degrees);
  /// Stands the camera elsewhere, with its lens.
  void pose(const app::Pose& pose) { request_.camera = app::placed(start_, pose); }
  /// Pixel coordinates (from the upper left corner, y down) of the lamps' places, or of where the suns stand, that lie
  /// before the camera as the level has it; they may lie outside the picture.
  std::vector<glm::vec2> lightsInPicture() const;

  app::Session& session() { return *session_; }
  const std::string& device() const { return session_->device().info().name; }

 private:
  Shot frame();
  std::string level_;
  std::uint32_t cameraIndex_;
  scene::CameraView start_;
  app::FrameRequest request_;
  std::unique_ptr<app::Session> session_;
  app::Readback readback_;  // after the session: its buffers go before the device
};

/// Of `picture` against `reference`; throws if they cannot be compared.
image::ErrorMetrics errorOf(const image::FloatImage& picture, const image::FloatImage& reference);

}  // namespace tyndall::figures
