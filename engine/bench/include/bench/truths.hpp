// Ray-traced references, kept on disk: they cost minutes.
#pragma once

#include <functional>

#include "app/level.hpp"
#include "bench/sweep.hpp"
#include "image/image_io.hpp"
#include "truth/truth.hpp"

namespace tyndall::bench {

struct Truth {
  image::FloatImage scatter;    ///< R,G,B radiance, A transmittance
  std::vector<float> distance;  ///< metres along the ray
};

/// The camera turned about the world's vertical where it stands, degrees.
scene::CameraView turned(const scene::CameraView& start, double degrees);

/// A number made of a level's file and a text; of the text alone if there is no such level.
std::uint64_t levelHash(const std::string& level, const std::string& text);

/// From <cache>/truths if it was made before: of the same level file (by content), camera, turned by so many `degrees`, size, medium, samples and time; else rendered and kept
/// there. A cache that cannot be written only costs time. `progress` as in truth::Settings.
Result<Truth> truthOf(const app::Level& level, std::uint32_t camera, double degrees, Size size, double seconds, const truth::Medium& medium, std::uint32_t samples,
                      const std::function<bool(double)>& progress);

}  // namespace tyndall::bench
