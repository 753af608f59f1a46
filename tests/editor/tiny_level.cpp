#include "tiny_level.hpp"

#include <stdexcept>

#include "scene/write_glb.hpp"

namespace tyndall::editor_test {
namespace {

scene::Primitive box(const glm::vec3& half, std::int32_t material) {
  scene::Primitive made;
  made.material = material;
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-1.0f, 1.0f}) {
      const auto first = static_cast<std::uint32_t>(made.vertices.size());
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (const glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
        scene::Vertex vertex;
        vertex.position[axis] = side * half[axis];
        vertex.position[u] = side * corner.x * half[u], vertex.position[v] = corner.y * half[v];
        vertex.normal = glm::vec3(0), vertex.normal[axis] = side;
        made.vertices.push_back(vertex);
        made.bounds.add(vertex.position);
      }
      for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) made.indices.push_back(first + i);
    }
  return made;
}

}  // namespace

void writeTinyLevel(const std::filesystem::path& file) {
  scene::Scene scene;
  scene.exposure = 1;  // pictures are compared, which must not adapt
  const auto add = [&](const char* name, const glm::vec3& at,
                       const glm::quat& rotation = {1, 0, 0, 0}) -> scene::Node& {
    scene::Node node;
    node.name = name, node.translation = at, node.rotation = rotation;
    node.order = static_cast<std::uint32_t>(scene.nodes.size());
    return scene.nodes.emplace_back(node);
  };
  const auto solid = [&](const char* name, const glm::vec3& half, const glm::vec4& colour, scene::AlphaMode mode,
                         const glm::vec3& at) {
    scene::Material material;
    material.name = name, material.baseColor = colour, material.alphaMode = mode;
    material.metallic = 0, material.roughness = 0.8f;
    scene.materials.push_back(material);
    scene.meshes.push_back({name, {box(half, static_cast<std::int32_t>(scene.materials.size()) - 1)}});
    add(name, at).mesh = static_cast<std::int32_t>(scene.meshes.size()) - 1;
  };
  using scene::AlphaMode;
  solid("floor", {6, 0.1f, 6}, {0.5f, 0.5f, 0.5f, 1}, AlphaMode::kOpaque, {0, -0.1f, 0});
  solid("box", {0.6f, 0.6f, 0.6f}, {0.1f, 0.5f, 0.3f, 1}, AlphaMode::kOpaque, {0, 0.6f, 0});
  solid("glass", {0.5f, 0.8f, 0.05f}, {0.2f, 0.3f, 0.9f, 0.4f}, AlphaMode::kBlend, {-1.8f, 0.9f, 0.5f});
  const auto light = [&](const char* name, scene::LightKind kind, float intensity, const glm::vec3& at,
                         const glm::quat& rotation) {
    scene::Light made;
    made.name = name, made.kind = kind, made.intensity = intensity;
    made.innerConeAngle = 0.3f, made.outerConeAngle = 0.5f;
    scene.lights.push_back(made);
    add(name, at, rotation).light = static_cast<std::int32_t>(scene.lights.size()) - 1;
  };
  const auto about = [](float degrees, const glm::vec3& axis) { return glm::angleAxis(glm::radians(degrees), axis); };
  // The spot looks down and a little away from the first camera.
  light("lamp", scene::LightKind::kSpot, 60, {1.2f, 2.6f, 0}, about(-75, {1, 0, 0}));
  light("sun", scene::LightKind::kDirectional, 2, {0, 5, 0}, about(35, {0, 1, 0}) * about(-50, {1, 0, 0}));
  const auto camera = [&](const char* name, const glm::vec3& at, const glm::quat& rotation) {
    scene::Camera made;
    made.name = name, made.yfov = 0.9f;
    scene.cameras.push_back(made);
    add(name, at, rotation).camera = static_cast<std::int32_t>(scene.cameras.size()) - 1;
  };
  camera("front", {0, 1.5f, 6}, {1, 0, 0, 0});
  camera("side", {6, 1.5f, 0}, about(90, {0, 1, 0}));
  if (const auto written = scene::writeGlb(scene, file); !written) throw std::runtime_error(written.error().message);
}

}  // namespace tyndall::editor_test
