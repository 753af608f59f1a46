// What a picture's luminances and distances say: the exposure that suits it, what the air hides. Two dispatches;
// the result stays on the GPU for the composite and is copied for the host.
#pragma once

#include <array>
#include <cstdint>

#include "passes.hpp"
#include "shared/exposure.h"

namespace tyndall::render {

class ExposureMeter {
 public:
  static Result<ExposureMeter> create(gpu::Device& device);

  /// Looks at at most 65,536 pixels, evenly spread. `seconds` since the last time: how far the factor has moved towards
  /// what the picture asks for; below 0: all the way. Returns the slot that the host reads once the frame is done.
  Result<std::uint32_t> addPass(Graph& graph, const PassTools& tools, const View& view, ImageRef color,
                                ImageRef scatter, ImageRef depth, float seconds);
  /// What the pass of that slot wrote.
  shared::MeteredBlock read(std::uint32_t slot) const;
  /// MeteredBlock, as the pass left it; zeros before the first.
  const gpu::Buffer& metered() const { return metered_; }

 private:
  static constexpr std::uint32_t kSlots = 4;  // as BlockRing: two frames in flight, one declared, one read
  gpu::Buffer counts_, metered_;
  std::array<gpu::Buffer, kSlots> copies_;
  std::uint32_t next_ = 0;
};

}  // namespace tyndall::render
