// What surfaces see of the sky: orthographic depth maps of the casters from directions spread over the upper
// hemisphere. Each direction has up to three nested squares: around the eye, wider, and around the whole level. Maps
// are kept, and drawn again when a caster has changed or the eye has left the middle of a square.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/result.hpp"
#include "frame_data.hpp"
#include "gpu/device.hpp"
#include "shared/sky.h"

namespace tyndall::render {

/// Unit directions towards the sky, each for the same solid angle.
std::vector<glm::vec3> skyDirections();

/// A square around `center` of half side `radius`, seen against `direction`; its depth holds all of `casters`.
shared::SkyMap fitSkyMap(const glm::vec3& direction, const glm::vec3& center, double radius,
                         const scene::Bounds& casters);
glm::mat4 clipFromWorld(const shared::SkyMap& map);

/// A layer of the kept image: what it shows.
struct SkyLayer {
  shared::SkyMap map{};
  std::uint64_t content = 0;
};
struct KeptSky {
  gpu::Image image;  ///< R32F, in SHADER_READ_ONLY_OPTIMAL once drawn
  bool drawn = false;
  std::vector<SkyLayer> layers;
};

/// The part of a frame.
struct SkyFrame {
  shared::SkyBlock block{};
  std::shared_ptr<KeptSky> kept;                          ///< null: nothing hides the sky
  std::vector<std::pair<std::uint32_t, SkyLayer>> drawn;  ///< layers to draw in this frame
};

class SkyMaps {
 public:
  explicit SkyMaps(gpu::Device& device) : device_(device) {}
  /// Every layer that is not what it should be is drawn in this frame: a picture at rest is the right one.
  /// frame.draws, view, resources and materialsHash must be set. Errors: lack of memory.
  Result<std::shared_ptr<const SkyFrame>> plan(const FrameData& frame, float strength);
  void clear() { kept_.reset(); }

 private:
  gpu::Device& device_;
  std::shared_ptr<KeptSky> kept_;
};

}  // namespace tyndall::render
