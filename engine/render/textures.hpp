// Textures with mipmaps, and their samplers.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "scene_resources.hpp"

namespace tyndall::render {

/// Uploads a scene's images at first use; an image used for colours is sRGB, for anything else linear, for both twice.
class TextureUploader {
 public:
  TextureUploader(gpu::Device& device, const scene::Scene& scene) : device_(device), scene_(scene) {}

  enum class Content { kColor, kData, kAlphaTest };
  /// A white texel for an unused texture.
  Result<TextureBinding> bind(const scene::TextureUse& use, Content content);

  std::vector<gpu::Image> takeImages() { return std::move(images_); }

 private:
  Result<VkImageView> viewOf(std::int32_t image, bool srgb);
  VkSampler sampler(const scene::Sampler& sampler, Content content);

  gpu::Device& device_;
  const scene::Scene& scene_;
  std::vector<gpu::Image> images_;
  std::map<std::pair<std::int32_t, bool>, VkImageView> views_;  ///< by image (kNone: white) and sRGB
};

/// An image of `rgba` texels with all mips, in SHADER_READ_ONLY.
Result<gpu::Image> uploadTexture(gpu::Device& device, const scene::Image& image, bool srgb);

}  // namespace tyndall::render
