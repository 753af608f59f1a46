#include "window.hpp"

#include <algorithm>
#include <cmath>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace tyndall::editor {
namespace {

std::string reason() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "GLFW gives no reason";
}

Error noDisplay() {
  return failed("window: " + reason() + "; a display is needed (DISPLAY), 'tyndall render' works without one");
}

}  // namespace

Result<std::unique_ptr<Window>> Window::open(const std::string& title, std::pair<std::uint32_t, std::uint32_t> size) {
  if (!glfwInit()) return noDisplay();
  std::unique_ptr<Window> window(new Window);  // from here on its destructor ends GLFW
  if (!glfwVulkanSupported())
    return failed("window: no Vulkan that can present to a window; install a driver (package mesa-vulkan-drivers)");
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  window->window_ =
      glfwCreateWindow(static_cast<int>(size.first), static_cast<int>(size.second), title.c_str(), nullptr, nullptr);
  if (!window->window_) return noDisplay();
  return window;
}

Window::~Window() {
  if (window_) glfwDestroyWindow(window_);
  glfwTerminate();
}

Result<std::vector<std::string>> Window::instanceExtensions() const {
  std::uint32_t count = 0;
  const char** names = glfwGetRequiredInstanceExtensions(&count);
  if (!names) return failed("window: Vulkan cannot present to it: " + reason());
  return std::vector<std::string>(names, names + count);
}

Result<VkSurfaceKHR> Window::createSurface(VkInstance instance) const {
  VkSurfaceKHR surface = VK_NULL_HANDLE;
  if (glfwCreateWindowSurface(instance, window_, nullptr, &surface) != VK_SUCCESS)
    return failed("window: no Vulkan surface: " + reason());
  return surface;
}

void Window::poll() { glfwPollEvents(); }
void Window::wait(double seconds) { glfwWaitEventsTimeout(seconds); }
bool Window::closing() const { return glfwWindowShouldClose(window_); }
void Window::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }
void Window::resize(std::uint32_t width, std::uint32_t height) {
  glfwSetWindowSize(window_, static_cast<int>(width), static_cast<int>(height));
}
void Window::setTitle(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

float Window::textScale() const {
  float scale = 1, unused = 1;
  glfwGetWindowContentScale(window_, &scale, &unused);
  int width = 0, height = 0;
  glfwGetWindowSize(window_, &width, &height);
  // Where points are larger than pixels already, the text is as well.
  const float pixelsPerPoint = width > 0 ? static_cast<float>(pixels().first) / static_cast<float>(width) : 1;
  // In eighths: the ratio of whole pixels to whole points changes a little with the window's size.
  return std::max(std::round(8 * scale / std::max(pixelsPerPoint, 1e-3f)) / 8, 1.0f);
}

std::pair<std::uint32_t, std::uint32_t> Window::pixels() const {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  return {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
}

}  // namespace tyndall::editor
