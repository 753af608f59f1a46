#include "faults.hpp"

#include <atomic>

#include <volk.h>

namespace tyndall::editor {
namespace {

PFN_vkAcquireNextImageKHR acquireNextImage = nullptr;
PFN_vkQueuePresentKHR queuePresent = nullptr;
PFN_vkGetPhysicalDeviceSurfaceCapabilitiesKHR surfaceCapabilities = nullptr;
PFN_vkAllocateMemory allocateMemory = nullptr;

// The builder's thread asks for memory too.
std::atomic<Fault> ordered{Fault::kNone};
std::atomic<std::uint32_t> left{0}, count{0};

bool happens(Fault fault) {
  if (ordered != fault || left == 0) return false;
  if (--left == 0) ordered = Fault::kNone;
  ++count;
  return true;
}

VKAPI_ATTR VkResult VKAPI_CALL acquireOrFail(VkDevice device, VkSwapchainKHR swapchain, std::uint64_t timeout,
                                             VkSemaphore semaphore, VkFence fence, std::uint32_t* index) {
  if (happens(Fault::kOutOfDate)) return VK_ERROR_OUT_OF_DATE_KHR;
  if (happens(Fault::kSurfaceLost)) return VK_ERROR_SURFACE_LOST_KHR;
  const VkResult result = acquireNextImage(device, swapchain, timeout, semaphore, fence, index);
  return result == VK_SUCCESS && happens(Fault::kSuboptimal) ? VK_SUBOPTIMAL_KHR : result;
}

VKAPI_ATTR VkResult VKAPI_CALL presentOrFail(VkQueue queue, const VkPresentInfoKHR* info) {
  const VkResult result = queuePresent(queue, info);
  if (result != VK_SUCCESS) return result;
  if (happens(Fault::kOutOfDateLate)) return VK_ERROR_OUT_OF_DATE_KHR;
  return happens(Fault::kSurfaceLostLate) ? VK_ERROR_SURFACE_LOST_KHR : result;
}

VKAPI_ATTR VkResult VKAPI_CALL capabilitiesOrFail(VkPhysicalDevice physical, VkSurfaceKHR surface,
                                                  VkSurfaceCapabilitiesKHR* capabilities) {
  if (happens(Fault::kSurfaceLost)) return VK_ERROR_SURFACE_LOST_KHR;
  const VkResult result = surfaceCapabilities(physical, surface, capabilities);
  // What a window that is minimised has, on systems that have such windows.
  if (result == VK_SUCCESS && happens(Fault::kNoArea)) capabilities->currentExtent = {0, 0};
  return result;
}

VKAPI_ATTR VkResult VKAPI_CALL allocateOrFail(VkDevice device, const VkMemoryAllocateInfo* info,
                                              const VkAllocationCallbacks* callbacks, VkDeviceMemory* memory) {
  return happens(Fault::kNoMemory) ? VK_ERROR_OUT_OF_DEVICE_MEMORY : allocateMemory(device, info, callbacks, memory);
}

}  // namespace

Faults::Faults() {
  acquireNextImage = vkAcquireNextImageKHR, vkAcquireNextImageKHR = acquireOrFail;
  queuePresent = vkQueuePresentKHR, vkQueuePresentKHR = presentOrFail;
  surfaceCapabilities = vkGetPhysicalDeviceSurfaceCapabilitiesKHR,
  vkGetPhysicalDeviceSurfaceCapabilitiesKHR = capabilitiesOrFail;
  allocateMemory = vkAllocateMemory, vkAllocateMemory = allocateOrFail;
}

Faults::~Faults() {
  withdraw();
  vkAcquireNextImageKHR = acquireNextImage;
  vkQueuePresentKHR = queuePresent;
  vkGetPhysicalDeviceSurfaceCapabilitiesKHR = surfaceCapabilities;
  vkAllocateMemory = allocateMemory;
}

void Faults::order(Fault fault, std::uint32_t times) {
  left = times;
  ordered = fault;
}

void Faults::withdraw() {
  ordered = Fault::kNone;
  left = 0;
}

std::uint32_t Faults::happened() const { return count; }

}  // namespace tyndall::editor
