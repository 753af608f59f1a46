#include "textures.hpp"

#include <algorithm>
#include <bit>
#include <span>

#include "base/assert.hpp"

namespace tyndall::render {

namespace {

// Moves one mip between layouts; uploads are rare, so full stages.
void mipBarrier(VkCommandBuffer commands, VkImage image, std::uint32_t mip, VkImageLayout from, VkImageLayout to) {
  VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
  barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
  barrier.oldLayout = from;
  barrier.newLayout = to;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image;
  barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, mip, 1, 0, 1};
  VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  dependency.imageMemoryBarrierCount = 1;
  dependency.pImageMemoryBarriers = &barrier;
  vkCmdPipelineBarrier2(commands, &dependency);
}

VkOffset3D mipCorner(const gpu::ImageDesc& desc, std::uint32_t mip) {
  return {static_cast<std::int32_t>(std::max(1u, desc.width >> mip)),
          static_cast<std::int32_t>(std::max(1u, desc.height >> mip)), 1};
}

// Each mip is blitted from the last; blits of sRGB formats average linear light.
void generateMips(VkCommandBuffer commands, const gpu::Image& image) {
  const gpu::ImageDesc& desc = image.desc();
  mipBarrier(commands, image.handle(), 0, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
             VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
  for (std::uint32_t mip = 1; mip < desc.mips; ++mip) {
    mipBarrier(commands, image.handle(), mip, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    VkImageBlit blit{};
    blit.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip - 1, 0, 1};
    blit.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip, 0, 1};
    blit.srcOffsets[1] = mipCorner(desc, mip - 1);
    blit.dstOffsets[1] = mipCorner(desc, mip);
    vkCmdBlitImage(commands, image.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, image.handle(),
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &blit, VK_FILTER_LINEAR);
    mipBarrier(commands, image.handle(), mip, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
               VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
  }
  gpu::transition(commands, image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
}

VkSamplerAddressMode address(scene::Wrap wrap) {
  switch (wrap) {
    case scene::Wrap::kRepeat: return VK_SAMPLER_ADDRESS_MODE_REPEAT;
    case scene::Wrap::kClampToEdge: return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    case scene::Wrap::kMirroredRepeat: break;
  }
  return VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT;
}

VkFilter filter(scene::Filter f) { return f == scene::Filter::kNearest ? VK_FILTER_NEAREST : VK_FILTER_LINEAR; }

}  // namespace

Result<gpu::Image> uploadTexture(gpu::Device& device, const scene::Image& image, bool srgb) {
  TY_ASSERT(image.width > 0 && image.height > 0 && image.rgba.size() == std::size_t{4} * image.width * image.height,
            "image '" + image.name + "' of " + std::to_string(image.rgba.size()) + " bytes");
  gpu::ImageDesc desc;
  desc.name = image.name.empty() ? "texture" : image.name;
  desc.format = srgb ? VK_FORMAT_R8G8B8A8_SRGB : VK_FORMAT_R8G8B8A8_UNORM;
  desc.width = image.width;
  desc.height = image.height;
  desc.mips = static_cast<std::uint32_t>(std::bit_width(std::max(image.width, image.height)));
  desc.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  Result<gpu::Image> made = device.createImage(desc);
  if (!made) return made;
  const Result<void> copied = device.upload(*made, std::as_bytes(std::span(image.rgba)));
  if (!copied) return copied.error();
  if (desc.mips == 1) return made;
  const Result<void> done = device.submitAndWait([&](VkCommandBuffer commands) { generateMips(commands, *made); });
  if (!done) return done.error();
  return made;
}

Result<VkImageView> TextureUploader::viewOf(std::int32_t image, bool srgb) {
  const auto known = views_.find({image, srgb});
  if (known != views_.end()) return known->second;
  const scene::Image white{"white", 1, 1, {255, 255, 255, 255}};
  Result<gpu::Image> made =
      uploadTexture(device_, image == scene::kNone ? white : scene_.images[static_cast<std::size_t>(image)], srgb);
  if (!made) return made.error();
  images_.push_back(made.take());
  return views_[{image, srgb}] = images_.back().view();
}

VkSampler TextureUploader::sampler(const scene::Sampler& sampler, Content content) {
  VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  info.addressModeU = address(sampler.wrapU);
  info.addressModeV = address(sampler.wrapV);
  info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  info.magFilter = info.minFilter = VK_FILTER_LINEAR;
  if (content == Content::kAlphaTest) return device_.sampler(info);
  info.magFilter = filter(sampler.magnify);
  info.minFilter = filter(sampler.minify);
  info.mipmapMode =
      sampler.mipmap == scene::Filter::kNearest ? VK_SAMPLER_MIPMAP_MODE_NEAREST : VK_SAMPLER_MIPMAP_MODE_LINEAR;
  // 0.25 is Vulkan's own way to say "no mipmaps, but tell magnification from minification" (VkSamplerCreateInfo).
  info.maxLod = sampler.useMipmaps ? VK_LOD_CLAMP_NONE : 0.25f;
  // Free on a GPU, several times the cost of a look-up on a CPU.
  const bool smooth = sampler.useMipmaps && sampler.minify == scene::Filter::kLinear && !device_.info().isCpu;
  info.anisotropyEnable = smooth;
  info.maxAnisotropy = smooth ? std::min(8.0f, device_.info().limits.maxSamplerAnisotropy) : 1.0f;
  return device_.sampler(info);
}

Result<TextureBinding> TextureUploader::bind(const scene::TextureUse& use, Content content) {
  std::int32_t image = scene::kNone;
  scene::Sampler how;
  if (use.used()) {
    const scene::Texture& texture = scene_.textures[static_cast<std::size_t>(use.texture)];
    image = texture.image;
    how = texture.sampler;
  }
  Result<VkImageView> view = viewOf(image, content != Content::kData);
  if (!view) return view.error();
  return TextureBinding{*view, sampler(how, content)};
}

}  // namespace tyndall::render
