// Small levels built in memory for the frame's tests.
#pragma once

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "scene/scene.hpp"

namespace tyndall::render::test {

inline float linearFromSrgb(int code) {
  const double c = code / 255.0;
  return static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
}

/// A level that grows quad by quad.
struct Level {
  scene::Scene scene;

  std::int32_t material(const scene::Material& m) {
    scene.materials.push_back(m);
    return static_cast<std::int32_t>(scene.materials.size()) - 1;
  }
  /// A rough dielectric of the given grey, as an sRGB code, so that the 8-bit G-buffer holds it exactly.
  static scene::Material grey(int code) {
    scene::Material m;
    m.baseColor = glm::vec4(glm::vec3(linearFromSrgb(code)), 1);
    m.metallic = 0;
    m.roughness = 1;
    return m;
  }
  /// A parallelogram center +- u +- v; its front faces along cross(u, v). uv (0,0) at -u+v, (1,1) at +u-v (row 0 on
  /// top).
  scene::Node& quad(const glm::vec3& center, const glm::vec3& u, const glm::vec3& v, std::int32_t materialIndex) {
    scene::Primitive p;
    p.material = materialIndex;
    const glm::vec3 n = glm::normalize(glm::cross(u, v));
    for (const glm::vec2 s : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
      scene::Vertex vertex;
      vertex.position = center + s.x * u + s.y * v;
      vertex.normal = n;
      vertex.tangent = glm::vec4(glm::normalize(u), 1);
      vertex.uv = {0.5f + 0.5f * s.x, 0.5f - 0.5f * s.y};
      p.bounds.add(vertex.position);
      p.vertices.push_back(vertex);
    }
    p.indices = {0, 1, 2, 0, 2, 3};
    scene.meshes.push_back({"quad", {p}});
    scene::Node node;
    node.mesh = static_cast<std::int32_t>(scene.meshes.size()) - 1;
    scene.nodes.push_back(node);
    return scene.nodes.back();
  }
};

inline scene::CameraView lookAt(const glm::vec3& eye, const glm::vec3& target, float yfov = 0.8f, float zfar = 100) {
  const glm::vec3 forward = glm::normalize(target - eye);
  const glm::vec3 up = std::abs(forward.y) > 0.99f ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);
  scene::CameraView camera;
  camera.worldFromView = glm::inverse(glm::lookAt(eye, target, up));
  camera.camera.yfov = yfov;
  camera.camera.zfar = zfar;
  return camera;
}

inline scene::LightView sun(const glm::vec3& direction, float lux) {
  scene::LightView light;
  light.light.intensity = lux;
  light.direction = glm::normalize(direction);
  return light;
}

inline scene::LightView pointLight(const glm::vec3& position, float candela) {
  scene::LightView light;
  light.light.kind = scene::LightKind::kPoint;
  light.light.intensity = candela;
  light.position = position;
  return light;
}

inline scene::LightView spotLight(const glm::vec3& position, const glm::vec3& target, float candela, float outer) {
  scene::LightView light = pointLight(position, candela);
  light.light.kind = scene::LightKind::kSpot;
  light.light.innerConeAngle = 0.5f * outer;
  light.light.outerConeAngle = outer;
  light.direction = glm::normalize(target - position);
  return light;
}

}  // namespace tyndall::render::test
