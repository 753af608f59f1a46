// The window's images. Nothing is drawn into them: a finished image of the same size and format is copied there.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/result.hpp"
#include "gpu/device.hpp"
#include "window.hpp"

namespace tyndall::editor {

class Swapchain {
 public:
  /// Errors: the device cannot present to the window, or offers no 8-bit unorm format that can be copied to.
  static Result<std::unique_ptr<Swapchain>> create(gpu::Device& device, const Window& window);
  ~Swapchain();
  Swapchain(const Swapchain&) = delete;
  Swapchain& operator=(const Swapchain&) = delete;

  /// B8G8R8A8_UNORM or R8G8B8A8_UNORM: the picture is sRGB-coded already, the window system must not code it again.
  VkFormat format() const { return format_.format; }
  VkExtent2D extent() const { return extent_; }

  /// Makes the images anew when the window has another size or the surface asked for it. False while the window has no
  /// area. (Some systems never say "out of date", so the size is compared each time.) Also makes a new surface when the
  /// last one was lost; false while that fails, an error when it goes on failing.
  Result<bool> fit(std::pair<std::uint32_t, std::uint32_t> pixels);

  struct Target {
    std::uint32_t index = 0;
    VkImage image = VK_NULL_HANDLE;
    gpu::FrameSignals signals;
  };
  /// The image for the frame begun on the device. Empty when there is none now: the frame is then not shown.
  Result<std::optional<Target>> acquire();
  /// Shows it after its frame was submitted with `target.signals`.
  Result<void> present(const Target& target);

 private:
  Swapchain(gpu::Device& device, const Window& window) : device_(device), window_(window) {}
  Result<void> makeSurface();
  Result<void> chooseFormat();
  /// False: the surface is lost.
  Result<bool> make(VkExtent2D extent, const VkSurfaceCapabilitiesKHR& surface);
  void destroyImages();
  void destroySurface();
  Result<bool> lose();

  gpu::Device& device_;
  const Window& window_;
  VkSurfaceKHR surface_ = VK_NULL_HANDLE;
  VkSurfaceFormatKHR format_{};
  VkExtent2D extent_{0, 0};
  VkSwapchainKHR swapchain_ = VK_NULL_HANDLE;
  std::vector<VkImage> images_;
  std::vector<VkSemaphore> drawn_;         ///< per image: its presentation waits for it
  std::array<VkSemaphore, 2> acquired_{};  ///< per frame in flight
  bool stale_ = true;
  bool lost_ = false;         ///< the surface: the next fit() makes another
  std::uint32_t losses_ = 0;  ///< of surfaces, since an image could be drawn to
};

}  // namespace tyndall::editor
