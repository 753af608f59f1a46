#include "cookie.hpp"

#include <numbers>

namespace tyndall::truth {
namespace {

double decoded(std::uint8_t code) {  // IEC 61966-2-1
  const double c = code / 255.0;
  return c > 0.04045 ? std::pow((c + 0.055) / 1.055, 2.4) : c / 12.92;
}

}  // namespace

std::optional<LightImage> LightImage::of(const scene::Scene& scene, const scene::LightView& light,
                                         const glm::dvec3& eye) {
  if (!light.light.cookie) return std::nullopt;
  const scene::Cookie& cookie = *light.light.cookie;
  const scene::Texture& texture = scene.textures[static_cast<std::size_t>(cookie.texture)];
  const scene::Image& image = scene.images[static_cast<std::size_t>(texture.image)];
  LightImage out;
  out.kind_ = light.light.kind;
  out.worldFromLight_ = glm::dmat3(light.worldFromLight);
  out.position_ = glm::dvec3(light.position) - eye;
  out.slope_ = std::tan(double{std::min(light.light.outerConeAngle, scene::kMaxCookieAngle)});
  out.size_ = glm::dvec2(cookie.size);
  out.columns_ = image.width;
  out.grid_ = {image.width, image.height, scene::Wrap::kClampToEdge, scene::Wrap::kClampToEdge};
  if (out.kind_ == scene::LightKind::kDirectional) {
    out.grid_.wrapU = texture.sampler.wrapU;
    out.grid_.wrapV = texture.sampler.wrapV;
  }
  if (out.kind_ == scene::LightKind::kPoint) {
    out.faces_ = scene::pointCookieShape(image) == scene::CookieShape::kCubeStrip;
    if (out.faces_)
      out.grid_.width = image.height;
    else
      out.grid_.wrapU = scene::Wrap::kRepeat;  // once around
  }
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    out.texels_.emplace_back(decoded(image.rgba[i]), decoded(image.rgba[i + 1]), decoded(image.rgba[i + 2]));
  return out;
}

glm::dvec3 LightImage::fetch(glm::dvec2 uv, std::int64_t firstColumn, const Grid& grid) const {
  return bilinear(grid, uv, [&](std::int64_t column, std::int64_t row) {
    return texels_[static_cast<std::size_t>(row * columns_ + firstColumn + column)];
  });
}

glm::dvec3 LightImage::colorTowards(const glm::dvec3& point) const {
  const glm::dvec3 offset = point - position_;
  const double x = glm::dot(worldFromLight_[0], offset), y = glm::dot(worldFromLight_[1], offset),
               z = glm::dot(worldFromLight_[2], offset);
  if (kind_ == scene::LightKind::kDirectional) return fetch({0.5 + x / size_.x, 0.5 - y / size_.y}, 0, grid_);
  if (kind_ == scene::LightKind::kSpot) {
    if (z >= 0) return glm::dvec3(0);
    const double half = -z * slope_;  // of the image's side there
    return fetch({0.5 + 0.5 * x / half, 0.5 - 0.5 * y / half}, 0, grid_);
  }
  if (!faces_) {
    const double r = std::sqrt(x * x + y * y + z * z);
    if (r == 0) return glm::dvec3(0);
    return fetch(
        {0.5 + std::atan2(x, -z) / (2 * std::numbers::pi), std::acos(std::clamp(y / r, -1.0, 1.0)) / std::numbers::pi},
        0, grid_);
  }
  // The face that the vector points at, and where: the columns of Vulkan's table for s, t and the major axis.
  static const struct {
    glm::dvec3 s, t, axis;
  } kFaces[] = {{{0, 0, -1}, {0, -1, 0}, {1, 0, 0}}, {{0, 0, 1}, {0, -1, 0}, {-1, 0, 0}},
                {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}},   {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
                {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}},  {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
  const glm::dvec3 d(x, y, z);
  std::int64_t face = 0;
  for (std::int64_t i = 1; i < 6; ++i)
    if (glm::dot(kFaces[i].axis, d) > glm::dot(kFaces[face].axis, d)) face = i;
  const double major = glm::dot(kFaces[face].axis, d);
  if (major <= 0) return glm::dvec3(0);  // the light itself
  const glm::dvec2 place(glm::dot(kFaces[face].s, d) / major, glm::dot(kFaces[face].t, d) / major);
  return fetch(0.5 + 0.5 * place, face * grid_.width, grid_);
}

}  // namespace tyndall::truth
