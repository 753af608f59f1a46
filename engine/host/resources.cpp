#include "resources.hpp"

namespace tyndall::host {
namespace {

/// What passes and debug views do with an image; transients are also sampled and copied from (render graph).
VkImageUsageFlags usageOf(const Layout& layout, std::uint32_t index) {
  const TyImage& image = layout.images[index].d;
  VkImageUsageFlags usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  if (image.flags & TY_RESOURCE_HISTORY) usage |= VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  if (image.format == TY_FORMAT_D32_FLOAT) usage |= VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
  for (const LayoutPass& pass : layout.passes) {
    for (const TyBinding& b : pass.bindings)
      if (b.source == TY_SOURCE_IMAGE && b.index == index && b.access != TY_ACCESS_SAMPLED)
        usage |= VK_IMAGE_USAGE_STORAGE_BIT;
    for (const TyTarget& t : pass.targets)
      if (t.source == TY_SOURCE_IMAGE && t.index == index) usage |= VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
  }
  return usage;
}

bool filteredLinearly(const Layout& layout, std::uint32_t index) {
  for (const LayoutPass& pass : layout.passes)
    for (const TyBinding& b : pass.bindings)
      if (b.source == TY_SOURCE_IMAGE && b.index == index && b.access == TY_ACCESS_SAMPLED &&
          b.sampler != TY_SAMPLER_NEAREST_CLAMP && b.sampler != TY_SAMPLER_NEAREST_REPEAT)
        return true;
  return false;
}

bool blendedInto(const Layout& layout, std::uint32_t index) {
  for (const LayoutPass& pass : layout.passes)
    for (const TyTarget& t : pass.targets)
      if (t.source == TY_SOURCE_IMAGE && t.index == index && t.blend != TY_BLEND_NONE) return true;
  return false;
}

Result<void> supported(gpu::Device& device, const Layout& layout, std::uint32_t index, const gpu::ImageDesc& desc) {
  VkFormatProperties format{};
  vkGetPhysicalDeviceFormatProperties(device.physical(), desc.format, &format);
  VkFormatFeatureFlags needed = 0;
  if (filteredLinearly(layout, index)) needed |= VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT;
  if (blendedInto(layout, index)) needed |= VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT;
  VkImageFormatProperties most{};
  const VkResult result = vkGetPhysicalDeviceImageFormatProperties(device.physical(), desc.format, desc.type,
                                                                   VK_IMAGE_TILING_OPTIMAL, desc.usage, 0, &most);
  const bool fits = result == VK_SUCCESS && (format.optimalTilingFeatures & needed) == needed &&
                    desc.width <= most.maxExtent.width && desc.height <= most.maxExtent.height &&
                    desc.depth <= most.maxExtent.depth && desc.layers <= most.maxArrayLayers &&
                    desc.mips <= most.maxMipLevels && imageBytes(layout.images[index].d) <= most.maxResourceSize;
  if (fits) return {};
  const auto megabytes = [](std::uint64_t bytes) { return std::to_string(bytes >> 20) + " MiB"; };
  return failed("image '" + desc.name + "': the device cannot make one of " + std::to_string(desc.width) + "x" +
                std::to_string(desc.height) + " with " + std::to_string(std::max(desc.layers, desc.depth)) +
                " layers, " + megabytes(imageBytes(layout.images[index].d)) + "; its limits are " +
                std::to_string(most.maxExtent.width) + "x" + std::to_string(most.maxExtent.height) + ", " +
                std::to_string(most.maxArrayLayers) + " layers, " + megabytes(most.maxResourceSize) +
                "; smaller maps make room");
}

}  // namespace

VkFormat vulkanFormat(std::uint32_t format) {
  static constexpr VkFormat kFormats[] = {VK_FORMAT_UNDEFINED,           VK_FORMAT_R8_UNORM,
                                          VK_FORMAT_R8G8B8A8_UNORM,      VK_FORMAT_A2B10G10R10_UNORM_PACK32,
                                          VK_FORMAT_R16_UNORM,           VK_FORMAT_R16G16_UNORM,
                                          VK_FORMAT_R16G16B16A16_UNORM,  VK_FORMAT_R16_SFLOAT,
                                          VK_FORMAT_R16G16_SFLOAT,       VK_FORMAT_R16G16B16A16_SFLOAT,
                                          VK_FORMAT_R32_SFLOAT,          VK_FORMAT_R32G32_SFLOAT,
                                          VK_FORMAT_R32G32B32A32_SFLOAT, VK_FORMAT_R32_UINT,
                                          VK_FORMAT_R32G32_UINT,         VK_FORMAT_R32G32B32A32_UINT,
                                          VK_FORMAT_D32_SFLOAT};
  return format < std::size(kFormats) ? kFormats[format] : VK_FORMAT_UNDEFINED;
}

VkSampler samplerOf(gpu::Device& device, std::uint32_t sampler) {
  VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  const bool linear = sampler == TY_SAMPLER_LINEAR_CLAMP || sampler == TY_SAMPLER_LINEAR_REPEAT ||
                      sampler == TY_SAMPLER_LINEAR_MIPMAP_CLAMP || sampler == TY_SAMPLER_LINEAR_MIPMAP_REPEAT;
  const bool repeat = sampler == TY_SAMPLER_NEAREST_REPEAT || sampler == TY_SAMPLER_LINEAR_REPEAT ||
                      sampler == TY_SAMPLER_LINEAR_MIPMAP_REPEAT;
  const bool mipmap = sampler == TY_SAMPLER_LINEAR_MIPMAP_CLAMP || sampler == TY_SAMPLER_LINEAR_MIPMAP_REPEAT;
  info.magFilter = info.minFilter = linear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
  info.mipmapMode = mipmap ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST;
  info.addressModeU = info.addressModeV = info.addressModeW =
      repeat ? VK_SAMPLER_ADDRESS_MODE_REPEAT : VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  info.maxLod = VK_LOD_CLAMP_NONE;
  return device.sampler(info);
}

gpu::ImageDesc describe(const LayoutImage& image) {
  gpu::ImageDesc desc;
  desc.name = image.name;
  desc.format = vulkanFormat(image.d.format);
  desc.width = image.d.width;
  desc.height = image.d.height;
  desc.mips = image.d.mips;
  if (image.d.kind == TY_IMAGE_3D) {
    desc.type = VK_IMAGE_TYPE_3D;
    desc.depth = image.d.depth;
  } else {
    desc.layers = image.d.depth;
  }
  return desc;
}

gpu::ViewDesc viewOf(const Layout& layout, const TyBinding& binding) {
  gpu::ViewDesc view{binding.base_mip, binding.mip_count, binding.base_layer, binding.layer_count, false};
  // A storage descriptor reaches one mip.
  if (binding.access != TY_ACCESS_SAMPLED) view.mipCount = 1;
  view.array = binding.source == TY_SOURCE_SHADOW_MAP || binding.source == TY_SOURCE_SHADOW_MOMENTS ||
               (binding.source == TY_SOURCE_IMAGE && layout.images[binding.index].d.kind == TY_IMAGE_2D_ARRAY);
  return view;
}

Result<Resources> makeResources(gpu::Device& device, const Layout& layout) {
  Resources r;
  r.images.resize(layout.images.size());
  r.buffers.resize(layout.buffers.size());
  for (std::uint32_t i = 0; i < layout.images.size(); ++i) {
    gpu::ImageDesc desc = describe(layout.images[i]);
    desc.usage = usageOf(layout, i);
    if (auto fits = supported(device, layout, i, desc); !fits) return fits.error();
    if (!isHistory(layout.images[i])) continue;
    auto image = device.createImage(desc);
    if (!image) return image.error();
    r.images[i] = image.take();
  }
  for (std::uint32_t i = 0; i < layout.buffers.size(); ++i) {
    if (!isHistory(layout.buffers[i])) continue;
    auto buffer =
        device.createBuffer({.name = layout.buffers[i].name,
                             .size = layout.buffers[i].d.size,
                             .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT |
                                      VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT});
    if (!buffer) return buffer.error();
    r.buffers[i] = buffer.take();
  }
  if (layout.counters && !layout.counters->names.empty())
    for (gpu::Buffer& slot : r.counterSlots) {
      auto buffer = device.createBuffer({.name = "counters read back",
                                         .size = 4 * layout.counters->names.size(),
                                         .usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                         .hostVisible = true});
      if (!buffer) return buffer.error();
      slot = buffer.take();
    }
  return r;
}

}  // namespace tyndall::host
