// What the room's files share of a device; nobody outside sees it.
#pragma once

#include <array>
#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "gpu/device.hpp"
#include "memory.hpp"

namespace tyndall::gpu {

/// What the GPU may still use when its owner lets go of it: destroyed by the destructor, at the right time by retire().
struct Resource {
  Resource(Device::State& owner, std::string resourceName);
  virtual ~Resource();
  Resource(const Resource&) = delete;
  Resource& operator=(const Resource&) = delete;
  Device::State& device;
  std::string name;
};

/// Counts and prints what the validation layer says.
struct ValidationLog {
  std::atomic<std::uint32_t> messages{0};
};
VkDebugUtilsMessengerCreateInfoEXT messengerInfo(ValidationLog& log);

struct Device::State {
  State() = default;
  ~State();
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  DeviceInfo info;
  ValidationLog validation;
  VkInstance instance = VK_NULL_HANDLE;
  bool sibling = false;  ///< the instance is another device's
  VkDebugUtilsMessengerEXT messenger = VK_NULL_HANDLE;
  VkPhysicalDevice physical = VK_NULL_HANDLE;
  VkDevice device = VK_NULL_HANDLE;
  VkQueue queue = VK_NULL_HANDLE;
  std::uint32_t family = 0;
  std::uint32_t timestampBits = 0;
  VkDeviceSize maxBufferBytes = 0;
  bool anisotropy = false, geometryShader = false, debugNames = false;

  VkPipelineCache pipelineCache = VK_NULL_HANDLE;
  std::filesystem::path pipelineCacheFile;   ///< empty: nowhere to keep it
  std::vector<std::byte> pipelineCacheRead;  ///< the file's content, to write only what changed

  std::unique_ptr<Allocator> allocator;

  std::function<void()> idle;                                                  ///< called while waiting; may be null
  VkResult wait(const std::function<VkResult(std::uint64_t)>& attempt) const;  ///< see Device

  // Frames. The timeline counts them: its value is the number of frames that the GPU has finished.
  struct Slot {
    VkCommandPool pool = VK_NULL_HANDLE;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    std::uint64_t frame = 0;  ///< the last frame submitted from this slot
  };
  std::array<Slot, 2> slots{};
  VkSemaphore timeline = VK_NULL_HANDLE;
  std::uint64_t submitted = 0;
  bool recording = false;
  VkCommandPool oneShotPool = VK_NULL_HANDLE;
  std::uint32_t oneShots = 0;  ///< submitAndWait calls on the stack
  struct OneShot {
    VkCommandBuffer commands = VK_NULL_HANDLE;
    VkFence fence = VK_NULL_HANDLE;
  };
  std::vector<OneShot> idleOneShots;  ///< of submissions that are finished
  Result<OneShot> takeOneShot();

  struct Retired {
    std::uint64_t frame = 0;  ///< may be destroyed once this frame is finished
    std::unique_ptr<Resource> resource;
  };
  std::vector<Retired> retired;
  bool unused = false;   ///< what is let go of now is in no frame, not even in the one being recorded
  std::mutex liveMutex;  ///< pipelines are made on other threads too
  std::unordered_set<const Resource*> live;

  std::vector<std::pair<std::vector<std::byte>, VkSampler>> samplers;
  Buffer uploadStaging, readbackStaging;

  /// Destroys now what the GPU cannot be using any more, else keeps it until the frame is finished.
  void retire(std::unique_ptr<Resource> resource);
  void collect();
  std::uint64_t finishedFrames() const;
  Result<void> waitForFrame(std::uint64_t frame) const;
  void name(VkObjectType type, std::uint64_t handle, const std::string& text) const;
  template <class Handle>
  void name(VkObjectType type, Handle* handle, const std::string& text) const {
    name(type, reinterpret_cast<std::uint64_t>(handle), text);
  }
};

template <class State>
void letGo(std::unique_ptr<State>& resource) {
  if (!resource) return;
  Device::State& device = resource->device;
  device.retire(std::move(resource));
}

struct Image::State : Resource {
  using Resource::Resource;
  ~State() override;
  VkImage image = VK_NULL_HANDLE;
  ImageDesc desc;
  std::shared_ptr<Allocation> memory;
  VkDeviceSize bytes = 0;
  mutable std::vector<std::pair<ViewDesc, VkImageView>> views;
};

struct Buffer::State : Resource {
  using Resource::Resource;
  ~State() override;
  VkBuffer buffer = VK_NULL_HANDLE;
  BufferDesc desc;
  std::shared_ptr<Allocation> memory;
  std::byte* mapped = nullptr;
};

/// A device and its queue family for graphics and compute.
struct Choice {
  VkPhysicalDevice physical = VK_NULL_HANDLE;
  std::uint32_t family = 0;
};
constexpr const char* kNoDriver =
    "Vulkan: there is no device; install a driver (package mesa-vulkan-drivers has one for the CPU)";
Result<Choice> chooseDevice(VkInstance instance, const DeviceOptions& options);
/// Places in `names` that `wanted` means: a number is an index and nothing else, other text part of a name in any case;
/// all of them if it is empty.
std::vector<std::size_t> matchingDevices(const std::vector<std::string>& names, const std::string& wanted);
bool hasExtension(VkPhysicalDevice physical, const char* name);

/// The features that the engine turns on: `required` must be there, `optional` are turned on where they are.
struct Features {
  VkPhysicalDeviceFeatures2 core{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
  VkPhysicalDeviceVulkan11Features v11{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES};
  VkPhysicalDeviceVulkan12Features v12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
  VkPhysicalDeviceVulkan13Features v13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
  Features();
  Features(const Features&) = delete;
  Features& operator=(const Features&) = delete;
  struct Named {
    const char* name;
    VkBool32* flag;
  };
  std::vector<Named> required(), optional();
};

}  // namespace tyndall::gpu
