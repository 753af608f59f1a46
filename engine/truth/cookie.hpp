// The image that a light shines through (docs/conventions.md, "Cookies"): full resolution, bilinear, in linear light.
#pragma once

#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "scene/scene.hpp"
#include "texture.hpp"

namespace tyndall::truth {

class LightImage {
 public:
  /// Nothing for a light without a cookie. `eye` in world space.
  static std::optional<LightImage> of(const scene::Scene& scene, const scene::LightView& light, const glm::dvec3& eye);

  /// What the light's colour is multiplied by on its way to `point` (relative to the eye).
  glm::dvec3 colorTowards(const glm::dvec3& point) const;

 private:
  LightImage() = default;
  glm::dvec3 fetch(glm::dvec2 uv, std::int64_t firstColumn, const Grid& grid) const;

  scene::LightKind kind_ = scene::LightKind::kPoint;
  bool faces_ = false;  ///< of a point light: a strip of six
  glm::dmat3 worldFromLight_{1};
  glm::dvec3 position_{0};          ///< relative to the eye
  double slope_ = 1;                ///< spot: tangent of the outer cone
  glm::dvec2 size_{1};              ///< directional: of a tile, m
  Grid grid_{};                     ///< of the image, or of one face
  std::int64_t columns_ = 0;        ///< of the whole image
  std::vector<glm::dvec3> texels_;  ///< linear
};

}  // namespace tyndall::truth
