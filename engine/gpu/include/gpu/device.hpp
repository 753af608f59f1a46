// A Vulkan 1.3 device: choice, memory, frames, deferred destruction. Headless; a window system is the caller's business
// (editor), which hands in instance extensions. volk loads Vulkan, so a machine without it gets an error, not a link
// failure.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <volk.h>

#include "base/result.hpp"

namespace tyndall::gpu {

struct DeviceOptions {
  std::string name;  ///< an index, else part of a device's name, case-insensitive; a number is never part of a name;
                     ///< empty: $TYNDALL_DEVICE, else the best (discrete, integrated, CPU)
  bool validation = false;  ///< validation layer with synchronization validation; its absence is an error
  bool window = false;      ///< enables VK_KHR_swapchain
  std::vector<std::string> instanceExtensions;
};

struct DeviceInfo {
  std::string name;    ///< "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string driver;  ///< "llvmpipe Mesa 22.3.6 (LLVM 15.0.6)"
  bool isCpu = false;
  std::uint32_t subgroupSize = 0;
  VkPhysicalDeviceLimits limits{};
  std::uint32_t maxPushDescriptors = 0;
  double timestampPeriodNs = 0;
};

struct ImageDesc {
  std::string name;  ///< debug name
  VkFormat format = VK_FORMAT_UNDEFINED;
  std::uint32_t width = 1, height = 1, depth = 1, layers = 1, mips = 1;
  VkImageType type = VK_IMAGE_TYPE_2D;
  VkImageUsageFlags usage = 0;
  bool operator==(const ImageDesc&) const = default;
};

/// What a piece of memory is for.
struct MemoryUser {
  std::string name;  ///< of the image or buffer, or of what shares it
  VkDeviceSize bytes = 0;
  std::optional<ImageDesc> image;  ///< where it is one image's
  bool shared = false;             ///< by several in turn (allocate())
};

class Allocator;
struct Allocation {  ///< a range of one of the allocator's blocks
  VkDeviceMemory memory = VK_NULL_HANDLE;
  VkDeviceSize offset = 0, size = 0;
  std::byte* mapped = nullptr;  ///< host address, or null
  std::uint32_t block = ~0u;
  MemoryUser user{};
};

/// Part of an image; counts of 0 mean "all from the base". `array` asks for an array view even of one layer.
struct ViewDesc {
  std::uint32_t baseMip = 0, mipCount = 0, baseLayer = 0, layerCount = 0;
  bool array = false;
  bool operator==(const ViewDesc&) const = default;
};

/// Binary semaphores around a frame's submission (window system).
struct FrameSignals {
  VkSemaphore wait = VK_NULL_HANDLE;
  VkPipelineStageFlags2 waitStage = 0;
  VkSemaphore signal = VK_NULL_HANDLE;
};

class Device;

/// A move-only image with its memory and views. Destroyed only after the GPU has finished the frames that may use it.
class Image {
 public:
  Image() noexcept;
  Image(Image&&) noexcept;
  Image& operator=(Image&&) noexcept;
  ~Image();
  explicit operator bool() const { return state_ != nullptr; }
  VkImage handle() const;
  const ImageDesc& desc() const;
  VkImageAspectFlags aspect() const;
  VkImageView view(const ViewDesc& desc = {}) const;  ///< cached
  VkDeviceSize bytes() const;
  struct State;

 private:
  friend class Device;
  std::unique_ptr<State> state_;
};

struct BufferDesc {
  std::string name;
  VkDeviceSize size = 0;
  VkBufferUsageFlags usage = 0;
  bool hostVisible = false;  ///< persistently mapped
};

class Buffer {
 public:
  Buffer() noexcept;
  Buffer(Buffer&&) noexcept;
  Buffer& operator=(Buffer&&) noexcept;
  ~Buffer();
  explicit operator bool() const { return state_ != nullptr; }
  VkBuffer handle() const;
  VkDeviceSize size() const;
  std::byte* mapped() const;  ///< null unless hostVisible
  struct State;

 private:
  friend class Device;
  std::unique_ptr<State> state_;
};

/// One device for the program. Not thread-safe: one thread owns it. Pipelines alone may be made (not destroyed) on
/// another thread, as long as the device lives.
class Device {
 public:
  static Result<std::unique_ptr<Device>> create(const DeviceOptions& options);
  /// Another logical device on the same hardware, for another thread: it has a queue and memory of its own. It shares
  /// the instance, so it must go first; the validation layer's messages about it count as this device's.
  Result<std::unique_ptr<Device>> createSibling() const;
  ~Device();

