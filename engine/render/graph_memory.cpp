// Physical transients and their shared memory from frame to frame.
//
// Two frames in flight use the same memory. That is right because both are submitted to one queue: the barrier before a
// transient's first use waits for the last uses of everything on its memory, and a barrier's source scope holds all
// earlier commands of the queue, those of the frame before included (graph_barriers.cpp). What it costs is overlap of
// two frames on the GPU, what it saves is half of the memory.
#include <algorithm>
#include <utility>

#include "graph_state.hpp"

namespace tyndall::render {

bool PhysicalResource::sameDesc(const PhysicalResource& other) const {
  return isBuffer == other.isBuffer && imageDesc == other.imageDesc && bufferDesc.name == other.bufferDesc.name &&
         bufferDesc.size == other.bufferDesc.size && bufferDesc.usage == other.bufferDesc.usage;
}

bool PhysicalResource::sameAs(const PhysicalResource& other) const {
  return heap == other.heap && offset == other.offset && sameDesc(other);
}

Result<VkMemoryRequirements> GraphMemory::State::requirementsOf(const PhysicalResource& wanted) const {
  for (std::size_t i = 0; i < resources.size(); ++i)
    if (wanted.sameDesc(resources[i])) return requirements[i];
  const VkMemoryRequirements needed =
      wanted.isBuffer ? device.requirements(wanted.bufferDesc) : device.requirements(wanted.imageDesc);
  if (needed.size != 0) return needed;
  // The device refuses the description; making one says why.
  if (wanted.isBuffer) {
    auto refused = device.createBuffer(wanted.bufferDesc);
    return refused ? failed("buffer '" + wanted.bufferDesc.name + "': the device names no size for it")
                   : refused.error();
  }
  auto refused = device.createImage(wanted.imageDesc);
  return refused ? failed("image '" + wanted.imageDesc.name + "': the device names no size for it") : refused.error();
}

Result<void> GraphMemory::State::make(std::vector<Heap>& newHeaps, std::vector<PhysicalResource>& newResources) {
  const auto made = [&]() -> Result<void> {
    for (Heap& heap : newHeaps) {
      const VkMemoryRequirements needed{heap.size, heap.alignment, heap.memoryTypes};
      auto memory = device.allocate(needed, heap.isBuffer ? "transient buffers" : "transient images");
      if (!memory) return memory.error();
      heap.memory = memory.take();
    }
    for (PhysicalResource& resource : newResources) {
      const Heap& heap = newHeaps[resource.heap];
      if (resource.isBuffer) {
        auto buffer = device.createBufferAt(resource.bufferDesc, heap.memory, resource.offset);
        if (!buffer) return buffer.error();
        resource.buffer = buffer.take();
      } else {
        auto image = device.createImageAt(resource.imageDesc, heap.memory, resource.offset);
        if (!image) return image.error();
        resource.image = image.take();
      }
    }
    return {};
  }();
  if (made) return made;
  for (PhysicalResource& resource : newResources) resource.image.reset(), resource.buffer.reset();
  for (Heap& heap : newHeaps) heap.memory.reset();
  return made;
}

Result<void> GraphMemory::State::realize(std::vector<Heap> newHeaps, std::vector<PhysicalResource> newResources,
                                         std::vector<VkMemoryRequirements> newRequirements) {
  const auto sameHeap = [](const Heap& a, const Heap& b) {
    return a.isBuffer == b.isBuffer && a.memoryTypes == b.memoryTypes && a.alignment == b.alignment && a.size == b.size;
  };
  const bool unchanged = std::equal(heaps.begin(), heaps.end(), newHeaps.begin(), newHeaps.end(), sameHeap) &&
                         std::equal(resources.begin(), resources.end(), newResources.begin(), newResources.end(),
                                    [](const PhysicalResource& a, const PhysicalResource& b) { return a.sameAs(b); });
  if (unchanged) return {};

  // Old and new together, because frames in flight still use the old ones. Where that is too much, the old ones go
  // first.
  std::vector<Heap> oldHeaps = std::exchange(heaps, {});
  std::vector<PhysicalResource> oldResources = std::exchange(resources, {});
  requirements.clear();
  waited = false;
  if (auto made = make(newHeaps, newResources); !made) {
    const auto letGo = [&] { oldResources.clear(), oldHeaps.clear(); };
    if (auto gone = device.destroyNow(letGo); !gone) return gone;
    if (auto again = make(newHeaps, newResources); !again) return again;
    waited = true;
  }
  heaps = std::move(newHeaps);
  resources = std::move(newResources);
  requirements = std::move(newRequirements);
  return {};
}

GraphMemory::GraphMemory(gpu::Device& device) : state_(std::make_unique<State>(device)) {}
GraphMemory::~GraphMemory() = default;

}  // namespace tyndall::render
