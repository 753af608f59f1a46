#include "base/assert.hpp"
#include "gpu/pipeline.hpp"

namespace tyndall::gpu {

// The pointers into images_ and buffers_ are set by push(), so that a Descriptors may be copied before.
VkWriteDescriptorSet& Descriptors::add(std::uint32_t binding, VkDescriptorType type) {
  TY_ASSERT(count_ < kMax, "more than " + std::to_string(kMax) + " descriptors");
  VkWriteDescriptorSet& write = writes_[count_];
  write = {VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
  write.dstBinding = binding;
  write.descriptorCount = 1;
  write.descriptorType = type;
  return write;
}

Descriptors& Descriptors::sampled(std::uint32_t binding, VkImageView view, VkSampler sampler, VkImageLayout layout) {
  add(binding, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER);
  images_[count_++] = {sampler, view, layout};
  return *this;
}

Descriptors& Descriptors::storageImage(std::uint32_t binding, VkImageView view) {
  add(binding, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE);
  images_[count_++] = {VK_NULL_HANDLE, view, VK_IMAGE_LAYOUT_GENERAL};
  return *this;
}

Descriptors& Descriptors::storageBuffer(std::uint32_t binding, VkBuffer buffer, VkDeviceSize offset,
                                        VkDeviceSize size) {
  add(binding, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER);
  buffers_[count_++] = {buffer, offset, size};
  return *this;
}

Descriptors& Descriptors::uniformBuffer(std::uint32_t binding, VkBuffer buffer, VkDeviceSize offset,
                                        VkDeviceSize size) {
  add(binding, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER);
  buffers_[count_++] = {buffer, offset, size};
  return *this;
}

void Descriptors::push() {
  if (count_ == 0) return;
  for (std::uint32_t i = 0; i < count_; ++i) writes_[i].pImageInfo = &images_[i], writes_[i].pBufferInfo = &buffers_[i];
  vkCmdPushDescriptorSetKHR(commands_, pipeline_.bindPoint(), pipeline_.layout(), 0, count_, writes_.data());
}

}  // namespace tyndall::gpu