  const DeviceInfo& info() const;
  VkInstance instance() const;
  VkPhysicalDevice physical() const;
  VkDevice handle() const;
  VkQueue queue() const;
  std::uint32_t queueFamily() const;
  VkPipelineCache pipelineCache() const;

  Result<Image> createImage(const ImageDesc& desc);
  Result<Buffer> createBuffer(const BufferDesc& desc);
  /// Memory that several transient images and buffers share in turn (the render graph's aliasing). Sizes and alignments
  /// are rounded so that images and buffers may be neighbours; all zero for what the device does not take (create says
  /// why).
  VkMemoryRequirements requirements(const ImageDesc& desc);
  VkMemoryRequirements requirements(const BufferDesc& desc);
  Result<std::shared_ptr<Allocation>> allocate(const VkMemoryRequirements& requirements, const std::string& name);
  Result<Image> createImageAt(const ImageDesc& desc, std::shared_ptr<Allocation> memory, VkDeviceSize offset);
  Result<Buffer> createBufferAt(const BufferDesc& desc, std::shared_ptr<Allocation> memory, VkDeviceSize offset);

  /// Cached for the device's life. Anisotropy is dropped where the device has none; pNext may hold a reduction mode.
  VkSampler sampler(const VkSamplerCreateInfo& info);

  /// Records and submits one command buffer and waits for it. For uploads, readback, tests.
  Result<void> submitAndWait(const std::function<void(VkCommandBuffer)>& record);
  /// Frame loop: at most two frames in flight; begin waits for the slot and frees what was deferred for it. A second
  /// begin without an end drops what was recorded.
  Result<VkCommandBuffer> beginFrame();
  Result<void> endFrame(const FrameSignals& signals = {});
  std::uint64_t submittedFrames() const;  ///< value of the timeline semaphore once the last submitted frame is done
  Result<void> waitIdle();
  /// Waits until the last submitted frame is done. Cheaper than waitIdle(), and leaves what was presented alone.
  Result<void> waitForFrames();
  /// `idle` is called every few milliseconds whenever this object waits for the GPU, on the thread that waits. It must
  /// not use the device. A window answers its events there. Null: nothing is called.
  void whileWaiting(std::function<void()> idle);
  /// Waits in the same way for something else: calls `attempt` with a limit in ns while it gives VK_TIMEOUT or
  /// VK_NOT_READY.
  VkResult wait(const std::function<VkResult(std::uint64_t)>& attempt) const;
  /// Waits for the GPU and destroys at once what was let go of and what `letGo` lets go of. For a lack of memory while
  /// a frame is being recorded: no command that uses any of it may have been recorded into that frame.
  Result<void> destroyNow(const std::function<void()>& letGo);

  /// Copies the whole of one mip of one layer, tightly packed (a 3D image: all its slices), and waits. Whatever its
  /// layout was, that part is then in SHADER_READ_ONLY_OPTIMAL if the image can be sampled, else in GENERAL.
  Result<void> upload(Image& image, std::span<const std::byte> texels, std::uint32_t mip = 0, std::uint32_t layer = 0);
  /// Frames submitted earlier still see the old bytes, later ones the new.
  Result<void> upload(Buffer& buffer, std::span<const std::byte> bytes, VkDeviceSize offset = 0);
  /// The image must be in `layout`; it is returned to it. Tightly packed rows.
  Result<std::vector<std::byte>> readback(const Image& image, VkImageLayout layout, std::uint32_t mip = 0,
                                          std::uint32_t layer = 0);
  Result<std::vector<std::byte>> readback(const Buffer& buffer);

  VkDeviceSize allocatedBytes() const;  ///< in use by images and buffers, without the blocks' free space
  std::vector<MemoryUser> memoryUsers()
      const;  ///< whose bytes these are, the largest first; what is let go of counts until the GPU is done with it
  std::uint32_t validationMessages() const;  ///< warnings and errors so far (also printed)
  void setName(VkObjectType type, std::uint64_t handle, const std::string& name);

  struct State;
  State& state() { return *state_; }

 private:
  Device() = default;
  std::unique_ptr<State> state_;
};

/// Bytes of one texel of the formats the engine uses; 0 for others.
std::uint32_t texelBytes(VkFormat format);

/// Full barrier between everything before and everything after.
void fullBarrier(VkCommandBuffer commands);
/// Moves a whole image between layouts with a full barrier; for uploads and tests, the graph derives its own.
void transition(VkCommandBuffer commands, const Image& image, VkImageLayout from, VkImageLayout to);

}  // namespace tyndall::gpu
