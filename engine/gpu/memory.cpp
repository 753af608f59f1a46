#include "memory.hpp"

#include <algorithm>

#include "base/assert.hpp"
#include "base/log.hpp"
#include "vk_text.hpp"

namespace tyndall::gpu {
namespace {

// Few enough blocks for maxMemoryAllocationCount (4096 at least), small enough to waste little when half empty.
constexpr VkDeviceSize kBlockBytes = 64ull << 20;

VkDeviceSize roundUp(VkDeviceSize value, VkDeviceSize multiple) { return (value + multiple - 1) / multiple * multiple; }

}  // namespace

Allocator::Allocator(VkPhysicalDevice physical, VkDevice device) : device_(device) {
  vkGetPhysicalDeviceMemoryProperties(physical, &memory_);
  VkPhysicalDeviceMaintenance3Properties limits{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_3_PROPERTIES};
  VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &limits};
  vkGetPhysicalDeviceProperties2(physical, &properties);
  granularity_ = std::max<VkDeviceSize>(1, properties.properties.limits.bufferImageGranularity);
  largest_ = limits.maxMemoryAllocationSize;
  heapBytes_.assign(memory_.memoryHeapCount, 0);
}

Allocator::~Allocator() {
  TY_ASSERT(usedBytes_ == 0, std::to_string(usedBytes_) + " bytes of memory are still held while the device goes");
  for (std::uint32_t i = 0; i < blocks_.size(); ++i)
    if (blocks_[i]) removeBlock(i);
}

VkMemoryRequirements Allocator::rounded(VkMemoryRequirements requirements) const {
  // Alignment and granularity are powers of two, so the larger one is a multiple of the other.
  requirements.alignment = std::max(requirements.alignment, granularity_);
  requirements.size = roundUp(requirements.size, granularity_);
  return requirements;
}

std::uint32_t Allocator::blockCount() const {
  return static_cast<std::uint32_t>(
      std::count_if(blocks_.begin(), blocks_.end(), [](const auto& b) { return b != nullptr; }));
}

bool Allocator::fits(const Allocation& allocation, std::uint32_t typeBits) const {
  return (typeBits >> blocks_[allocation.block]->type & 1u) != 0;
}

std::vector<std::uint32_t> Allocator::typesByPreference(std::uint32_t typeBits, MemoryUse use) const {
  VkMemoryPropertyFlags required = 0, wanted = 0, unwanted = 0;
  constexpr VkMemoryPropertyFlags kVisible = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  switch (use) {
    case MemoryUse::kDevice:  // host-visible video memory may be as small as 256 MiB: leave it to uploads
      wanted = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, unwanted = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT;
      break;
    case MemoryUse::kUpload:
      required = kVisible, wanted = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, unwanted = VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
      break;
    case MemoryUse::kReadback:
      required = kVisible, wanted = VK_MEMORY_PROPERTY_HOST_CACHED_BIT, unwanted = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
      break;
  }
  constexpr VkMemoryPropertyFlags kNever = VK_MEMORY_PROPERTY_PROTECTED_BIT | VK_MEMORY_PROPERTY_LAZILY_ALLOCATED_BIT |
                                           VK_MEMORY_PROPERTY_DEVICE_COHERENT_BIT_AMD;
  std::vector<std::uint32_t> types;
  for (std::uint32_t i = 0; i < memory_.memoryTypeCount; ++i) {
    const VkMemoryPropertyFlags flags = memory_.memoryTypes[i].propertyFlags;
    if ((typeBits >> i & 1u) && (flags & required) == required && !(flags & kNever)) types.push_back(i);
  }
  const auto cost = [&](std::uint32_t type) {
    const VkMemoryPropertyFlags flags = memory_.memoryTypes[type].propertyFlags;
    return ((flags & wanted) == wanted ? 0 : 2) + ((flags & unwanted) ? 1 : 0);
  };
  std::stable_sort(types.begin(), types.end(), [&](auto a, auto b) { return cost(a) < cost(b); });
  return types;
}

VkDeviceSize Allocator::blockBytes(std::uint32_t type) const {
  return std::min(kBlockBytes, memory_.memoryHeaps[memory_.memoryTypes[type].heapIndex].size / 8);
}

