#include "views_texture.hpp"

namespace tyndall::editor {

Result<void> ViewTexture::set(ImGuiRenderer& renderer, std::uint32_t width, std::uint32_t height,
                              std::span<const std::uint8_t> rgba) {
  if (!image_ || image_->desc().width != width || image_->desc().height != height) {
    gpu::ImageDesc desc{.name = "shown view", .format = VK_FORMAT_R8G8B8A8_UNORM, .width = width, .height = height};
    desc.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    auto made = renderer.device().createImage(desc);
    if (!made) return made.error();
    clear();
    image_ = std::make_unique<gpu::Image>(made.take());
    renderer_ = &renderer;
    texture_ = renderer.addTexture();
  }
  const std::span texels(reinterpret_cast<const std::byte*>(rgba.data()), rgba.size());
  if (auto done = renderer.device().upload(*image_, texels); !done) {
    clear();
    return done;
  }
  renderer.setTexture(*texture_, *image_, true);
  return {};
}

void ViewTexture::clear() {
  if (texture_) renderer_->removeTexture(*texture_);
  texture_.reset();
  image_.reset();
}

ImTextureID ViewTexture::id(bool nearest) const {
  renderer_->setTexture(*texture_, *image_, nearest);
  return reinterpret_cast<ImTextureID>(*texture_);
}

}  // namespace tyndall::editor
