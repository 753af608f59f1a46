// Hands out ranges of one block of memory: free list, best fit, neighbours merged. Knows no Vulkan.
#pragma once

#include <cstdint>
#include <map>
#include <optional>

namespace tyndall::gpu {

class RangeAllocator {
 public:
  explicit RangeAllocator(std::uint64_t size);
  /// Offset of a free range of `size` (> 0) bytes at a multiple of `alignment` (> 0); none if no free range is large
  /// enough.
  std::optional<std::uint64_t> allocate(std::uint64_t size, std::uint64_t alignment);
  /// Gives back exactly what allocate gave.
  void free(std::uint64_t offset, std::uint64_t size);
  std::uint64_t size() const { return size_; }
  std::uint64_t freeBytes() const { return freeBytes_; }
  bool unused() const { return freeBytes_ == size_; }

 private:
  std::map<std::uint64_t, std::uint64_t> free_;  ///< size by offset; no two ranges touch
  std::uint64_t size_ = 0, freeBytes_ = 0;
};

}  // namespace tyndall::gpu
