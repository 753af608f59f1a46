// Cameras and lights placed in the world, and those that a file without them gets.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "scene/limits.hpp"
#include "scene/scene.hpp"

namespace tyndall::scene {
namespace {

glm::vec3 unitOr(const glm::vec3& v, const glm::vec3& fallback) {
  const glm::dvec3 d(v);
  const double length = std::sqrt(glm::dot(d, d));
  return length > 1e-30 && std::isfinite(length) ? glm::vec3(d / length) : fallback;
}

/// Right-handed, rigid, looking along `forward`; `up` only needs to be roughly up.
glm::mat4 lookFrom(const glm::vec3& eye, const glm::vec3& forward, const glm::vec3& up) {
  const glm::vec3 backward = -forward;
  const glm::vec3 sideways = std::abs(forward.x) < 0.9f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  const glm::vec3 right = unitOr(glm::cross(up, backward), glm::normalize(glm::cross(sideways, backward)));
  return {glm::vec4(right, 0), glm::vec4(glm::cross(backward, right), 0), glm::vec4(backward, 0), glm::vec4(eye, 1)};
}

}  // namespace

std::vector<CameraView> placedCameras(const Scene& scene, double seconds) {
  const std::vector<glm::mat4> worldFromNode = worldMatrices(scene, seconds);
  const std::vector<std::optional<glm::mat3>> turns = worldTurns(scene, seconds);
  std::vector<std::size_t> nodes;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i)
    if (scene.nodes[i].camera != kNone) nodes.push_back(i);
  std::stable_sort(nodes.begin(), nodes.end(),
                   [&](std::size_t a, std::size_t b) { return scene.nodes[a].order < scene.nodes[b].order; });
  std::vector<CameraView> out;
  for (const std::size_t i : nodes) {
    const glm::mat3 turn = turns[i].value_or(glm::mat3(1));
    const Camera& camera = scene.cameras[scene.nodes[i].camera];
    out.push_back({lookFrom(glm::vec3(worldFromNode[i][3]), -turn[2], turn[1]), camera,
                   scene.nodes[i].name.empty() ? camera.name : scene.nodes[i].name});
  }
  return out;
}

float farPlane(const CameraView& view, const Bounds& level) {
  // As much air as a small level's sky has; behind the farthest corner by more than a float's rounding, so that what
  // lies there is not cut; a near plane beyond the level still has something before it.
  constexpr double kLeastFar = 1000, kBehindLevel = 1.001, kLeastDepth = 2;
  // A level is no larger (scene/limits.hpp); what an animation yields may be.
  constexpr double kMostFar = 4.0 * kMaxExtent;
  if (view.camera.zfar) return *view.camera.zfar;
  double farthest = 0;
  if (!level.empty()) {
    const glm::dvec3 eye(view.worldFromView[3]);
    farthest = glm::length(glm::max(glm::abs(glm::dvec3(level.min) - eye), glm::abs(glm::dvec3(level.max) - eye)));
  }
  const double reach = std::min(std::max(kLeastFar, kBehindLevel * farthest), kMostFar);
  return static_cast<float>(std::max(reach, kLeastDepth * double{view.camera.znear}));
}

std::string roundingNote(const CameraView& view) {
  // Shadow maps of ordinary levels resolve some millimetres: coarser steps of the positions are seen.
  constexpr float kSeenStep = 0.005f;
  const glm::vec3 eye = glm::abs(glm::vec3(view.worldFromView[3]));
  const float farthest = std::max({eye.x, eye.y, eye.z});
  const float step = std::nextafter(farthest, std::numeric_limits<float>::max()) - farthest;
  if (step < kSeenStep) return {};
  char text[200];
  std::snprintf(text, sizeof text,
                "camera: it is %.0f km from the origin, where positions are rounded to %.0f mm, which shadows and "
                "surfaces show; a level that is moved nearer to the origin does not",
                farthest / 1e3, step * 1e3);
  return text;
}

CameraView framingCamera(const Bounds& bounds) {
  // 35 degrees off the z axis, 25 above the horizon: three sides of a box show.
  constexpr float kAzimuth = 0.61f, kElevation = 0.44f, kFieldOfView = 0.87f, kMargin = 1.05f;
  const Bounds box = bounds.empty() ? Bounds{glm::vec3(-1), glm::vec3(1)} : bounds;
  const glm::vec3 centre = 0.5f * box.min + 0.5f * box.max;
  const glm::vec3 half = glm::max(0.5f * (box.max - box.min), glm::vec3(1e-3f));
  const glm::vec3 backward(std::sin(kAzimuth) * std::cos(kElevation), std::sin(kElevation),
                           std::cos(kAzimuth) * std::cos(kElevation));
  CameraView view;
  view.worldFromView = lookFrom(glm::vec3(0), -backward, {0, 1, 0});
  // Just far enough for all eight corners, in a picture at least as wide as high.
  const float slope = std::tan(0.5f * kFieldOfView);
  float distance = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 offset = half * glm::vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    const glm::vec3 inView = glm::transpose(glm::mat3(view.worldFromView)) * offset;
    distance = std::max(distance, kMargin * std::max(std::abs(inView.x), std::abs(inView.y)) / slope + inView.z);
  }
  const float diagonal = 2 * glm::length(half);
  view.worldFromView[3] = glm::vec4(centre + distance * backward, 1);
  view.camera = {"frame", kFieldOfView, 1e-3f * diagonal, distance + 3 * diagonal};
  view.name = "frame";
  return view;
}

std::vector<LightView> placedLights(const Scene& scene, double seconds) {
  const std::vector<glm::mat4> worldFromNode = worldMatrices(scene, seconds);
  const std::vector<std::optional<glm::mat3>> turns = worldTurns(scene, seconds);
  std::vector<LightView> out;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (scene.nodes[i].light == kNone) continue;
    const glm::mat3 turn = turns[i].value_or(glm::mat3(1));
    out.push_back({scene.lights[scene.nodes[i].light], glm::vec3(worldFromNode[i][3]), -turn[2],
                   static_cast<std::int32_t>(i), glm::mat3(lookFrom(glm::vec3(0), -turn[2], turn[1]))});
  }
  return out;
}

std::optional<CookieShape> pointCookieShape(const Image& image) {
  if (image.width == 2ull * image.height) return CookieShape::kEquirectangular;
  if (image.width == 6ull * image.height) return CookieShape::kCubeStrip;
  return std::nullopt;
}

LightView defaultSun() {
  // Half from behind what framingCamera sees and 45 degrees high: shafts show best against the light.
  LightView sun;
  sun.light = {"sun", LightKind::kDirectional, glm::vec3(1.0f, 0.95f, 0.88f), 5.0f, {}, 0, 0.7853982f};
  sun.direction = glm::normalize(glm::vec3(0.85f, -1.0f, 0.5f));
  sun.worldFromLight = glm::mat3(lookFrom(glm::vec3(0), sun.direction, {0, 1, 0}));
  return sun;
}

}  // namespace tyndall::scene
