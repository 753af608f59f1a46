#include "stages/local_lights.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace volumetrics {
namespace {

// A cone of half a sphere has no side to clip at; what lies beyond 89.99 degrees gets no light worth counting.
constexpr float kLeastCosine = 1e-4f;
// An arc cosine near 1 is off by the root of float's rounding.
constexpr float kAngleSlack = 1e-3f;

/// Angle of the smallest texel of a perspective map: in a corner a step of dx at tangent x spans dx / (1 + x^2 + y^2).
float texelAngle(const glm::dmat4& clip, double size) {
  const auto row = [&](int r) { return glm::dvec3(clip[0][r], clip[1][r], clip[2][r]); };
  const double tangent = glm::length(row(3)) / std::max(glm::length(row(0)), 1e-30);
  return static_cast<float>(2 * tangent / size / (1 + 2 * tangent * tangent));
}

/// How far the light reaches along a unit vector, m: the greatest dot(direction, point) over its range and cone, relative to the eye.
/// Infinite without a range, if it reaches that way at all.
float extentAlong(const LocalBlock& light, const glm::vec3& direction) {
  float best = 1;  // cosine between `direction` and the cone's direction nearest to it
  if (light.kind == kLocalSpot) {
    const float apart = std::acos(std::clamp(glm::dot(direction, light.axis), -1.0f, 1.0f));
    best = std::cos(std::max(0.0f, apart - std::acos(light.cosOuter) - kAngleSlack));
  }
  // What turns away from `direction` is farthest along it at the light itself.
  const float reach = light.range > 0 ? light.range : std::numeric_limits<float>::infinity();
  return glm::dot(light.position, direction) + (best > 0 ? best * reach : 0.0f);
}

}  // namespace

LocalBlock localBlock(const TyLight& light, const glm::vec3& eye) {
  LocalBlock block{};
  block.position = glm::make_vec3(light.position) - eye;
  block.intensity = glm::make_vec3(light.radiance);
  block.range = light.range;
  block.kind = light.kind;
  block.coneOffset = 1;
  if (light.kind == TY_LIGHT_SPOT) {
    block.axis = glm::normalize(glm::make_vec3(light.direction));
    block.cosOuter = std::max(light.cos_outer, kLeastCosine);
    // KHR_lights_punctual, "Inner and Outer Cone Angles": the floor keeps equal angles from dividing by zero.
    block.coneScale = 1 / std::max(0.001f, light.cos_inner - light.cos_outer);
    block.coneOffset = -light.cos_outer * block.coneScale;
  }
  block.shadowSize = static_cast<float>(light.shadow_size);
  // In double: eye and light may be far from the origin, and a shadow texel is small.
  const glm::dmat4 worldFromEye = glm::translate(glm::dmat4(1), glm::dvec3(eye));
  for (std::uint32_t face = 0; face < std::min(light.face_count, 6u); ++face) {
    const glm::dmat4 clip = glm::dmat4(glm::make_mat4(light.shadow_clip_from_world[face])) * worldFromEye;
    block.shadow[face] = glm::mat4(clip);
    if (face == 0) block.texelAngle = texelAngle(clip, light.shadow_size);
  }
  return block;
}

bool reachesView(const LocalBlock& light, const RayBlock& rays) {
  if (std::max({light.intensity.x, light.intensity.y, light.intensity.z}) <= 0) return false;
  const glm::vec3 right = rays.right / glm::dot(rays.right, rays.right), up = rays.up / glm::dot(rays.up, rays.up);
  // Side planes through the eye, inwards; a light that is nowhere on the inner side of one is out of view. The far plane likewise.
  for (const glm::vec3& inwards : {rays.forward + right, rays.forward - right, rays.forward + up, rays.forward - up})
    if (extentAlong(light, glm::normalize(inwards)) < 0) return false;
  return extentAlong(light, -rays.forward) >= -rays.zfar;
}

void prepareLocalLights(const FrameContext& context, std::uint32_t block, const RayBlock& rays) {
  bool any = false;
  for (std::uint32_t i = 0; i < context.frame.light_count; ++i) {
    if (context.frame.lights[i].kind == TY_LIGHT_DIRECTIONAL) continue;
    auto& light = context.block<LocalBlock>(block, i);
    light = localBlock(context.frame.lights[i], rays.eye);
    if (reachesView(light, rays)) {
      any = true;
      continue;
    }
    for (const std::uint32_t pass : context.roles.localPasses) context.skip(pass, i);
  }
  // The only light's pass writes the result itself, or else the clearing pass does.
  if (any && context.roles.standInClear != TY_NONE) context.skip(context.roles.standInClear, 0);
}

}  // namespace volumetrics
