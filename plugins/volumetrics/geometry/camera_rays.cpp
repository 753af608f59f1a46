#include "geometry/camera_rays.hpp"

#include <cmath>

#include <glm/gtc/type_ptr.hpp>

namespace volumetrics {

RayBlock rayBlock(const TyView& view, const Settings& settings) {
  const glm::mat4 worldFromView = glm::make_mat4(view.world_from_view);
  const glm::mat4 clipFromView = glm::make_mat4(view.clip_from_view);
  RayBlock block{};
  block.eye = glm::make_vec3(view.eye);
  block.forward = -glm::vec3(worldFromView[2]);
  block.right = glm::vec3(worldFromView[0]) / std::abs(clipFromView[0][0]);
  block.up = glm::vec3(worldFromView[1]) / std::abs(clipFromView[1][1]);
  block.pixelScale = {2.0f / static_cast<float>(view.width), 2.0f / static_cast<float>(view.height)};
  block.znear = view.znear;
  block.zfar = view.zfar;
  block.frameIndex = static_cast<std::uint32_t>(view.frame_index);
  block.sigma_t = settings.sigma_t;
  block.albedo = settings.albedo;
  block.g = settings.g;
  return block;
}

SunBlock sunBlock(const TyLight& light, const glm::vec3& eye) {
  SunBlock block{};
  block.irradiance = glm::make_vec3(light.radiance);
  block.towards = -glm::normalize(glm::make_vec3(light.direction));
  // In double: eye and map may be far from the origin, and a shadow texel is small.
  const glm::dmat4 clip(glm::make_mat4(light.shadow_clip_from_world[0]));
  const double size = light.shadow_size;
  const auto texels = [&](const glm::dvec4& v) { return glm::vec3(v.x * 0.5 * size, v.y * 0.5 * size, v.z); };
  const glm::dvec4 eyeClip = clip * glm::dvec4(glm::dvec3(eye), 1.0);
  block.shadowEye = glm::vec3((eyeClip.x * 0.5 + 0.5) * size, (eyeClip.y * 0.5 + 0.5) * size, eyeClip.z);
  block.shadowX = texels(clip[0]);
  block.shadowY = texels(clip[1]);
  block.shadowZ = texels(clip[2]);
  block.shadowSize = static_cast<float>(light.shadow_size);
  return block;
}

}  // namespace volumetrics
