// Sub-allocation of device memory from a few large blocks.
#pragma once

#include <memory>
#include <string>
#include <unordered_set>
#include <vector>

#include "gpu/device.hpp"
#include "gpu/range_allocator.hpp"

namespace tyndall::gpu {

/// Who touches the memory, which decides its type.
enum class MemoryUse {
  kDevice,    ///< the GPU only
  kUpload,    ///< written by the CPU, read by the GPU
  kReadback,  ///< read by the CPU too, so it must be cached
};

/// Offsets and sizes are rounded up to bufferImageGranularity, so that buffers and images may share a block.
class Allocator {
 public:
  Allocator(VkPhysicalDevice physical, VkDevice device);
  ~Allocator();
  Allocator(const Allocator&) = delete;
  Allocator& operator=(const Allocator&) = delete;

  /// The range is given back when the last holder drops it: only after the GPU is done with what lies in it.
  Result<std::shared_ptr<Allocation>> allocate(const VkMemoryRequirements& requirements, MemoryUse use,
                                               const std::string& name);
  VkMemoryRequirements rounded(VkMemoryRequirements requirements) const;
  VkDeviceSize usedBytes() const { return usedBytes_; }
  const std::unordered_set<const Allocation*>& live() const { return live_; }
  std::uint32_t blockCount() const;
  /// Whether memory that `allocation` lies in is of a type in `typeBits`.
  bool fits(const Allocation& allocation, std::uint32_t typeBits) const;

 private:
  struct Block {
    VkDeviceMemory memory = VK_NULL_HANDLE;
    std::byte* mapped = nullptr;
    std::uint32_t type = 0;
    bool own = false;  ///< made for one big request
    RangeAllocator ranges{0};
  };
  std::vector<std::uint32_t> typesByPreference(std::uint32_t typeBits, MemoryUse use) const;
  VkDeviceSize blockBytes(std::uint32_t type) const;
  VkResult addBlock(std::uint32_t type, VkDeviceSize size, bool own, std::uint32_t& index);
  void removeBlock(std::uint32_t index);
  std::shared_ptr<Allocation> take(std::uint32_t index, VkDeviceSize offset, VkDeviceSize size,
                                   const std::string& name);
  void give(const Allocation& allocation);

  VkDevice device_;
  VkPhysicalDeviceMemoryProperties memory_{};
  VkDeviceSize granularity_ = 1, largest_ = 0, usedBytes_ = 0;
  std::unordered_set<const Allocation*> live_;
  std::vector<VkDeviceSize> heapBytes_;         ///< taken by blocks, per heap
  std::vector<std::unique_ptr<Block>> blocks_;  ///< null where a block was returned
};

}  // namespace tyndall::gpu
