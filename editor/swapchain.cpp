#include "swapchain.hpp"

#include <algorithm>
#include <limits>
#include <string>

namespace tyndall::editor {
namespace {

constexpr std::uint32_t kMostLosses = 20;  // then it is no passing trouble of the window system

Error failure(const char* what, VkResult result) {
  return failed(std::string("window: ") + what + " (VkResult " + std::to_string(result) + ")");
}

VkSemaphore makeSemaphore(VkDevice device) {
  VkSemaphoreCreateInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
  VkSemaphore semaphore = VK_NULL_HANDLE;
  return vkCreateSemaphore(device, &info, nullptr, &semaphore) == VK_SUCCESS ? semaphore : VK_NULL_HANDLE;
}

}  // namespace

Result<std::unique_ptr<Swapchain>> Swapchain::create(gpu::Device& device, const Window& window) {
  std::unique_ptr<Swapchain> made(new Swapchain(device, window));
  if (auto surface = made->makeSurface(); !surface) return surface.error();
  for (VkSemaphore& semaphore : made->acquired_)
    if (!(semaphore = makeSemaphore(device.handle()))) return failed("window: no semaphore");
  return made;
}

Swapchain::~Swapchain() {
  (void)device_.waitIdle();  // nothing can be reported from here
  destroySurface();
  for (VkSemaphore semaphore : acquired_) vkDestroySemaphore(device_.handle(), semaphore, nullptr);
}

Result<void> Swapchain::makeSurface() {
  auto surface = window_.createSurface(device_.instance());
  if (!surface) return surface.error();
  surface_ = *surface;
  VkBool32 supported = VK_FALSE;
  vkGetPhysicalDeviceSurfaceSupportKHR(device_.physical(), device_.queueFamily(), surface_, &supported);
  if (!supported)
    return failed("window: " + device_.info().name + " cannot present to it; choose another with --device");
  const VkFormat before = format_.format;
  if (auto chosen = chooseFormat(); !chosen) return chosen.error();
  // What draws the window is made for its format.
  if (before != VK_FORMAT_UNDEFINED && before != format_.format)
    return failed("window: its new surface offers another format than the lost one");
  return {};
}

void Swapchain::destroySurface() {
  destroyImages();
  vkDestroySwapchainKHR(device_.handle(), swapchain_, nullptr);
  swapchain_ = VK_NULL_HANDLE;
  if (surface_) vkDestroySurfaceKHR(device_.instance(), surface_, nullptr);
  surface_ = VK_NULL_HANDLE;
  stale_ = true;
}

/// Puts a new surface in the place of one that the window system has taken away.
Result<bool> Swapchain::lose() {
  if (++losses_ > kMostLosses) return failed("window: its surface is lost again and again");
  if (auto idle = device_.waitIdle(); !idle) return idle.error();
  destroySurface();
  lost_ = false;
  if (auto made = makeSurface(); !made) return made.error();
  return false;
}

void Swapchain::destroyImages() {
  for (VkSemaphore semaphore : drawn_) vkDestroySemaphore(device_.handle(), semaphore, nullptr);
  drawn_.clear();
  images_.clear();
}

Result<void> Swapchain::chooseFormat() {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceSurfaceFormatsKHR(device_.physical(), surface_, &count, nullptr);
  std::vector<VkSurfaceFormatKHR> formats(count);
  vkGetPhysicalDeviceSurfaceFormatsKHR(device_.physical(), surface_, &count, formats.data());
  for (const VkFormat wanted : {VK_FORMAT_B8G8R8A8_UNORM, VK_FORMAT_R8G8B8A8_UNORM})
    for (const VkSurfaceFormatKHR& offered : formats)
      if (offered.format == wanted && offered.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR) {
        format_ = offered;
        return {};
      }
  return failed("window: the surface offers no 8-bit unorm format");
}

Result<bool> Swapchain::fit(std::pair<std::uint32_t, std::uint32_t> pixels) {
  if (lost_)
    if (auto made = lose(); !made) return made;
  if (pixels.first == 0 || pixels.second == 0) return false;
  if (!stale_ && extent_.width == pixels.first && extent_.height == pixels.second) return true;
  VkSurfaceCapabilitiesKHR surface{};
  const VkResult result = vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device_.physical(), surface_, &surface);
  if (result == VK_ERROR_SURFACE_LOST_KHR) return lose();
  if (result) return failure("its surface cannot be read", result);
  if (!(surface.supportedUsageFlags & VK_IMAGE_USAGE_TRANSFER_DST_BIT))
    return failed("window: its images cannot be copied to");
  VkExtent2D extent = surface.currentExtent;
  if (extent.width == std::numeric_limits<std::uint32_t>::max())  // the surface takes the size of its images
    extent = {std::clamp(pixels.first, surface.minImageExtent.width, surface.maxImageExtent.width),
              std::clamp(pixels.second, surface.minImageExtent.height, surface.maxImageExtent.height)};
  if (extent.width == 0 || extent.height == 0) return false;
  auto made = make(extent, surface);
  return made && !*made ? lose() : made;
}

