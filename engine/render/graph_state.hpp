// What a Graph and its GraphMemory keep. Private to graph*.cpp.
#pragma once

#include <optional>

#include "graph_plan.hpp"
#include "render/graph.hpp"

namespace tyndall::render {

/// A physical transient, kept from frame to frame.
struct PhysicalResource {
  bool isBuffer = false;
  gpu::ImageDesc imageDesc;  ///< with the derived usage
  gpu::BufferDesc bufferDesc;
  std::uint32_t heap = 0;
  std::uint64_t offset = 0;
  std::optional<gpu::Image> image;
  std::optional<gpu::Buffer> buffer;
  plan::Pending pending;  ///< what the frame recorded last left on its memory

  bool sameDesc(const PhysicalResource& other) const;
  bool sameAs(const PhysicalResource& other) const;  ///< description and place
};

/// Resources of different memory types, and images and buffers (bufferImageGranularity), never share memory.
struct Heap {
  bool isBuffer = false;
  std::uint32_t memoryTypes = 0;
  VkDeviceSize alignment = 1, size = 0;
  std::shared_ptr<gpu::Allocation> memory;
};

struct GraphMemory::State {
  gpu::Device& device;
  std::vector<Heap> heaps;
  std::vector<PhysicalResource> resources;
  /// Requirements of the resources above, so that the driver is asked once per description and not once per frame.
  std::vector<VkMemoryRequirements> requirements;
  bool waited = false;         ///< the last new resources had room only once the old ones were gone
  std::uint64_t compiles = 0;  ///< the graph compiled last owns `resources` until the next one compiles

  explicit State(gpu::Device& d) : device(d) {}
  /// Errors: what the device refuses to make.
  Result<VkMemoryRequirements> requirementsOf(const PhysicalResource& resource) const;
  /// Memory and objects of a new plan; after an error none of them.
  Result<void> make(std::vector<Heap>& newHeaps, std::vector<PhysicalResource>& newResources);
  /// Makes `resources` real, or finds that they are already there. Old ones die once the GPU has finished with them.
  /// After an error there are none, and the next plan starts from nothing.
  Result<void> realize(std::vector<Heap> newHeaps, std::vector<PhysicalResource> newResources,
                       std::vector<VkMemoryRequirements> newRequirements);
};

struct GraphResource {
  bool isBuffer = false;
  std::string owner;
  gpu::ImageDesc imageDesc;
  gpu::BufferDesc bufferDesc;
  VkImageLayout before = VK_IMAGE_LAYOUT_UNDEFINED, after = VK_IMAGE_LAYOUT_UNDEFINED;
  // Imports: one of these. The caller keeps them until record() has returned.
  const gpu::Image* image = nullptr;
  const gpu::Buffer* buffer = nullptr;
  VkImage rawImage = VK_NULL_HANDLE;
  VkImageView rawView = VK_NULL_HANDLE;
  // Transients, after compile():
  std::uint32_t physical = ~0u;  ///< index into GraphMemory's resources; ~0: no kept pass uses it
  VkDeviceSize bytes = 0;

  bool imported() const { return image || buffer || rawImage; }
};

struct GraphPass {
  std::string name, owner;
  bool keep = false, idle = false;
  std::vector<plan::ResourceUse> uses;
  std::function<void(PassContext&)> record;
};

struct Graph::State {
  gpu::Device& device;
  GraphMemory::State& memory;
  std::vector<GraphResource> resources;
  std::vector<GraphPass> passes;
  bool compiled = false;
  std::uint64_t compileId = 0;
  plan::Input input;
  std::vector<bool> kept;
  plan::Barriers barriers;
  GraphStatistics statistics;
  // While recording:
  std::uint32_t currentPass = ~0u;
  struct Rendered {
    std::uint32_t resource;
    gpu::ViewDesc view;
  };
  std::vector<Rendered> rendered;  ///< attachments of the current pass's earlier renderings
  bool rendering = false;

  State(gpu::Device& d, GraphMemory::State& m) : device(d), memory(m) {}

  const GraphResource& resource(std::uint32_t id, bool isBuffer) const;
  VkImage imageHandle(const GraphResource& resource) const;
  VkImageView imageView(const GraphResource& resource, const gpu::ViewDesc& view) const;
  VkBuffer bufferHandle(const GraphResource& resource) const;
  /// How the current pass declared its use of a resource; asserts that it did.
  Use useOf(std::uint32_t id) const;

  void describe();  ///< fills `input`
  Result<void> allocate(std::vector<plan::Placement>& placements);
  void countStatistics();
  void recordBarriers(VkCommandBuffer commands, const std::vector<plan::Barrier>& list) const;
};

/// Aspects of a format: colour, or depth and stencil as it has them.
VkImageAspectFlags aspectOf(VkFormat format);

}  // namespace tyndall::render
