// Memory of transients: blocks whose lives do not overlap may lie on each other.
#include <algorithm>
#include <numeric>

#include "base/assert.hpp"
#include "graph_plan.hpp"

namespace tyndall::render::plan {

Packing pack(const std::vector<Block>& blocks, std::uint32_t heapCount) {
  Packing packing{std::vector<std::uint64_t>(blocks.size()), std::vector<std::uint64_t>(heapCount)};
  // Largest first leaves the small ones to fill the gaps; ties in declared order keep the result the same every frame.
  std::vector<std::uint32_t> order(blocks.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return blocks[a].size > blocks[b].size; });

  std::vector<std::uint32_t> placed;  // in order of offset
  for (const std::uint32_t index : order) {
    const Block& block = blocks[index];
    TY_ASSERT(block.heap < heapCount, "heap " + std::to_string(block.heap) + " of " + std::to_string(heapCount));
    TY_ASSERT(block.alignment != 0 && (block.alignment & (block.alignment - 1)) == 0, std::to_string(block.alignment));
    const auto aligned = [&](std::uint64_t offset) { return (offset + block.alignment - 1) & ~(block.alignment - 1); };
    std::uint64_t offset = 0;
    for (const std::uint32_t other : placed) {
      if (blocks[other].heap != block.heap || !blocks[other].life.overlaps(block.life)) continue;
      if (offset + block.size <= packing.offsets[other]) break;  // fits into the gap below `other`
      offset = std::max(offset, aligned(packing.offsets[other] + blocks[other].size));
    }
    packing.offsets[index] = offset;
    packing.heapSizes[block.heap] = std::max(packing.heapSizes[block.heap], offset + block.size);
    const auto above =
        std::upper_bound(placed.begin(), placed.end(), offset,
                         [&](std::uint64_t value, std::uint32_t other) { return value < packing.offsets[other]; });
    placed.insert(above, index);
  }
  return packing;
}

}  // namespace tyndall::render::plan
