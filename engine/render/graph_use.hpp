// What each Use means to Vulkan: stages, accesses, image layout, usage flags.
#pragma once

#include "render/graph.hpp"

namespace tyndall::render {

struct UseInfo {
  VkPipelineStageFlags2 stages = 0;
  VkAccessFlags2 access = 0;                         ///< reads and writes together
  VkAccessFlags2 writeAccess = 0;                    ///< the writes among them; 0 for a read
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;  ///< UNDEFINED: not a use of images
  VkImageUsageFlags imageUsage = 0;
  VkBufferUsageFlags bufferUsage = 0;  ///< 0: not a use of buffers
  bool reads = false;                  ///< needs what was there before
  bool replaces = false;               ///< overwrites every texel of the subresources it touches
};

UseInfo useInfo(Use use);
const char* useName(Use use);

}  // namespace tyndall::render