VkResult Allocator::addBlock(std::uint32_t type, VkDeviceSize size, bool own, std::uint32_t& index) {
  const std::uint32_t heap = memory_.memoryTypes[type].heapIndex;
  // A driver for a CPU grants more than there is and the program dies later, so the heap's size is held to here.
  if (size > largest_ ||
      size > memory_.memoryHeaps[heap].size - std::min(heapBytes_[heap], memory_.memoryHeaps[heap].size))
    return VK_ERROR_OUT_OF_DEVICE_MEMORY;
  VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, nullptr, size, type};
  auto block = std::make_unique<Block>();
  if (const VkResult result = vkAllocateMemory(device_, &info, nullptr, &block->memory)) return result;
  if (memory_.memoryTypes[type].propertyFlags & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT) {
    void* mapped = nullptr;
    if (const VkResult result = vkMapMemory(device_, block->memory, 0, VK_WHOLE_SIZE, 0, &mapped)) {
      vkFreeMemory(device_, block->memory, nullptr);
      return result;
    }
    block->mapped = static_cast<std::byte*>(mapped);
  }
  block->type = type;
  block->own = own;
  block->ranges = RangeAllocator(size);
  heapBytes_[heap] += size;
  const auto hole = std::find(blocks_.begin(), blocks_.end(), nullptr);
  index = static_cast<std::uint32_t>(hole - blocks_.begin());
  if (hole == blocks_.end())
    blocks_.push_back(std::move(block));
  else
    *hole = std::move(block);
  return VK_SUCCESS;
}

void Allocator::removeBlock(std::uint32_t index) {
  Block& block = *blocks_[index];
  heapBytes_[memory_.memoryTypes[block.type].heapIndex] -= block.ranges.size();
  vkFreeMemory(device_, block.memory, nullptr);
  blocks_[index].reset();
}

std::shared_ptr<Allocation> Allocator::take(std::uint32_t index, VkDeviceSize offset, VkDeviceSize size,
                                            const std::string& name) {
  const Block& block = *blocks_[index];
  std::byte* mapped = block.mapped ? block.mapped + offset : nullptr;
  auto* made = new Allocation{block.memory, offset, size, mapped, index, {name, size, std::nullopt, false}};
  usedBytes_ += size;
  live_.insert(made);
  return {made, [this](Allocation* allocation) {
            live_.erase(allocation);
            give(*allocation);
            delete allocation;
          }};
}

void Allocator::give(const Allocation& allocation) {
  usedBytes_ -= allocation.size;
  Block& block = *blocks_[allocation.block];
  block.ranges.free(allocation.offset, allocation.size);
  if (!block.ranges.unused()) return;
  // One empty block of a type is kept: a resource that comes and goes each frame would otherwise make and free one.
  const bool another = std::any_of(blocks_.begin(), blocks_.end(), [&](const auto& other) {
    return other && other.get() != &block && other->type == block.type && !other->own && other->ranges.unused();
  });
  if (block.own || another) removeBlock(allocation.block);
}

Result<std::shared_ptr<Allocation>> Allocator::allocate(const VkMemoryRequirements& requirements, MemoryUse use,
                                                        const std::string& name) {
  const auto [size, alignment, typeBits] = rounded(requirements);
  if (size == 0) return failed("'" + name + "': a size that this device does not take");
  const std::vector<std::uint32_t> types = typesByPreference(typeBits, use);
  VkResult result = VK_ERROR_OUT_OF_DEVICE_MEMORY;
  for (const std::uint32_t type : types) {
    const bool own = size > blockBytes(type) / 2;
    for (std::uint32_t i = 0; i < blocks_.size() && !own; ++i) {
      if (!blocks_[i] || blocks_[i]->type != type || blocks_[i]->own) continue;
      if (const auto offset = blocks_[i]->ranges.allocate(size, alignment)) return take(i, *offset, size, name);
    }
    std::uint32_t index = 0;
    result = addBlock(type, own ? size : blockBytes(type), own, index);
    if (result != VK_SUCCESS) continue;
    if (type != types.front())
      log::debug("'" + name + "': the preferred memory is full, using memory type " + std::to_string(type));
    return take(index, *blocks_[index]->ranges.allocate(size, alignment), size, name);
  }
  return failed("'" + name + "': no memory for " + std::to_string(size) + " bytes (" + text(result) + "), " +
                std::to_string(usedBytes_) + " bytes are in use");
}

}  // namespace tyndall::gpu
