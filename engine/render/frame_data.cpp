#include "frame_data.hpp"

#include <algorithm>
#include <cstring>

namespace tyndall::render {

namespace {

// The largest minUniformBufferOffsetAlignment and minStorageBufferOffsetAlignment that Vulkan 1.3 allows.
constexpr VkDeviceSize kAlignment = 256;

VkDeviceSize aligned(VkDeviceSize size) { return (size + kAlignment - 1) / kAlignment * kAlignment; }

}  // namespace

Result<std::vector<BlockRange>> BlockRing::write(const std::vector<std::pair<const void*, std::size_t>>& parts) {
  VkDeviceSize total = 0;
  for (const auto& [data, size] : parts) total += aligned(std::max<std::size_t>(size, 1));
  gpu::Buffer& slot = slots_[next_];
  next_ = (next_ + 1) % kSlots;
  if (!slot || slot.size() < total) {
    // Half as much again, so that a growing level does not make a new buffer each frame.
    Result<gpu::Buffer> made =
        device_.createBuffer({"frame blocks", total + total / 2,
                              VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, true});
    if (!made) return made.error();
    slot = made.take();
  }
  std::vector<BlockRange> ranges;
  VkDeviceSize offset = 0;
  for (const auto& [data, size] : parts) {
    if (size > 0) std::memcpy(slot.mapped() + offset, data, size);
    // A binding of no bytes is not allowed; nothing reads the stand-in.
    ranges.push_back({slot.handle(), offset, std::max<VkDeviceSize>(size, 16)});
    offset += aligned(std::max<std::size_t>(size, 1));
  }
  return ranges;
}

FrameSamplers makeSamplers(gpu::Device& device) {
  VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  info.addressModeU = info.addressModeV = info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  FrameSamplers samplers;
  samplers.texel = device.sampler(info);
  info.addressModeU = info.addressModeV = info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER;
  info.borderColor = VK_BORDER_COLOR_FLOAT_OPAQUE_WHITE;
  samplers.borderLit = device.sampler(info);
  info.addressModeU = info.addressModeV = info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  info.magFilter = info.minFilter = VK_FILTER_LINEAR;
  samplers.linear = device.sampler(info);
  info.mipmapMode = VK_SAMPLER_MIPMAP_MODE_LINEAR;
  info.maxLod = VK_LOD_CLAMP_NONE;
  samplers.trilinear = device.sampler(info);
  info.addressModeU = info.addressModeV = VK_SAMPLER_ADDRESS_MODE_REPEAT;
  samplers.cookie = device.sampler(info);
  return samplers;
}

}  // namespace tyndall::render
