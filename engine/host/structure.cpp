#include "structure.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace tyndall::host {
namespace {

void copyMatrix(float (&to)[16], const glm::mat4& from) {
  std::memcpy(to, &from[0][0], sizeof to);
}  // both column-major
void copyVector(float (&to)[3], const glm::vec3& from) { std::memcpy(to, &from[0], sizeof to); }

}  // namespace

TyStructure Structure::abi() const {
  TyStructure s{};
  s.struct_size = sizeof s;
  s.width = width;
  s.height = height;
  s.light_count = static_cast<std::uint32_t>(lightKinds.size());
  s.light_kinds = lightKinds.data();
  s.shadow_sizes = shadowSizes.data();
  s.values = values.data();
  s.value_count = static_cast<std::uint32_t>(values.size());
  s.shadow_moments_format = shadowMoments;
  static constexpr std::uint32_t kNoLight = 0;  // null would say that the renderer offers none
  if (cookies) s.light_cookies = lightCookies.empty() ? &kNoLight : lightCookies.data();
  return s;
}

bool Structure::sameSurroundings(const Structure& other) const {
  return width == other.width && height == other.height && lightKinds == other.lightKinds &&
         shadowSizes == other.shadowSizes && shadowMoments == other.shadowMoments &&
         lightCookies == other.lightCookies && cookies == other.cookies;
}

bool Structure::sameLayout(const Structure& other) const {
  if (!sameSurroundings(other) || values.size() != other.values.size()) return false;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (structural[i] && values[i] != other.values[i]) return false;
  return true;
}

namespace {

/// All lights' maps are of one kind; if one had none, a pass that reads them could not run for it.
std::uint32_t shadowMomentsOf(const render::EffectInput& input) {
  std::uint32_t format = TY_FORMAT_UNKNOWN;
  for (const render::ShadowedLight& light : input.lights) {
    if (!light.moments) return TY_FORMAT_UNKNOWN;
    format = input.graph.desc(light.moments).format == VK_FORMAT_R16G16B16A16_UNORM ? TY_FORMAT_RGBA16_UNORM
                                                                                    : TY_FORMAT_RGBA32_FLOAT;
  }
  return format;
}

}  // namespace

Structure makeStructure(const render::EffectInput& input, const std::vector<params::Parameter>& parameters,
                        const params::Table& table) {
  Structure s;
  s.width = input.view.width;
  s.height = input.view.height;
  for (const render::ShadowedLight& light : input.lights) {
    s.lightKinds.push_back(lightKind(light.light.light.kind));
    s.shadowSizes.push_back(light.size);
    s.lightCookies.push_back(light.cookieFaces);
  }
  s.cookies = std::all_of(input.lights.begin(), input.lights.end(),
                          [](const render::ShadowedLight& light) { return static_cast<bool>(light.cookie); });
  s.shadowMoments = shadowMomentsOf(input);
  for (const params::Parameter& p : parameters) {
    s.values.push_back(table.value(p.id));
    s.structural.push_back(p.structural);
  }
  return s;
}

TyDevice makeDevice(const gpu::DeviceInfo& info) {
  TyDevice d{};
  d.struct_size = sizeof d;
  d.is_cpu = info.isCpu ? 1 : 0;
  d.name = info.name.c_str();
  d.subgroup_size = info.subgroupSize;
  d.max_image_2d = info.limits.maxImageDimension2D;
  d.max_image_layers = info.limits.maxImageArrayLayers;
  d.max_shared_memory = info.limits.maxComputeSharedMemorySize;
  d.max_workgroup_invocations = info.limits.maxComputeWorkGroupInvocations;
  d.max_push_descriptors = info.maxPushDescriptors;
  d.max_storage_buffer = info.limits.maxStorageBufferRange;
  return d;
}

LayoutLimits makeLimits(const gpu::DeviceInfo& info) {
  LayoutLimits l;
  l.image2d = info.limits.maxImageDimension2D;
  l.image3d = info.limits.maxImageDimension3D;
  l.layers = info.limits.maxImageArrayLayers;
  // gpu::Descriptors holds 32, whatever the device takes.
  l.pushDescriptors = std::min(32u, info.maxPushDescriptors);
  l.colorTargets = info.limits.maxColorAttachments;
  for (std::size_t axis = 0; axis < 3; ++axis) l.groups[axis] = info.limits.maxComputeWorkGroupCount[axis];
  l.storageBuffer = info.limits.maxStorageBufferRange;
  return l;
}

TyView makeView(const render::View& view) {
  TyView v{};
  v.struct_size = sizeof v;
  v.width = view.width;
  v.height = view.height;
  copyMatrix(v.view_from_world, view.viewFromWorld);
  copyMatrix(v.world_from_view, view.worldFromView);
  copyMatrix(v.clip_from_view, view.clipFromView);
  copyMatrix(v.view_from_clip, view.viewFromClip);
  copyVector(v.eye, view.eye);
  v.znear = view.znear;
  v.zfar = view.zfar;
  v.seconds = view.seconds;
  v.frame_index = view.frameIndex;
  return v;
}

TyLight makeLight(const render::ShadowedLight& shadowed) {
  const scene::Light& light = shadowed.light.light;
  TyLight l{};
  l.struct_size = sizeof l;
  l.kind = lightKind(light.kind);
  copyVector(l.position, shadowed.light.position);
  copyVector(l.direction, shadowed.light.direction);
  copyVector(l.radiance, light.color * light.intensity);
  l.range = light.range.value_or(0.0f);
  l.cos_inner = std::cos(light.innerConeAngle);
  l.cos_outer = std::cos(light.outerConeAngle);
  l.face_count = shadowed.faceCount;
  l.shadow_size = shadowed.size;
  for (std::size_t i = 0; i < 6; ++i) copyMatrix(l.shadow_clip_from_world[i], shadowed.clipFromWorld[i]);
  for (std::size_t i = 0; i < 8; ++i) copyVector(l.caster_corners[i], shadowed.casterCorners[i]);
  copyMatrix(l.cookie_from_world, shadowed.cookieFromWorld);
  l.cookie_faces = shadowed.cookieFaces;
  l.cookie_repeats = shadowed.cookieRepeats;
  l.cone_inner = light.innerConeAngle;
  l.cone_outer = light.outerConeAngle;
  return l;
}

std::uint32_t lightKind(scene::LightKind kind) {
  switch (kind) {
    case scene::LightKind::kDirectional: return TY_LIGHT_DIRECTIONAL;
    case scene::LightKind::kSpot: return TY_LIGHT_SPOT;
    case scene::LightKind::kPoint: return TY_LIGHT_POINT;
  }
  return TY_LIGHT_DIRECTIONAL;
}

}  // namespace tyndall::host