Result<bool> Swapchain::make(VkExtent2D extent, const VkSurfaceCapabilitiesKHR& surface) {
  if (auto idle = device_.waitIdle(); !idle) return idle.error();
  destroyImages();
  VkSwapchainCreateInfoKHR info{VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR};
  info.surface = surface_;
  info.minImageCount = surface.minImageCount + 1;  // one to draw while the others are shown or wait
  if (surface.maxImageCount > 0) info.minImageCount = std::min(info.minImageCount, surface.maxImageCount);
  info.imageFormat = format_.format, info.imageColorSpace = format_.colorSpace;
  info.imageExtent = extent, info.imageArrayLayers = 1;
  info.imageUsage = VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  info.preTransform = surface.currentTransform;
  info.compositeAlpha = VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR;
  info.presentMode = VK_PRESENT_MODE_FIFO_KHR;  // always there, and never tears
  info.clipped = VK_TRUE;
  info.oldSwapchain = swapchain_;
  VkSwapchainKHR made = VK_NULL_HANDLE;
  const VkResult result = vkCreateSwapchainKHR(device_.handle(), &info, nullptr, &made);
  vkDestroySwapchainKHR(device_.handle(), swapchain_, nullptr);
  swapchain_ = result == VK_SUCCESS ? made : VK_NULL_HANDLE;
  if (result == VK_ERROR_SURFACE_LOST_KHR) return false;
  if (result) return failure("no swapchain", result);
  std::uint32_t count = 0;
  vkGetSwapchainImagesKHR(device_.handle(), swapchain_, &count, nullptr);
  images_.resize(count);
  vkGetSwapchainImagesKHR(device_.handle(), swapchain_, &count, images_.data());
  for (std::uint32_t i = 0; i < count; ++i) {
    drawn_.push_back(makeSemaphore(device_.handle()));
    if (!drawn_.back()) return failed("window: no semaphore");
  }
  extent_ = extent;
  stale_ = false;
  return true;
}

Result<std::optional<Swapchain::Target>> Swapchain::acquire() {
  // The slot's last frame is finished (the device has waited for it), and with it the last wait for this semaphore.
  const VkSemaphore semaphore = acquired_[device_.submittedFrames() % acquired_.size()];
  Target target;
  const VkResult result = device_.wait([&](std::uint64_t ns) {
    return vkAcquireNextImageKHR(device_.handle(), swapchain_, ns, semaphore, VK_NULL_HANDLE, &target.index);
  });
  if (result == VK_ERROR_OUT_OF_DATE_KHR || result == VK_ERROR_SURFACE_LOST_KHR) {
    stale_ = true;
    lost_ = result == VK_ERROR_SURFACE_LOST_KHR;
    return std::optional<Target>();
  }
  if (result == VK_SUBOPTIMAL_KHR)
    stale_ = true;  // it can still be shown this once
  else if (result)
    return failure("no image to draw into", result);
  losses_ = 0;
  target.image = images_[target.index];
  target.signals = {semaphore, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, drawn_[target.index]};
  return std::optional<Target>(target);
}

Result<void> Swapchain::present(const Target& target) {
  // A CPU's driver waits for the frame before it copies it to the window: that wait is made where events are taken.
  if (device_.info().isCpu)
    if (auto waited = device_.waitForFrames(); !waited) return waited;
  VkPresentInfoKHR info{VK_STRUCTURE_TYPE_PRESENT_INFO_KHR};
  info.waitSemaphoreCount = 1, info.pWaitSemaphores = &target.signals.signal;
  info.swapchainCount = 1, info.pSwapchains = &swapchain_, info.pImageIndices = &target.index;
  const VkResult result = vkQueuePresentKHR(device_.queue(), &info);
  lost_ = result == VK_ERROR_SURFACE_LOST_KHR;
  if (result == VK_ERROR_OUT_OF_DATE_KHR || result == VK_SUBOPTIMAL_KHR || lost_)
    stale_ = true;
  else if (result)
    return failure("a frame cannot be shown", result);
  return {};
}

}  // namespace tyndall::editor
