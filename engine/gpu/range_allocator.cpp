#include "gpu/range_allocator.hpp"

#include <string>

#include "base/assert.hpp"

namespace tyndall::gpu {

RangeAllocator::RangeAllocator(std::uint64_t size) : size_(size), freeBytes_(size) {
  if (size > 0) free_.emplace(0, size);
}

std::optional<std::uint64_t> RangeAllocator::allocate(std::uint64_t size, std::uint64_t alignment) {
  TY_ASSERT(size > 0 && alignment > 0, std::to_string(size) + " bytes aligned to " + std::to_string(alignment));
  auto best = free_.end();
  std::uint64_t bestOffset = 0;
  for (auto range = free_.begin(); range != free_.end(); ++range) {
    const auto [start, length] = *range;
    const std::uint64_t padding = (alignment - start % alignment) % alignment;
    if (length < padding || length - padding < size) continue;
    if (best == free_.end() || length < best->second) {
      best = range;
      bestOffset = start + padding;
    }
  }
  if (best == free_.end()) return std::nullopt;

  const auto [start, length] = *best;
  free_.erase(best);
  if (bestOffset > start) free_.emplace(start, bestOffset - start);
  const std::uint64_t end = bestOffset + size;
  if (end < start + length) free_.emplace(end, start + length - end);
  freeBytes_ -= size;
  return bestOffset;
}

void RangeAllocator::free(std::uint64_t offset, std::uint64_t size) {
  const auto text = [&] { return "range at " + std::to_string(offset) + " of " + std::to_string(size) + " bytes"; };
  TY_ASSERT(size > 0 && size <= size_ && offset <= size_ - size, text());
  auto next = free_.lower_bound(offset);
  TY_ASSERT(next == free_.end() || offset + size <= next->first, text() + " is already free");
  freeBytes_ += size;
  if (next != free_.begin()) {
    const auto previous = std::prev(next);
    TY_ASSERT(previous->first + previous->second <= offset, text() + " is already free");
    if (previous->first + previous->second == offset) {
      offset = previous->first;
      size += previous->second;
      free_.erase(previous);
    }
  }
  if (next != free_.end() && next->first == offset + size) {
    size += next->second;
    free_.erase(next);
  }
  free_.emplace(offset, size);
}

}  // namespace tyndall::gpu
