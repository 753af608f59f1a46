// The graph's decisions as plain data: which passes run, how long each resource lives, where transients lie in shared
// memory, and which barriers stand before each pass. Pure CPU code: it is unit-tested without a GPU and replayed by a
// simulator.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "graph_use.hpp"

namespace tyndall::render::plan {

struct ResourceUse {
  std::uint32_t resource = 0;  ///< index into Input::resources
  Use use = Use::kSampledCompute;
};

struct PassInput {
  std::string name;
  bool keep = false;
  std::vector<ResourceUse> uses;  ///< at most one per resource
};

struct ResourceInput {
  std::string name;
  bool isBuffer = false;
  bool imported = false;
  bool hostVisible = false;  ///< imported buffers: the host reads them after the frame
  /// One mip and one layer: an attachment write replaces all of it. Others are written part by part, so that every
  /// earlier writer still counts.
  bool singleSubresource = false;
  VkImageLayout layoutBefore = VK_IMAGE_LAYOUT_UNDEFINED;  ///< imported images
  VkImageLayout layoutAfter = VK_IMAGE_LAYOUT_UNDEFINED;   ///< UNDEFINED: whatever the last use left
};

struct Input {
  std::vector<ResourceInput> resources;
  std::vector<PassInput> passes;
};

/// The first mistake of the declaration in words, or "": reading what nobody wrote, two uses of one resource in a pass,
/// a use that its kind of resource does not have.
std::string findMistake(const Input& input);

/// kept[pass]: it is keep(), writes an import, or a later kept pass reads what it writes.
std::vector<bool> cull(const Input& input);

/// First and last kept pass that uses a resource.
struct Life {
  std::uint32_t first = ~0u, last = 0;
  bool used() const { return first != ~0u; }
  bool overlaps(const Life& other) const { return first <= other.last && other.first <= last; }
};
std::vector<Life> lives(const Input& input, const std::vector<bool>& kept);

/// A transient to be placed. Only those of the same heap share memory.
struct Block {
  std::uint64_t size = 0, alignment = 1;
  Life life;
  std::uint32_t heap = 0;
};
struct Packing {
  std::vector<std::uint64_t> offsets;  ///< per block, bytes from the heap's start
  std::vector<std::uint64_t> heapSizes;
};
/// First fit, largest first: each block gets the lowest aligned offset where nothing that lives at the same time lies.
Packing pack(const std::vector<Block>& blocks, std::uint32_t heapCount);

/// What whoever next touches a piece of memory must wait for.
struct Pending {
  VkPipelineStageFlags2 stages = 0;
  VkAccessFlags2 writes = 0;  ///< not yet made available; 0 after reads, whose own barrier did that
};

/// Where a used transient lies; its `pending` is what earlier frames left (of another plan on the same memory; the
/// plan's own last frame is accounted for without it).
struct Placement {
  std::uint32_t resource = 0, heap = 0;
  std::uint64_t offset = 0, size = 0;
  Pending pending;
  bool overlaps(const Placement& other) const {
    return heap == other.heap && offset < other.offset + other.size && other.offset < offset + size;
  }
};

/// One entry of a pass's single vkCmdPipelineBarrier2.
struct Barrier {
  static constexpr std::uint32_t kMemory = ~0u;  ///< a global memory barrier: buffers, and memory changing hands
  std::uint32_t resource = kMemory;              ///< else the image
  VkPipelineStageFlags2 sourceStages = 0;
  VkAccessFlags2 sourceAccess = 0;
  VkPipelineStageFlags2 targetStages = 0;
  VkAccessFlags2 targetAccess = 0;
  VkImageLayout oldLayout = VK_IMAGE_LAYOUT_UNDEFINED, newLayout = VK_IMAGE_LAYOUT_UNDEFINED;
  bool operator==(const Barrier&) const = default;
};

struct Barriers {
  std::vector<std::vector<Barrier>> before;  ///< per declared pass; empty for dropped ones
  std::vector<Barrier> after;    ///< after the last pass: imports reach layoutAfter, the host and later commands
  std::vector<Pending> pending;  ///< per resource, at the frame's end
};
Barriers deriveBarriers(const Input& input, const std::vector<bool>& kept, const std::vector<Placement>& placements);

}  // namespace tyndall::render::plan
