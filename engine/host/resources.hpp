// The images and buffers of a layout: what the host keeps itself (history, read-back counters), and how the rest is
// described to the graph.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "gpu/device.hpp"
#include "host/layout.hpp"
#include "uniforms.hpp"

namespace tyndall::host {

VkFormat vulkanFormat(std::uint32_t format);                      ///< of a TyFormat
VkSampler samplerOf(gpu::Device& device, std::uint32_t sampler);  ///< of a TySampler
gpu::ImageDesc describe(const LayoutImage& image);                ///< without usage
gpu::ViewDesc viewOf(const Layout& layout, const TyBinding& binding);

/// Everything of one layout that outlives a frame.
struct Resources {
  std::vector<gpu::Image> images;  ///< filled where the layout says history, empty elsewhere
  std::vector<gpu::Buffer> buffers;
  std::array<gpu::Buffer, kFrameSlots> counterSlots;  ///< host-visible, if there are counters
  bool historyCleared = false;  ///< zeroed by a recorded frame (history starts as zeros, never as garbage)
};

/// Refuses an image that the device cannot make for the uses the layout has for it, then makes what is kept.
Result<Resources> makeResources(gpu::Device& device, const Layout& layout);

}  // namespace tyndall::host
