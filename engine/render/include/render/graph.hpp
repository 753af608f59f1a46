// A render graph for one frame: passes declare what they read and write; the graph drops passes nobody needs, derives
// barriers and layouts, and lets transient images and buffers whose lives do not overlap share memory. (After the idea
// of Filament's FrameGraph: declare now, run later.)
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "gpu/device.hpp"
#include "gpu/pipeline.hpp"

namespace tyndall::render {

struct ImageRef {
  std::uint32_t id = ~0u;
  explicit operator bool() const { return id != ~0u; }
  bool operator==(const ImageRef&) const = default;
};
struct BufferRef {
  std::uint32_t id = ~0u;
  explicit operator bool() const { return id != ~0u; }
  bool operator==(const BufferRef&) const = default;
};

/// How a pass uses a resource; decides stage, access and layout. One use per resource and pass.
/// A resource must be written before anything reads or loads it. Storage and transfer writes may be partial, so they
/// keep the writers before them; so do attachment writes of images with several mips or layers.
enum class Use {
  // Read by texture, SHADER_READ_ONLY. Of a buffer: a storage buffer that these stages only read.
  kSampledCompute,
  kSampledGraphics,
  // GENERAL
  kStorageReadCompute,
  kStorageWriteCompute,
  kStorageReadWriteCompute,
  kSampledStorageCompute,  ///< images: some mips or layers read by texture (in GENERAL), others stored to or loaded
                           ///< from
  kColorWrite,             ///< colour attachment, cleared or fully overwritten
  kColorReadWrite,         ///< colour attachment, loaded (blending over what is there)
  kDepthWrite,             ///< depth attachment, cleared
  kDepthReadWrite,         ///< depth attachment, loaded and written
  kDepthRead,              ///< depth attachment, tested only
  kTransferRead,
  kTransferWrite,
  kUniform,
  kIndirect,
  kPresent  ///< read by the window system: PRESENT_SRC
};
constexpr bool writes(Use use);

class PassContext;

struct PassTime {
  std::string name, owner;  ///< owner: "engine" or a plugin's id
  double milliseconds = 0;
};

struct GraphStatistics {
  std::uint32_t passesDeclared = 0, passesRun = 0, barriers = 0;
  VkDeviceSize transientBytes = 0;          ///< memory of transients, shared
  VkDeviceSize transientBytesUnshared = 0;  ///< what they would take each on its own
  /// The memory was made anew in this frame, and there was room only once the old had been freed: the GPU was waited
  /// for.
  bool waitedForMemory = false;
};

/// A transient's part of the shared memory. Those of the same heap whose passes do not overlap may lie on each other.
struct TransientUse {
  std::string name, owner;
  std::optional<gpu::ImageDesc> image;  ///< else it is a buffer
  std::uint32_t heap = 0;
  VkDeviceSize offset = 0, bytes = 0;  ///< in its heap
  std::string firstPass, lastPass;     ///< that use it
};

/// Memory and physical resources that live from frame to frame (one per renderer). Reused while the plan is unchanged.
class GraphMemory {
 public:
  explicit GraphMemory(gpu::Device& device);
  ~GraphMemory();
  struct State;
  State& state() { return *state_; }

 private:
  std::unique_ptr<State> state_;
};

class Graph {
 public:
  Graph(gpu::Device& device, GraphMemory& memory);
  ~Graph();

  /// A transient image: usage flags are derived from the passes. Contents are undefined until the first write of the
  /// frame.
  ImageRef image(const gpu::ImageDesc& desc, std::string_view owner = "engine");
  BufferRef buffer(const gpu::BufferDesc& desc, std::string_view owner = "engine");
  /// A resource the caller keeps. Its layout between frames is `layout` (UNDEFINED discards contents at the frame's
  /// start). A written import counts as needed: its writers are never dropped. The caller keeps the object, at its
  /// address, until record() has returned. `layoutAfter` UNDEFINED: whatever the last use leaves. After record(),
  /// writes to imports are visible to all later commands, and those to host-visible buffers to the host once it has
  /// waited for the frame.
  ImageRef import(const gpu::Image& image, VkImageLayout layoutBefore, VkImageLayout layoutAfter);
  BufferRef import(const gpu::Buffer& buffer);
  /// A foreign image (swapchain) with one view of its whole.
  ImageRef importRaw(VkImage image, VkImageView view, const gpu::ImageDesc& desc, VkImageLayout before,
                     VkImageLayout after);

