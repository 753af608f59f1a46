// Draws Dear ImGui's draw lists in a pass of the render graph. Our own, because the Vulkan backend of ImGui 1.86 has no
// textures but the font, no dynamic rendering, and does not go together with volk.
#pragma once

#include <array>
#include <map>
#include <memory>

#include "base/result.hpp"
#include "gpu/device.hpp"
#include "gpu/pipeline.hpp"
#include "render/graph.hpp"

struct ImDrawData;

namespace tyndall::editor {

/// What an ImTextureID of this program means: a number, not a pointer.
enum class Texture : std::intptr_t { kFont = 1, kPicture = 2, kFirstFree = 16 };

class ImGuiRenderer {
 public:
  /// Bakes the font atlas of the current ImGui context; `format` is that of the images drawn into.
  static Result<std::unique_ptr<ImGuiRenderer>> create(gpu::Device& device, VkFormat format);

  gpu::Device& device() { return device_; }
  /// The current context's font atlas has changed. Not between the begin and end of a frame.
  Result<void> makeFont();
  /// Another texture: what `image` holds in SHADER_READ_ONLY whenever a pass is added, until it is removed. `nearest`:
  /// texels are squares.
  Texture addTexture();
  void setTexture(Texture texture, const gpu::Image& image, bool nearest) { textures_[texture] = {&image, nearest}; }
  void removeTexture(Texture texture) { textures_.erase(texture); }

  /// Adds the pass "user interface", which clears `target` and draws `data` over it. Copies the vertices at once: call
  /// it between the device's begin and end of a frame. `picture` is what Texture::kPicture shows.
  Result<void> addPass(render::Graph& graph, const ImDrawData& data, render::ImageRef picture, render::ImageRef target);

 private:
  explicit ImGuiRenderer(gpu::Device& device) : device_(device) {}
  Result<void> makePipeline(VkFormat format);
  /// Vertices and indices of `data` in this frame's buffers.
  Result<void> copyGeometry(const ImDrawData& data);

  struct Geometry {
    gpu::Buffer vertices, indices;
  };
  gpu::Device& device_;
  gpu::Image font_;
  gpu::Pipeline pipeline_;
  VkSampler sampler_ = VK_NULL_HANDLE, nearest_ = VK_NULL_HANDLE;
  struct Shown {
    const gpu::Image* image = nullptr;
    bool nearest = false;
  };
  std::map<Texture, Shown> textures_;
  Texture nextTexture_ = Texture::kFirstFree;
  std::array<Geometry, 2> geometry_;  ///< as many as the device has frames in flight
};

}  // namespace tyndall::editor
