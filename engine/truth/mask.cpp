#include "mask.hpp"

#include <algorithm>
#include <cmath>

namespace tyndall::truth {
namespace {

/// Moves a coordinate into the wrap mode's first period, so that huge ones fit an integer after scaling.
double reduced(double coordinate, scene::Wrap wrap) {
  switch (wrap) {
    case scene::Wrap::kRepeat: return coordinate - std::floor(coordinate);
    case scene::Wrap::kMirroredRepeat: return coordinate - 2 * std::floor(coordinate / 2);
    case scene::Wrap::kClampToEdge: break;
  }
  return std::clamp(coordinate, -1.0, 2.0);
}

std::int64_t modulo(std::int64_t i, std::int64_t n) { return (i % n + n) % n; }

/// Vulkan 1.3, "Wrapping Operation".
std::int64_t wrapped(std::int64_t texel, std::int64_t size, scene::Wrap wrap) {
  switch (wrap) {
    case scene::Wrap::kRepeat: return modulo(texel, size);
    case scene::Wrap::kMirroredRepeat: {
      const std::int64_t i = modulo(texel, 2 * size) - size;
      return size - 1 - (i >= 0 ? i : -(1 + i));
    }
    case scene::Wrap::kClampToEdge: break;
  }
  return std::clamp<std::int64_t>(texel, 0, size - 1);
}

}  // namespace

glm::dmat3x2 uvTransform(const scene::TextureUse& use) {
  const double c = std::cos(double{use.rotation}), s = std::sin(double{use.rotation});
  return {double{use.scale.x} * glm::dvec2(c, -s), double{use.scale.y} * glm::dvec2(s, c), glm::dvec2(use.offset)};
}

double fetchAlpha(const scene::Image& image, const scene::Sampler& sampler, glm::dvec2 uv) {
  const std::int64_t width = image.width, height = image.height;
  const double x = reduced(uv.x, sampler.wrapU) * static_cast<double>(width);
  const double y = reduced(uv.y, sampler.wrapV) * static_cast<double>(height);
  const auto column = [&](double i) { return wrapped(static_cast<std::int64_t>(i), width, sampler.wrapU); };
  const auto row = [&](double j) { return wrapped(static_cast<std::int64_t>(j), height, sampler.wrapV); };
  const auto texel = [&](std::int64_t i, std::int64_t j) {
    return image.rgba[static_cast<std::size_t>((j * width + i) * 4 + 3)] / 255.0;
  };
  if (sampler.magnify == scene::Filter::kNearest) return texel(column(std::floor(x)), row(std::floor(y)));
  const double i = std::floor(x - 0.5), j = std::floor(y - 0.5);
  const double a = x - 0.5 - i, b = y - 0.5 - j;
  const std::int64_t left = column(i), right = column(i + 1), top = row(j), bottom = row(j + 1);
  return (1 - b) * ((1 - a) * texel(left, top) + a * texel(right, top)) +
         b * ((1 - a) * texel(left, bottom) + a * texel(right, bottom));
}

Mask::Mask(const scene::Scene& scene, const scene::Primitive& primitive, const scene::Material& material)
    : primitive_(primitive), material_(material) {
  const scene::TextureUse& use = material.baseColorTexture;
  if (!use.used()) return;
  const scene::Texture& texture = scene.textures[static_cast<std::size_t>(use.texture)];
  if (texture.image == scene::kNone) return;
  image_ = &scene.images[static_cast<std::size_t>(texture.image)];
  sampler_ = texture.sampler;
  uvTransform_ = uvTransform(use);
}

bool Mask::covers(std::uint32_t triangle, double u, double v) const {
  const std::uint32_t* corner = primitive_.indices.data() + std::size_t{triangle} * 3;
  const scene::Vertex &a = primitive_.vertices[corner[0]], &b = primitive_.vertices[corner[1]],
                      &c = primitive_.vertices[corner[2]];
  const double w = 1 - u - v;
  double alpha = double{material_.baseColor.a} * (w * a.color.a + u * b.color.a + v * c.color.a);
  if (image_) {
    const glm::dvec2 uv = w * glm::dvec2(a.uv) + u * glm::dvec2(b.uv) + v * glm::dvec2(c.uv);
    alpha *= fetchAlpha(*image_, sampler_, uvTransform_ * glm::dvec3(uv, 1));
  }
  return alpha >= double{material_.alphaCutoff};
}

}  // namespace tyndall::truth
