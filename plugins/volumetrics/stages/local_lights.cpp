#include "stages/local_lights.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace volumetrics {
namespace {

// An arc cosine near 1 is off by the root of float's rounding.
constexpr float kAngleSlack = 1e-3f;

/// Angle of the smallest texel of a perspective map, `tangent` that of half its opening: in a corner a step of dx at
/// tangent x spans dx / (1 + x^2 + y^2).
float texelAngle(double tangent, double size) {
  return static_cast<float>(2 * tangent / size / (1 + 2 * tangent * tangent));
}

/// How far the light reaches along a unit vector, m: the greatest dot(direction, point) over its range and cone,
/// relative to the eye. Infinite without a range, if it reaches that way at all.
float extentAlong(const LocalBlock& light, const glm::vec3& direction) {
  float best = 1;  // cosine between `direction` and the cone's direction nearest to it
  if (light.kind == kLocalSpot) {
    const float apart = std::acos(std::clamp(glm::dot(direction, light.axis), -1.0f, 1.0f));
    best = std::cos(std::max(0.0f, apart - std::atan2(light.sinOuter, light.cosOuter) - kAngleSlack));
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
  block.coneOuter = block.coneScale = 1;
  if (light.kind == TY_LIGHT_SPOT) {
    block.axis = glm::normalize(glm::make_vec3(light.direction));
    const bool angles = light.struct_size >= offsetof(TyLight, cone_outer) + sizeof light.cone_outer;
    const double outer = angles && light.cone_outer > 0 ? light.cone_outer : std::acos(double{light.cos_outer});
    const double inner = angles && light.cone_outer > 0 ? light.cone_inner : std::acos(double{light.cos_inner});
    block.cosOuter = static_cast<float>(std::max(std::cos(outer), 0.0));
    block.sinOuter = static_cast<float>(std::sin(outer));
    const ConeFalloff cone = coneFalloff(inner, outer);
    block.coneOuter = cone.outer;
    block.coneScale = cone.scale;
  }
  block.shadowSize = static_cast<float>(light.shadow_size);
  // In double: the light may be far from the origin, and depth is curved. All faces have one range of depths.
  const glm::dvec4 position(glm::dvec3(glm::make_vec3(light.position)), 1);
  for (std::uint32_t face = 0; face < std::min(light.face_count, 6u); ++face) {
    const glm::dmat4 rows = glm::transpose(glm::dmat4(glm::make_mat4(light.shadow_clip_from_world[face])));
    const double scale = glm::length(glm::dvec3(rows[3]));
    if (scale == 0) continue;
    block.faceX[face] = glm::vec3(glm::dvec3(rows[0]) / scale);
    block.faceY[face] = glm::vec3(glm::dvec3(rows[1]) / scale);
    if (face > 0) continue;
    block.depthScale = static_cast<float>(glm::dot(glm::dvec3(rows[2]), glm::dvec3(rows[3])) / (scale * scale));
    block.depthOffset = static_cast<float>(-glm::dot(rows[2], position) / scale);
    block.texelAngle = texelAngle(scale / std::max(glm::length(glm::dvec3(rows[0])), 1e-30), light.shadow_size);
  }
  return block;
}

CookieBlock cookieBlock(const TyLight& light, const glm::vec3& eye) {
  CookieBlock block{};
  // A host of before the cookies hands in a shorter struct.
  if (light.struct_size < offsetof(TyLight, cookie_repeats) + sizeof light.cookie_repeats) return block;
  block.faces = light.cookie_faces;
  block.repeats = light.cookie_repeats;
  block.fromEye =
      glm::mat4(glm::dmat4(glm::make_mat4(light.cookie_from_world)) * glm::translate(glm::dmat4(1), glm::dvec3(eye)));
  return block;
}

bool reachesView(const LocalBlock& light, const RayBlock& rays) {
  if (std::max({light.intensity.x, light.intensity.y, light.intensity.z}) <= 0) return false;
  const glm::vec3 right = rays.right / glm::dot(rays.right, rays.right), up = rays.up / glm::dot(rays.up, rays.up);
  // Side planes through the eye, inwards; a light that is nowhere on the inner side of one is out of view. The far
  // plane likewise.
  for (const glm::vec3& inwards : {rays.forward + right, rays.forward - right, rays.forward + up, rays.forward - up})
    if (extentAlong(light, glm::normalize(inwards)) < 0) return false;
  return extentAlong(light, -rays.forward) >= -rays.zfar;
}

double screenShare(const LocalBlock& light, const RayBlock& rays) {
  if (light.range <= 0) return 1;
  const double along = glm::dot(light.position, rays.forward);
  if (along <= light.range) return 1;  // the eye's plane cuts the range's sphere
  // Tangents of the angles from the optical axis to the sphere's borders, in units of the picture's.
  const auto part = [&](const glm::vec3& half) {
    const double size = glm::length(half), across = glm::dot(light.position, half) / size;
    const double apart2 = along * along + across * across - double{light.range} * light.range;
    const double root = light.range * std::sqrt(std::max(apart2, 0.0)),
                 below = along * along - double{light.range} * light.range;
    const double low = std::clamp((along * across - root) / below / size, -1.0, 1.0);
    const double high = std::clamp((along * across + root) / below / size, -1.0, 1.0);
    return (high - low) / 2;
  };
  return std::clamp(part(rays.right) * part(rays.up), 1e-6, 1.0);
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
