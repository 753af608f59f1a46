#include "canvas.hpp"

#include <cmath>

#include "mesh_builder.hpp"

namespace tyndall::levels {
namespace {

std::uint8_t byte(float value) {
  return static_cast<std::uint8_t>(std::lround(255.0f * glm::clamp(value, 0.0f, 1.0f)));
}

scene::Image blank(const std::string& name, int width, int height) {
  scene::Image image;
  image.name = name;
  image.width = static_cast<std::uint32_t>(width);
  image.height = static_cast<std::uint32_t>(height);
  image.rgba.reserve(static_cast<std::size_t>(width) * height * 4);
  return image;
}

}  // namespace

Surface::Surface(int w, int h, const std::function<Texel(glm::vec2 uv)>& paint) : width(w), height(h) {
  texels.reserve(static_cast<std::size_t>(w) * h);
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      texels.push_back(paint((glm::vec2(x, y) + 0.5f) / glm::vec2(w, h)));
    }
  }
}

scene::Image Surface::colorImage(const std::string& name) const {
  scene::Image image = blank(name, width, height);
  for (const Texel& t : texels)
    image.rgba.insert(image.rgba.end(), {byte(t.color.r), byte(t.color.g), byte(t.color.b), 255});
  return image;
}

scene::Image Surface::normalImage(const std::string& name) const {
  scene::Image image = blank(name, width, height);
  const auto at = [&](int x, int y) {
    return texels[static_cast<std::size_t>((y + height) % height) * width + (x + width) % width].height;
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      // Green points up in the image, against the rows.
      const glm::vec3 n = glm::normalize(glm::vec3(at(x - 1, y) - at(x + 1, y), at(x, y + 1) - at(x, y - 1), 2.0f));
      image.rgba.insert(image.rgba.end(),
                        {byte(0.5f + 0.5f * n.x), byte(0.5f + 0.5f * n.y), byte(0.5f + 0.5f * n.z), 255});
    }
  }
  return image;
}

scene::Image Surface::roughnessImage(const std::string& name) const {
  scene::Image image = blank(name, width, height);
  for (const Texel& t : texels) image.rgba.insert(image.rgba.end(), {255, byte(t.roughness), 0, 255});
  return image;
}

void Cutout::paint(glm::vec2 min, glm::vec2 max, const std::function<glm::vec4(glm::vec2 uv)>& shape) {
  constexpr int kSamples = 3;  // a side
  const glm::vec2 size(width_, height_);
  const glm::ivec2 low = glm::max(glm::ivec2(glm::floor(min * size)), glm::ivec2(0));
  const glm::ivec2 high = glm::min(glm::ivec2(glm::ceil(max * size)), glm::ivec2(width_, height_));
  for (int y = low.y; y < high.y; ++y) {
    for (int x = low.x; x < high.x; ++x) {
      glm::vec4 sum(0);
      for (int s = 0; s < kSamples * kSamples; ++s) {
        const glm::vec2 offset = (glm::vec2(s % kSamples, s / kSamples) + 0.5f) / real(kSamples);
        const glm::vec4 c = shape((glm::vec2(x, y) + offset) / size);
        sum += glm::vec4(glm::vec3(c) * c.a, c.a);
      }
      sum /= real(kSamples * kSamples);
      glm::vec4& under = rgba_[static_cast<std::size_t>(y) * width_ + x];
      under = sum + under * (1.0f - sum.a);
    }
  }
}

scene::Image Cutout::image(const std::string& name, const glm::vec3& background) const {
  scene::Image image = blank(name, width_, height_);
  for (const glm::vec4& c : rgba_) {
    const glm::vec3 color = c.a > 1.0f / 255 ? glm::vec3(c) / c.a : background;
    image.rgba.insert(image.rgba.end(), {byte(color.r), byte(color.g), byte(color.b), byte(c.a)});
  }
  return image;
}

}  // namespace tyndall::levels
