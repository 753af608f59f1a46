// Shadow maps that outlive a frame: drawn again only when their light or their casters have changed (shadows.reuse).
#pragma once

#include <cstdint>
#include <map>
#include <memory>

#include "base/result.hpp"
#include "frame_data.hpp"
#include "gpu/device.hpp"

namespace tyndall::render {

struct KeptShadowMap {
  gpu::Image image;
  bool drawn = false;         ///< `content` is in the image, which then is in SHADER_READ_ONLY_OPTIMAL
  std::uint64_t content = 0;  ///< contentOf() what was drawn last
};

/// A hash of the casters with their transforms and materials. frame.materialsHash must be set.
std::uint64_t casterContent(const FrameData& frame);

/// A hash of all that a map shows: the casters with their transforms and materials, and the light's matrices.
std::uint64_t shadowContent(const FrameData& frame, const ShadowFit& fit);

class ShadowCache {
 public:
  explicit ShadowCache(gpu::Device& device) : device_(device) {}
  /// The map of light `source` (index into the frame's lights); a new one if there is none of this shape. Frames hold
  /// what they use.
  Result<std::shared_ptr<KeptShadowMap>> map(std::uint32_t source, gpu::ImageDesc desc);
  /// Lets go of all maps but those of these lights.
  void keepOnly(const std::vector<PlannedLight>& lights);
  void clear() { maps_.clear(); }

 private:
  gpu::Device& device_;
  std::map<std::uint32_t, std::shared_ptr<KeptShadowMap>> maps_;
};

}  // namespace tyndall::render