  class Pass {
   public:
    Pass& use(ImageRef image, Use use);
    Pass& use(BufferRef buffer, Use use);
    Pass& keep();  ///< never dropped (side effects: readback)
    /// Has nothing to do in this frame: run() is still called, but records no command. The pass keeps its place and its
    /// uses, so that images get their layouts; it is neither timed nor listed by passes().
    Pass& idle();
    void run(std::function<void(PassContext&)> record);

   private:
    friend class Graph;
    Pass(Graph& graph, std::uint32_t index) : graph_(graph), index_(index) {}
    Graph& graph_;
    std::uint32_t index_;
  };
  Pass pass(std::string_view name, std::string_view owner = "engine");

  const gpu::ImageDesc& desc(ImageRef image) const;

  /// Drops, orders lives, allocates, derives barriers. Asserts on our own mistakes (reading what nobody wrote, two
  /// writers in one pass, a forgotten run()); a Result only for device errors such as lack of memory.
  Result<void> compile();
  /// Records every kept pass, on the device's one queue, before another graph of the same GraphMemory compiles. May be
  /// called again (imports must then be back in their layoutBefore). With `timestamps`, times each (capacity must be at
  /// least the number of passes).
  void record(VkCommandBuffer commands, gpu::Timestamps* timestamps);
  /// Names and owners of the passes that record() ran (idle ones left out), in the order of Timestamps::milliseconds().
  std::vector<PassTime> passes() const;
  GraphStatistics statistics() const;
  std::vector<TransientUse> transients() const;  ///< in the order of their declaration, without what no kept pass uses
  VkDeviceSize ownerBytes(std::string_view owner) const;  ///< memory of that owner's transients, unshared

  struct State;

 private:
  friend class PassContext;
  std::unique_ptr<State> state_;
};

/// What a pass sees while it records.
class PassContext {
 public:
  VkCommandBuffer commands() const;
  gpu::Device& device() const;
  VkImageView view(ImageRef image, const gpu::ViewDesc& desc = {}) const;
  VkImage image(ImageRef image) const;
  VkBuffer buffer(BufferRef buffer) const;
  const gpu::ImageDesc& desc(ImageRef image) const;

  struct ColorAttachment {
    ImageRef image;
    bool clear = false;
    VkClearColorValue value{};
    gpu::ViewDesc view{};
  };
  struct DepthAttachment {
    ImageRef image;
    bool clear = false;
    float value = 0;
    bool readOnly = false;
    gpu::ViewDesc view{};
  };
  /// Begins dynamic rendering over the whole of the attachments (the size of the mip chosen) and sets viewport and
  /// scissor. What is not cleared is loaded if the use is a ReadWrite or this pass has rendered to it before, else
  /// undefined.
  void beginRendering(std::vector<ColorAttachment> colors, const DepthAttachment* depth = nullptr,
                      std::uint32_t layers = 1);
  void endRendering();

 private:
  friend class Graph;
  PassContext(Graph::State& graph, VkCommandBuffer commands) : graph_(graph), commands_(commands) {}
  Graph::State& graph_;
  VkCommandBuffer commands_;
};

constexpr bool writes(Use use) {
  return use == Use::kStorageWriteCompute || use == Use::kStorageReadWriteCompute ||
         use == Use::kSampledStorageCompute || use == Use::kColorWrite || use == Use::kColorReadWrite ||
         use == Use::kDepthWrite || use == Use::kDepthReadWrite || use == Use::kTransferWrite;
}

}  // namespace tyndall::render
