// Pictures rendered by bin/tyndall for the quality tests, and small levels made for them.
#pragma once

#include <string>
#include <vector>

#include "image/image_io.hpp"
#include "image/metrics.hpp"
#include "process.hpp"
#include "scene/scene.hpp"

namespace tyndall::quality {

using Arguments = std::vector<std::string>;

class QualityTest : public cli::CliTest {
 protected:
  /// In-scattered radiance of `level` at 320x180; `settings` are "id=value".
  image::FloatImage scatter(const std::string& level, const Arguments& settings) const;
  image::FloatImage distance(const std::string& level) const;
  /// The same by ray tracing, with `samples` shadow rays a view ray.
  image::FloatImage truth(const std::string& level, int samples) const;
  image::FloatImage read(const std::string& name) const;

  /// Writes a level with one sun and one camera, returns its file name.
  std::string writeLevel(const std::string& name, const std::vector<scene::Primitive>& primitives,
                         const glm::vec3& sunTravels, const scene::Camera& lens = kLens) const;
  inline static const scene::Camera kLens{"eye", 0.9f, 0.1f, 60.0f};
};

/// nRMSE with respect to `reference`, over RGB.
double nRmse(const image::FloatImage& picture, const image::FloatImage& reference);

/// A horizontal rectangle at height y, both sides visible.
scene::Primitive plate(float x0, float x1, float z0, float z1, float y);

}  // namespace tyndall::quality
