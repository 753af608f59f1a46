#include "warm_up.hpp"

#include <bit>

namespace tyndall::host {
namespace {

// The least maxUniformBufferRange that Vulkan allows is 16 KiB: no block is larger on every device.
constexpr VkDeviceSize kBufferBytes = 16384;

std::uint32_t side(std::uint32_t texels) { return std::has_single_bit(texels) ? 2 : 3; }

/// An image of the same kind with at most two mips, and the view in it.
void shrink(gpu::ImageDesc& image, gpu::ViewDesc& view) {
  const std::uint32_t last = view.mipCount == 0 ? image.mips - 1 : view.baseMip + view.mipCount - 1;
  view.baseMip = view.baseMip > 0 ? 1 : 0;
  image.mips = last > 0 ? 2 : 1;
  if (view.mipCount != 1) view.mipCount = 0;
  const std::uint32_t layers = view.layerCount == 0 ? image.layers : view.layerCount;
  view.baseLayer = 0;
  image.layers = view.layerCount = layers > 1 ? 2 : 1;
  image.width = side(image.width);
  image.height = side(image.height);
  if (image.type == VK_IMAGE_TYPE_3D) image.depth = side(image.depth);
}

const gpu::ImageDesc& boundImage(const render::EffectInput& input, const Layout& layout, const TyBinding& b,
                                 std::uint32_t light, gpu::ImageDesc& own) {
  const std::uint32_t l = light == TY_NONE ? 0 : light;
  switch (b.source) {
    case TY_SOURCE_SCENE_DEPTH: return input.graph.desc(input.depth);
    case TY_SOURCE_SHADOW_MAP: return input.graph.desc(input.lights[l].shadowMap);
    case TY_SOURCE_SHADOW_MOMENTS: return input.graph.desc(input.lights[l].moments);
    case TY_SOURCE_LIGHT_COOKIE: return input.graph.desc(input.lights[l].cookie);
    case TY_SOURCE_IMAGE: return own = describe(layout.images[b.index]);
    default:
      own.format = VK_FORMAT_R32G32B32A32_SFLOAT;
      own.width = input.view.width;
      own.height = input.view.height;
      return own;
  }
}

}  // namespace

std::string Scratch::key() const {
  std::string key;
  const auto add = [&key](std::uint64_t number) { key += std::to_string(number) + ','; };
  for (const Bound& b : bound) {
    add(b.binding), add(static_cast<std::uint64_t>(b.type));
    if (b.image.format == VK_FORMAT_UNDEFINED) continue;
    add(static_cast<std::uint64_t>(b.image.format)), add(static_cast<std::uint64_t>(b.image.type)), add(b.sampler);
    for (const std::uint32_t n :
         {b.image.width, b.image.height, b.image.depth, b.image.layers, b.image.mips, b.view.baseMip, b.view.mipCount})
      add(n);
    add(b.view.array);
  }
  for (const VkFormat format : colors) add(static_cast<std::uint64_t>(format));
  return key + (depth ? "d" : "");
}

Scratch scratchOf(const render::EffectInput& input, const Layout& layout, const LayoutPass& pass, std::uint32_t light) {
  Scratch scratch;
  for (const TyBinding& b : pass.bindings) {
    Scratch::Bound& bound = scratch.bound.emplace_back();
    bound.binding = b.binding;
    bound.type = b.source == TY_SOURCE_UNIFORM ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER : VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    if (b.source == TY_SOURCE_UNIFORM || b.source == TY_SOURCE_BUFFER) continue;
    const bool sampled = b.access == TY_ACCESS_SAMPLED;
    bound.type = sampled ? VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER : VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    gpu::ImageDesc own;
    bound.image = boundImage(input, layout, b, light, own);
    bound.image.usage = sampled ? VK_IMAGE_USAGE_SAMPLED_BIT : VK_IMAGE_USAGE_STORAGE_BIT;
    if (b.source == TY_SOURCE_LIGHT_COOKIE) {
      const render::ShadowedLight& l = input.lights[light == TY_NONE ? 0 : light];
      bound.view = {0, 0, l.cookieLayer, std::max(1u, l.cookieFaces), true};
    } else {
      bound.view = viewOf(layout, b);
    }
    bound.sampler = b.sampler;
    shrink(bound.image, bound.view);
  }
  for (const TyTarget& t : pass.targets)
    scratch.colors.push_back(t.source == TY_SOURCE_OUTPUT ? VK_FORMAT_R32G32B32A32_SFLOAT
                                                          : vulkanFormat(layout.images[t.index].d.format));
  scratch.depth = pass.depthTarget.has_value();
  return scratch;
}

Result<std::unique_ptr<WarmUp>> WarmUp::create(gpu::Device& device, const Scratch& scratch) {
  std::unique_ptr<WarmUp> made(new WarmUp(device, scratch));
  auto buffer = device.createBuffer({.name = "warm-up",
                                     .size = kBufferBytes,
                                     .usage = VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
  if (!buffer) return buffer.error();
  made->buffer_ = buffer.take();
  const auto add = [&](gpu::ImageDesc desc) -> Result<void> {
    desc.name = "warm-up";
    auto image = device.createImage(desc);
    if (!image) return image.error();
    made->images_.push_back(image.take());
    return {};
  };
  for (const Scratch::Bound& b : scratch.bound) {
    if (b.image.format == VK_FORMAT_UNDEFINED) {
      made->images_.emplace_back();
    } else if (auto added = add(b.image); !added) {
      return added.error();
    }
  }
  for (const VkFormat format : scratch.colors)
    if (auto added = add({.format = format, .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT}); !added)
      return added.error();
  if (scratch.depth)
    if (auto added = add({.format = VK_FORMAT_D32_SFLOAT, .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT});
        !added)
      return added.error();
  return made;
}

void WarmUp::record(VkCommandBuffer commands, const gpu::Pipeline& pipeline) const {
  for (const gpu::Image& image : images_)
    if (image) gpu::transition(commands, image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL);
  vkCmdBindPipeline(commands, pipeline.bindPoint(), pipeline.handle());
  gpu::Descriptors descriptors(commands, pipeline);
  for (std::size_t i = 0; i < scratch_.bound.size(); ++i) {
    const Scratch::Bound& b = scratch_.bound[i];
    switch (b.type) {
      case VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER:
        descriptors.uniformBuffer(b.binding, buffer_.handle(), 0, kBufferBytes);
        break;
      case VK_DESCRIPTOR_TYPE_STORAGE_BUFFER: descriptors.storageBuffer(b.binding, buffer_.handle()); break;
      case VK_DESCRIPTOR_TYPE_STORAGE_IMAGE: descriptors.storageImage(b.binding, images_[i].view(b.view)); break;
      default:
        descriptors.sampled(b.binding, images_[i].view(b.view), samplerOf(device_, b.sampler), VK_IMAGE_LAYOUT_GENERAL);
    }
  }
  descriptors.push();
  if (pipeline.bindPoint() == VK_PIPELINE_BIND_POINT_COMPUTE)
    vkCmdDispatch(commands, 0, 0, 0);
  else
    draw(commands);
}

/// The one triangle, clipped to nothing.
void WarmUp::draw(VkCommandBuffer commands) const {
  std::vector<VkRenderingAttachmentInfo> targets;
  for (std::size_t i = scratch_.bound.size(); i < images_.size(); ++i) {
    VkRenderingAttachmentInfo& target = targets.emplace_back();
    target.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
    target.imageView = images_[i].view();
    target.imageLayout = VK_IMAGE_LAYOUT_GENERAL;
    target.loadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
    target.storeOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
  }
  VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
  rendering.renderArea.extent = {1, 1};
  rendering.layerCount = 1;
  rendering.colorAttachmentCount = static_cast<std::uint32_t>(scratch_.colors.size());
  rendering.pColorAttachments = targets.data();
  if (scratch_.depth) rendering.pDepthAttachment = &targets.back();
  vkCmdBeginRendering(commands, &rendering);
  const VkViewport viewport{0, 0, 1, 1, 0, 1};
  const VkRect2D nothing{};
  vkCmdSetViewport(commands, 0, 1, &viewport);
  vkCmdSetScissor(commands, 0, 1, &nothing);
  vkCmdDraw(commands, 3, 1, 0, 0);
  vkCmdEndRendering(commands);
}

}  // namespace tyndall::host
