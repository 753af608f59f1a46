// Ray-traced references, kept on disk: they cost minutes.
#pragma once

#include <functional>
#include <optional>

#include "app/level.hpp"
#include "bench/sweep.hpp"
#include "image/image_io.hpp"
#include "truth/truth.hpp"

namespace tyndall::bench {

struct Truth {
  image::FloatImage scatter;    ///< R,G,B radiance, A transmittance
  std::vector<float> distance;  ///< metres along the ray
};

/// How a camera is turned where it stands, degrees: about the world's vertical (to the left where positive), then about
/// its own horizontal axis (upwards).
struct Turn {
  double yaw = 0, pitch = 0;
};
scene::CameraView turned(const scene::CameraView& start, Turn turn);

/// A small turn that brings a light into the picture, half way from its middle to its edge; of several lights the one
/// that takes the least. The light may still be hidden by what stands before it. None if there is no light, or if the
/// camera is rolled so that no such turn is found.
std::optional<Turn> turnTowardsLight(const std::vector<scene::LightView>& lights, const scene::CameraView& camera,
                                     Size size);

/// From <cache>/truths if it was made before: of the same level (by the content of every file of it), camera and its
/// turn, size, medium, samples and time; else rendered and kept there. A cache that cannot be written only costs time.
/// `progress` as in truth::Settings.
Result<Truth> truthOf(const app::Level& level, std::uint32_t camera, Turn turn, Size size, double seconds,
                      const truth::Medium& medium, std::uint32_t samples, const std::function<bool(double)>& progress);

}  // namespace tyndall::bench
