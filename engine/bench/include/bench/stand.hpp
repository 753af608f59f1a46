// The test stand: one running engine on one level, which renders planned points and takes times and errors.
#pragma once

#include <memory>

#include "app/readback.hpp"
#include "app/session.hpp"
#include "bench/points.hpp"

namespace tyndall::bench {

/// Whether a pass draws the engine's shadow maps.
bool isShadowPass(const render::PassTime& pass);

/// Bytes a second that the session's device copies, read and written.
Result<double> copyRate(app::Session& session);

class Stand {
 public:
  static Result<std::unique_ptr<Stand>> open(std::unique_ptr<app::Catalogue> catalogue, const std::string& device);
  Result<void> setLevel(app::Level level);

  app::Session& session() { return *session_; }
  app::Catalogue& catalogue() { return session_->catalogue(); }

  /// Renders `frames` frames with the settings and keeps the times of the last one; its scattered light if asked for.
  /// Shadow maps are kept from frame to frame (shadows.reuse): see shadowTime().
  Result<void> render(const Assignments& settings, const scene::CameraView& camera, Size size, double seconds,
                      int frameCount, bool scatter);
  /// What the engine's shadow maps take with the settings where nothing is kept, ms.
  Result<double> shadowTime(const Assignments& settings, const scene::CameraView& camera, Size size, double seconds);
  /// The same until nothing of the effect that is chosen by measurement changes any more.
  Result<void> warmUp(const Assignments& settings, const scene::CameraView& camera, Size size, double seconds);

  const std::vector<render::PassTime>& passes() const { return passes_; }  ///< without the copies to the host
  image::FloatImage scatter() const { return readback_.scatter(); }

 private:
  Stand() = default;
  Result<void> frames(const Assignments& settings, const scene::CameraView& camera, Size size, double seconds,
                      int count, bool scatter, bool keepShadows);
  Result<void> frame(const app::FrameRequest& request, bool scatter);
  std::unique_ptr<app::Session> session_;
  app::Readback readback_;  // after the session: its buffers go before the device
  std::vector<render::PassTime> passes_;
};

}  // namespace tyndall::bench
