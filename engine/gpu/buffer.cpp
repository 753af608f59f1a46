#include "base/assert.hpp"
#include "state.hpp"
#include "vk_text.hpp"

namespace tyndall::gpu {
namespace {

VkBufferCreateInfo createInfo(const BufferDesc& desc) {
  VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  info.size = desc.size;
  info.usage = desc.usage;
  info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
  return info;
}

MemoryUse memoryUse(const BufferDesc& desc) {
  if (!desc.hostVisible) return MemoryUse::kDevice;
  // What the GPU can write is there to be read by the CPU, which is slow without a cache.
  constexpr VkBufferUsageFlags kWritten = VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  return desc.usage & kWritten ? MemoryUse::kReadback : MemoryUse::kUpload;
}

}  // namespace

Buffer::State::~State() { vkDestroyBuffer(device.device, buffer, nullptr); }

Buffer::Buffer() noexcept = default;
Buffer::Buffer(Buffer&&) noexcept = default;
Buffer& Buffer::operator=(Buffer&& other) noexcept {
  if (this == &other) return *this;
  letGo(state_);
  state_ = std::move(other.state_);
  return *this;
}
Buffer::~Buffer() { letGo(state_); }

VkBuffer Buffer::handle() const { return state_->buffer; }
VkDeviceSize Buffer::size() const { return state_->desc.size; }
std::byte* Buffer::mapped() const { return state_->mapped; }

Result<Buffer> Device::createBufferAt(const BufferDesc& desc, std::shared_ptr<Allocation> memory, VkDeviceSize offset) {
  const std::string subject = "buffer '" + desc.name + "' (" + std::to_string(desc.size) + " bytes)";
  TY_ASSERT(!memory || !desc.hostVisible, subject + ": shared memory is the GPU's own");
  if (desc.size == 0) return failed(subject + ": a size of 0");
  if (desc.size > state_->maxBufferBytes)
    return failed(subject + ": too large; this device takes at most " + std::to_string(state_->maxBufferBytes) +
                  " bytes");
  const VkBufferCreateInfo info = createInfo(desc);
  Buffer buffer;
  buffer.state_ = std::make_unique<Buffer::State>(*state_, desc.name);
  Buffer::State& made = *buffer.state_;
  made.desc = desc;
  if (const VkResult result = vkCreateBuffer(state_->device, &info, nullptr, &made.buffer)) {
    made.buffer = VK_NULL_HANDLE;
    return vkFailed(subject, result);
  }
  VkMemoryRequirements needs{};
  vkGetBufferMemoryRequirements(state_->device, made.buffer, &needs);
  if (!memory) {
    auto own = state_->allocator->allocate(needs, memoryUse(desc), desc.name);
    if (!own) return failed("buffer " + own.error().message);
    memory = own.take();
  }
  const VkDeviceSize at = memory->offset + offset;
  TY_ASSERT(at % needs.alignment == 0 && offset <= memory->size && needs.size <= memory->size - offset &&
                state_->allocator->fits(*memory, needs.memoryTypeBits),
            subject + " does not fit the memory at offset " + std::to_string(offset));
  if (const VkResult result = vkBindBufferMemory(state_->device, made.buffer, memory->memory, at))
    return vkFailed(subject, result);
  if (desc.hostVisible) made.mapped = memory->mapped + offset;
  made.memory = std::move(memory);
  state_->name(VK_OBJECT_TYPE_BUFFER, made.buffer, desc.name);
  return buffer;
}

Result<Buffer> Device::createBuffer(const BufferDesc& desc) { return createBufferAt(desc, nullptr, 0); }

VkMemoryRequirements Device::requirements(const BufferDesc& desc) {
  if (desc.size == 0 || desc.size > state_->maxBufferBytes) return {};
  const VkBufferCreateInfo info = createInfo(desc);
  VkDeviceBufferMemoryRequirements query{VK_STRUCTURE_TYPE_DEVICE_BUFFER_MEMORY_REQUIREMENTS, nullptr, &info};
  VkMemoryRequirements2 needs{VK_STRUCTURE_TYPE_MEMORY_REQUIREMENTS_2};
  vkGetDeviceBufferMemoryRequirements(state_->device, &query, &needs);
  return state_->allocator->rounded(needs.memoryRequirements);
}

}  // namespace tyndall::gpu
