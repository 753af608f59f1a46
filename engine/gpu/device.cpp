#include "gpu/device.hpp"

#include <algorithm>
#include <cstring>

#include "base/assert.hpp"
#include "base/log.hpp"
#include "pipeline_cache.hpp"
#include "state.hpp"
#include "vk_text.hpp"

namespace tyndall::gpu {

Resource::Resource(Device::State& owner, std::string resourceName) : device(owner), name(std::move(resourceName)) {
  const std::lock_guard lock(device.liveMutex);
  device.live.insert(this);
}

Resource::~Resource() {
  const std::lock_guard lock(device.liveMutex);
  device.live.erase(this);
}

Device::~Device() = default;

Device::State::~State() {
  if (device) {
    vkDeviceWaitIdle(device);
    recording = false;
    uploadStaging = {};
    readbackStaging = {};
    retired.clear();
    TY_ASSERT(live.empty(),
              std::to_string(live.size()) + " resources outlive their device, one is '" + (*live.begin())->name + "'");
    allocator.reset();
    for (const auto& [key, sampler] : samplers) vkDestroySampler(device, sampler, nullptr);
    savePipelineCache(*this);
    for (const Slot& slot : slots) vkDestroyCommandPool(device, slot.pool, nullptr);
    for (const OneShot& shot : idleOneShots) vkDestroyFence(device, shot.fence, nullptr);
    vkDestroyCommandPool(device, oneShotPool, nullptr);
    vkDestroySemaphore(device, timeline, nullptr);
    vkDestroyDevice(device, nullptr);
  }
  if (messenger) vkDestroyDebugUtilsMessengerEXT(instance, messenger, nullptr);
  if (instance && !sibling) vkDestroyInstance(instance, nullptr);
}

const DeviceInfo& Device::info() const { return state_->info; }
VkInstance Device::instance() const { return state_->instance; }
VkPhysicalDevice Device::physical() const { return state_->physical; }
VkDevice Device::handle() const { return state_->device; }
VkQueue Device::queue() const { return state_->queue; }
std::uint32_t Device::queueFamily() const { return state_->family; }
VkPipelineCache Device::pipelineCache() const { return state_->pipelineCache; }
VkDeviceSize Device::allocatedBytes() const { return state_->allocator->usedBytes(); }
std::vector<MemoryUser> Device::memoryUsers() const {
  std::vector<MemoryUser> users;
  for (const Allocation* allocation : state_->allocator->live()) users.push_back(allocation->user);
  std::sort(users.begin(), users.end(), [](const MemoryUser& a, const MemoryUser& b) {
    return a.bytes != b.bytes ? a.bytes > b.bytes : a.name < b.name;
  });
  return users;
}
std::uint32_t Device::validationMessages() const { return state_->validation.messages; }

void Device::setName(VkObjectType type, std::uint64_t handle, const std::string& name) {
  state_->name(type, handle, name);
}

void Device::State::name(VkObjectType type, std::uint64_t handle, const std::string& text) const {
  if (!debugNames || text.empty()) return;
  VkDebugUtilsObjectNameInfoEXT named{VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT, nullptr, type, handle,
                                      text.c_str()};
  vkSetDebugUtilsObjectNameEXT(device, &named);
}

Result<std::shared_ptr<Allocation>> Device::allocate(const VkMemoryRequirements& requirements,
                                                     const std::string& name) {
  auto made = state_->allocator->allocate(requirements, MemoryUse::kDevice, name);
  if (made) (*made)->user.shared = true;
  return made;
}

VkSampler Device::sampler(const VkSamplerCreateInfo& wanted) {
  VkSamplerCreateInfo info = wanted;
  if (!state_->anisotropy)
    info.anisotropyEnable = VK_FALSE;  // a quality that the device lacks, not a different picture
  // Everything behind pNext is 4 bytes wide, so the struct's tail has no padding and serves as the key.
  const std::size_t tail = offsetof(VkSamplerCreateInfo, flags);
  std::vector<std::byte> key(offsetof(VkSamplerCreateInfo, unnormalizedCoordinates) + sizeof(VkBool32) - tail);
  std::memcpy(key.data(), reinterpret_cast<const std::byte*>(&info) + tail, key.size());
  if (info.pNext) {
    const auto* reduction = static_cast<const VkSamplerReductionModeCreateInfo*>(info.pNext);
    TY_ASSERT(reduction->sType == VK_STRUCTURE_TYPE_SAMPLER_REDUCTION_MODE_CREATE_INFO && !reduction->pNext,
              "a sampler's pNext may hold a reduction mode only");
    key.push_back(static_cast<std::byte>(1 + reduction->reductionMode));
  }
  for (const auto& [known, sampler] : state_->samplers)
    if (known == key) return sampler;
  VkSampler sampler = VK_NULL_HANDLE;
  const VkResult result = vkCreateSampler(state_->device, &info, nullptr, &sampler);
  TY_ASSERT(result == VK_SUCCESS, "sampler: " + text(result));
  state_->samplers.emplace_back(std::move(key), sampler);
  return sampler;
}

void fullBarrier(VkCommandBuffer commands) {
  VkMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
  barrier.srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
  barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT | VK_PIPELINE_STAGE_2_HOST_BIT;
  barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
  VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  dependency.memoryBarrierCount = 1, dependency.pMemoryBarriers = &barrier;
  vkCmdPipelineBarrier2(commands, &dependency);
}

}  // namespace tyndall::gpu
