// A GLFW window without an OpenGL context. GLFW is included by window.cpp and the files that read keys only.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <volk.h>

#include "base/result.hpp"

struct GLFWwindow;

namespace tyndall::editor {

class Window {
 public:
  /// Errors: no display (GLFW's reason is in the message). One window a program.
  static Result<std::unique_ptr<Window>> open(const std::string& title, std::pair<std::uint32_t, std::uint32_t> size);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// What a Vulkan instance needs to present to this window.
  Result<std::vector<std::string>> instanceExtensions() const;
  /// The caller destroys the surface.
  Result<VkSurfaceKHR> createSurface(VkInstance instance) const;

  /// Handles what has happened; waits for something to happen, but no longer than `seconds`.
  void poll();
  void wait(double seconds);
  bool closing() const;
  void close();
  /// Size in pixels; 0 by 0 while the window is minimised.
  std::pair<std::uint32_t, std::uint32_t> pixels() const;
  /// How large the display wants text, beside points that are larger than pixels: 1 or more, in eighths.
  float textScale() const;
  void resize(std::uint32_t width, std::uint32_t height);
  void setTitle(const std::string& title);

  GLFWwindow* handle() const { return window_; }

 private:
  Window() = default;
  GLFWwindow* window_ = nullptr;
};

}  // namespace tyndall::editor
