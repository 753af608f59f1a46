// Dynamic rendering of a pass: attachments, load and store operations, viewport.
#include <algorithm>

#include "base/assert.hpp"
#include "graph_state.hpp"

namespace tyndall::render {
namespace {

bool rangesMeet(std::uint32_t baseA, std::uint32_t countA, std::uint32_t baseB, std::uint32_t countB) {
  const std::uint64_t endA = countA ? std::uint64_t{baseA} + countA : ~0ull,
                      endB = countB ? std::uint64_t{baseB} + countB : ~0ull;
  return baseA < endB && baseB < endA;
}

bool viewsMeet(const gpu::ViewDesc& a, const gpu::ViewDesc& b) {
  return rangesMeet(a.baseMip, a.mipCount, b.baseMip, b.mipCount) &&
         rangesMeet(a.baseLayer, a.layerCount, b.baseLayer, b.layerCount);
}

// A pass that renders to the same texels twice: two renderings are not ordered by themselves.
void betweenRenderings(VkCommandBuffer commands) {
  VkMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
  barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT |
                                                VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT |
                                                VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
  barrier.srcAccessMask = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;
  barrier.dstAccessMask =
      barrier.srcAccessMask | VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT;
  VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  info.memoryBarrierCount = 1;
  info.pMemoryBarriers = &barrier;
  vkCmdPipelineBarrier2(commands, &info);
}

// DONT_CARE only for the first rendering of a pass that declared to overwrite everything.
VkAttachmentLoadOp loadOp(bool clear, Use use, bool renderedBefore) {
  if (clear) return VK_ATTACHMENT_LOAD_OP_CLEAR;
  return useInfo(use).reads || renderedBefore ? VK_ATTACHMENT_LOAD_OP_LOAD : VK_ATTACHMENT_LOAD_OP_DONT_CARE;
}

}  // namespace

void PassContext::beginRendering(std::vector<ColorAttachment> colors, const DepthAttachment* depth,
                                 std::uint32_t layers) {
  const std::string& pass = graph_.passes[graph_.currentPass].name;
  TY_ASSERT(!graph_.rendering, "pass '" + pass + "' began rendering twice");
  TY_ASSERT(!colors.empty() || depth, "pass '" + pass + "' renders to nothing");
  const std::size_t renderedEarlier = graph_.rendered.size();  // this rendering's attachments are appended behind
  VkExtent2D extent{};
  bool again = false;
  const auto attach = [&](ImageRef image, const gpu::ViewDesc& view, bool clear) {
    const gpu::ImageDesc& d = desc(image);
    const VkExtent2D size{std::max(1u, d.width >> view.baseMip), std::max(1u, d.height >> view.baseMip)};
    TY_ASSERT(extent.width == 0 || (extent.width == size.width && extent.height == size.height),
              "pass '" + pass + "' renders to images of different sizes: '" + d.name + "' is " +
                  std::to_string(size.width) + "x" + std::to_string(size.height) + ", the first " +
                  std::to_string(extent.width) + "x" + std::to_string(extent.height));
    extent = size;
    const Use use = graph_.useOf(image.id);
    const UseInfo info = useInfo(use);
    const auto earlier = graph_.rendered.begin() + static_cast<std::ptrdiff_t>(renderedEarlier);
    const bool before = std::any_of(graph_.rendered.begin(), earlier, [&](const Graph::State::Rendered& r) {
      return r.resource == image.id && viewsMeet(r.view, view);
    });
    again = again || before;
    graph_.rendered.push_back({image.id, view});
    VkRenderingAttachmentInfo attachment{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    // One mip is rendered to; a view of more than one is not allowed as an attachment.
    gpu::ViewDesc oneMip = view;
    if (graph_.resource(image.id, false).rawImage == VK_NULL_HANDLE) oneMip.mipCount = 1;
    attachment.imageView = this->view(image, oneMip);
    attachment.imageLayout = info.layout;
    attachment.loadOp = loadOp(clear, use, before);
    // A store is a write, even of an attachment that is only tested.
    attachment.storeOp = info.writeAccess ? VK_ATTACHMENT_STORE_OP_STORE : VK_ATTACHMENT_STORE_OP_NONE;
    return attachment;
  };

  std::vector<VkRenderingAttachmentInfo> colorInfos;
  for (const ColorAttachment& color : colors) {
    const Use use = graph_.useOf(color.image.id);
    TY_ASSERT(use == Use::kColorWrite || use == Use::kColorReadWrite,
              "pass '" + pass + "' renders colour to '" + desc(color.image).name + "', declared as " + useName(use));
    colorInfos.push_back(attach(color.image, color.view, color.clear));
    colorInfos.back().clearValue.color = color.value;
  }
  VkRenderingAttachmentInfo depthInfo{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
  VkImageAspectFlags depthAspect = 0;
  if (depth) {
    const Use use = graph_.useOf(depth->image.id);
    TY_ASSERT(depth->readOnly ? use == Use::kDepthRead : use == Use::kDepthWrite || use == Use::kDepthReadWrite,
              "pass '" + pass + "' renders depth to '" + desc(depth->image).name + "', declared as " + useName(use));
    TY_ASSERT(!depth->readOnly || !depth->clear, "pass '" + pass + "' clears a depth that it only reads");
    depthAspect = aspectOf(desc(depth->image).format);
    depthInfo = attach(depth->image, depth->view, depth->clear);
    depthInfo.clearValue.depthStencil = {depth->value, 0};
  }
  if (again) betweenRenderings(commands_);

  VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
  info.renderArea.extent = extent;
  info.layerCount = layers;
  info.colorAttachmentCount = static_cast<std::uint32_t>(colorInfos.size());
  info.pColorAttachments = colorInfos.data();
  if (depthAspect & VK_IMAGE_ASPECT_DEPTH_BIT) info.pDepthAttachment = &depthInfo;
  if (depthAspect & VK_IMAGE_ASPECT_STENCIL_BIT) info.pStencilAttachment = &depthInfo;
  vkCmdBeginRendering(commands_, &info);
  graph_.rendering = true;
  const VkViewport viewport{0, 0, static_cast<float>(extent.width), static_cast<float>(extent.height), 0, 1};
  vkCmdSetViewport(commands_, 0, 1, &viewport);
  vkCmdSetScissor(commands_, 0, 1, &info.renderArea);
}

void PassContext::endRendering() {
  TY_ASSERT(graph_.rendering, "endRendering() without beginRendering()");
  vkCmdEndRendering(commands_);
  graph_.rendering = false;
}

}  // namespace tyndall::render
