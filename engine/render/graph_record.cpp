// Recording: barriers, pass, timestamp, one after the other.
#include <algorithm>

#include "base/assert.hpp"
#include "graph_state.hpp"

namespace tyndall::render {

VkImageAspectFlags aspectOf(VkFormat format) {
  switch (format) {
    case VK_FORMAT_D16_UNORM:
    case VK_FORMAT_X8_D24_UNORM_PACK32:
    case VK_FORMAT_D32_SFLOAT: return VK_IMAGE_ASPECT_DEPTH_BIT;
    case VK_FORMAT_S8_UINT: return VK_IMAGE_ASPECT_STENCIL_BIT;
    case VK_FORMAT_D16_UNORM_S8_UINT:
    case VK_FORMAT_D24_UNORM_S8_UINT:
    case VK_FORMAT_D32_SFLOAT_S8_UINT: return VK_IMAGE_ASPECT_DEPTH_BIT | VK_IMAGE_ASPECT_STENCIL_BIT;
    default: return VK_IMAGE_ASPECT_COLOR_BIT;
  }
}

void Graph::State::recordBarriers(VkCommandBuffer commands, const std::vector<plan::Barrier>& list) const {
  std::vector<VkMemoryBarrier2> memoryBarriers;
  std::vector<VkImageMemoryBarrier2> imageBarriers;
  for (const plan::Barrier& barrier : list) {
    if (barrier.resource == plan::Barrier::kMemory) {
      VkMemoryBarrier2& b = memoryBarriers.emplace_back(VkMemoryBarrier2{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2});
      b.srcStageMask = barrier.sourceStages;
      b.srcAccessMask = barrier.sourceAccess;
      b.dstStageMask = barrier.targetStages;
      b.dstAccessMask = barrier.targetAccess;
    } else {
      const GraphResource& resource = resources[barrier.resource];
      VkImageMemoryBarrier2& b =
          imageBarriers.emplace_back(VkImageMemoryBarrier2{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2});
      b.srcStageMask = barrier.sourceStages;
      b.srcAccessMask = barrier.sourceAccess;
      b.dstStageMask = barrier.targetStages;
      b.dstAccessMask = barrier.targetAccess;
      b.oldLayout = barrier.oldLayout;
      b.newLayout = barrier.newLayout;
      b.srcQueueFamilyIndex = b.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
      b.image = imageHandle(resource);
      b.subresourceRange = {aspectOf(resource.imageDesc.format), 0, VK_REMAINING_MIP_LEVELS, 0,
                            VK_REMAINING_ARRAY_LAYERS};
    }
  }
  if (memoryBarriers.empty() && imageBarriers.empty()) return;
  VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  info.memoryBarrierCount = static_cast<std::uint32_t>(memoryBarriers.size());
  info.pMemoryBarriers = memoryBarriers.data();
  info.imageMemoryBarrierCount = static_cast<std::uint32_t>(imageBarriers.size());
  info.pImageMemoryBarriers = imageBarriers.data();
  vkCmdPipelineBarrier2(commands, &info);
}

namespace {
// Null when the debug-utils extension is not enabled.
void beginLabel(VkCommandBuffer commands, const GraphPass& pass) {
  if (!vkCmdBeginDebugUtilsLabelEXT) return;
  const std::string name = pass.owner == "engine" ? pass.name : pass.owner + ": " + pass.name;
  VkDebugUtilsLabelEXT label{VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT};
  label.pLabelName = name.c_str();
  vkCmdBeginDebugUtilsLabelEXT(commands, &label);
}

void endLabel(VkCommandBuffer commands) {
  if (vkCmdEndDebugUtilsLabelEXT) vkCmdEndDebugUtilsLabelEXT(commands);
}
}  // namespace

void Graph::record(VkCommandBuffer commands, gpu::Timestamps* timestamps) {
  State& s = *state_;
  TY_ASSERT(s.compiled, "record() before compile()");
  TY_ASSERT(s.compileId == s.memory.compiles,
            "another graph has compiled on this GraphMemory since; record before that");
  TY_ASSERT(
      !timestamps || timestamps->capacity() >= s.statistics.passesRun,
      std::to_string(timestamps->capacity()) + " timestamps for " + std::to_string(s.statistics.passesRun) + " passes");

  std::uint32_t lastPass = ~0u;
  for (std::uint32_t p = 0; p < s.passes.size(); ++p)
    if (s.kept[p]) lastPass = p;
  if (timestamps) timestamps->begin(commands);
  for (std::uint32_t p = 0; p < s.passes.size(); ++p) {
    if (!s.kept[p]) continue;
    const GraphPass& pass = s.passes[p];
    beginLabel(commands, pass);
    s.recordBarriers(commands, s.barriers.before[p]);
    s.currentPass = p;
    s.rendered.clear();
    PassContext context(s, commands);
    pass.record(context);
    TY_ASSERT(!s.rendering, "pass '" + pass.name + "' lacks endRendering()");
    if (p == lastPass)
      s.recordBarriers(commands, s.barriers.after);  // inside the last span, so that spans sum to the frame
    endLabel(commands);
    if (timestamps && !pass.idle) timestamps->mark(commands);
  }
  s.currentPass = ~0u;
  if (lastPass == ~0u) s.recordBarriers(commands, s.barriers.after);

  for (std::uint32_t r = 0; r < s.resources.size(); ++r)
    if (s.resources[r].physical != ~0u) s.memory.resources[s.resources[r].physical].pending = s.barriers.pending[r];
}

}  // namespace tyndall::render
