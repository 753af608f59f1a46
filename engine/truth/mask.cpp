#include "mask.hpp"

#include <cmath>

#include "texture.hpp"

namespace tyndall::truth {

glm::dmat3x2 uvTransform(const scene::TextureUse& use) {
  const double c = std::cos(double{use.rotation}), s = std::sin(double{use.rotation});
  return {double{use.scale.x} * glm::dvec2(c, -s), double{use.scale.y} * glm::dvec2(s, c), glm::dvec2(use.offset)};
}

double fetchAlpha(const scene::Image& image, const scene::Sampler& sampler, glm::dvec2 uv) {
  const Grid grid{image.width, image.height, sampler.wrapU, sampler.wrapV};
  const auto texel = [&](std::int64_t i, std::int64_t j) {
    return image.rgba[static_cast<std::size_t>((j * grid.width + i) * 4 + 3)] / 255.0;
  };
  if (sampler.magnify != scene::Filter::kNearest) return bilinear(grid, uv, texel);
  const double x = reduced(uv.x, grid.wrapU) * static_cast<double>(grid.width);
  const double y = reduced(uv.y, grid.wrapV) * static_cast<double>(grid.height);
  return texel(wrapped(static_cast<std::int64_t>(std::floor(x)), grid.width, grid.wrapU),
               wrapped(static_cast<std::int64_t>(std::floor(y)), grid.height, grid.wrapV));
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
