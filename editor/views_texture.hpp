// RGBA bytes as a texture of the window's.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include <imgui.h>

#include "imgui_renderer.hpp"

namespace tyndall::editor {

class ViewTexture {
 public:
  ViewTexture() = default;
  ~ViewTexture() { clear(); }
  ViewTexture(const ViewTexture&) = delete;
  ViewTexture& operator=(const ViewTexture&) = delete;

  /// Uploads sRGB-coded RGBA bytes, width * height * 4 of them.
  Result<void> set(ImGuiRenderer& renderer, std::uint32_t width, std::uint32_t height,
                   std::span<const std::uint8_t> rgba);
  void clear();
  explicit operator bool() const { return texture_.has_value(); }
  /// For ImDrawList::AddImage in this frame. `nearest`: texels are squares.
  ImTextureID id(bool nearest) const;

 private:
  ImGuiRenderer* renderer_ = nullptr;
  std::unique_ptr<gpu::Image> image_;
  std::optional<Texture> texture_;
};

}  // namespace tyndall::editor
