// Alpha of MASK materials, fetched as a GPU fetches the full-resolution image.
#pragma once

#include <cstdint>

#include <glm/glm.hpp>

#include "scene/scene.hpp"

namespace tyndall::truth {

/// KHR_texture_transform as a matrix for (u, v, 1): offset + rotation * (scale * uv). The rotation is counter-clockwise
/// to the eye; as v points down, it takes (1, 0) to (cos, -sin).
glm::dmat3x2 uvTransform(const scene::TextureUse& use);

/// Alpha in [0, 1]: bilinear over the texels around uv * size - 1/2, or the texel at uv * size when the sampler
/// magnifies with kNearest; wrapped as the sampler says. `image` is not empty.
double fetchAlpha(const scene::Image& image, const scene::Sampler& sampler, glm::dvec2 uv);

/// Whether the points of one primitive are there at all.
class Mask {
 public:
  /// Keeps references to the scene. `material.alphaMode` is kMask.
  Mask(const scene::Scene& scene, const scene::Primitive& primitive, const scene::Material& material);

  /// At barycentric weights u of the second and v of the third vertex: base colour alpha (factor, texture, vertex
  /// colour) against the cutoff; at or above it there is surface (glTF 2.0, 3.9.4).
  bool covers(std::uint32_t triangle, double u, double v) const;

 private:
  const scene::Primitive& primitive_;
  const scene::Material& material_;
  const scene::Image* image_ = nullptr;  ///< null: no texture, alpha 1
  scene::Sampler sampler_;
  glm::dmat3x2 uvTransform_{1};
};

}  // namespace tyndall::truth
