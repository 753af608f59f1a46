// Makes a driver compile a pipeline's code before the frame that needs it.
//
// Some drivers compile when a pipeline is made, and have nothing left to do here. Mesa's llvmpipe compiles at the first
// dispatch or draw, for the formats and kinds of the images bound (whether their sides are powers of two included) and
// for their samplers. So a dispatch of no workgroups with tiny images of the same kind does it, and touches nothing.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "built.hpp"

namespace tyndall::host {

/// What is bound in a run of a pass, in small.
struct Scratch {
  struct Bound {
    std::uint32_t binding = 0;
    VkDescriptorType type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    gpu::ImageDesc image;  ///< of images
    gpu::ViewDesc view;
    std::uint32_t sampler = 0;  ///< TySampler
  };
  std::vector<Bound> bound;
  std::vector<VkFormat> colors;  ///< targets of a full-screen pass
  bool depth = false;            ///< it has a depth target

  std::string key() const;  ///< equal where a driver sees no difference
};
/// `light`: of a per-light run, else TY_NONE.
Scratch scratchOf(const render::EffectInput& input, const Layout& layout, const LayoutPass& pass, std::uint32_t light);

class WarmUp {
 public:
  static Result<std::unique_ptr<WarmUp>> create(gpu::Device& device, const Scratch& scratch);
  /// Outside of a rendering. Both objects must live until the commands have run.
  void record(VkCommandBuffer commands, const gpu::Pipeline& pipeline) const;

 private:
  WarmUp(gpu::Device& device, const Scratch& scratch) : device_(device), scratch_(scratch) {}
  void draw(VkCommandBuffer commands) const;
  gpu::Device& device_;
  Scratch scratch_;
  gpu::Buffer buffer_;
  std::vector<gpu::Image> images_;  ///< of each binding, empty for buffers; then the targets
};

}  // namespace tyndall::host
