#include "stand_in.hpp"

#include <bit>
#include <map>
#include <set>

namespace tyndall::render {

std::uint32_t smallSide(std::uint32_t texels) { return texels <= 1 ? 1 : std::has_single_bit(texels) ? 2 : 3; }

namespace {

scene::Primitive triangle(std::int32_t material, float distance) {
  scene::Primitive made;
  made.material = material;
  for (const glm::vec2 corner : {glm::vec2(-0.1f, -0.1f), glm::vec2(0.1f, -0.1f), glm::vec2(0.0f, 0.1f)}) {
    scene::Vertex vertex;
    vertex.position = glm::vec3(corner * distance, -distance);
    vertex.normal = glm::vec3(0, 0, 1);
    made.vertices.push_back(vertex);
    made.bounds.add(vertex.position);
  }
  made.indices = {0, 1, 2};
  return made;
}

scene::Image shrunk(const scene::Image& image) {
  scene::Image small{image.name, smallSide(image.width), smallSide(image.height), {}};
  small.rgba.assign(std::size_t{small.width} * small.height * 4, 255);
  return small;
}

}  // namespace

StandIn standInFor(const Renderer::Input& frame) {
  StandIn made;
  made.scene.materials = frame.scene.materials;
  made.scene.textures = frame.scene.textures;
  made.scene.lights = frame.scene.lights;
  std::set<std::int32_t> whole;
  for (const scene::Light& light : frame.scene.lights)
    if (light.cookie && light.cookie->texture != scene::kNone)
      whole.insert(frame.scene.textures[static_cast<std::size_t>(light.cookie->texture)].image);
  for (std::size_t i = 0; i < frame.scene.images.size(); ++i)
    made.scene.images.push_back(whole.contains(static_cast<std::int32_t>(i)) ? frame.scene.images[i]
                                                                             : shrunk(frame.scene.images[i]));

  std::map<bool, std::set<std::int32_t>> kinds;  // by whether the node mirrors
  for (std::size_t n = 0; n < frame.scene.nodes.size(); ++n) {
    const std::int32_t mesh = frame.scene.nodes[n].mesh;
    if (mesh == scene::kNone) continue;
    const bool mirrors = glm::determinant(glm::mat3(frame.worldFromNode[n])) < 0;
    for (const scene::Primitive& p : frame.scene.meshes[static_cast<std::size_t>(mesh)].primitives)
      kinds[mirrors].insert(p.material);
  }
  for (const auto& [mirrors, materials] : kinds) {
    scene::Mesh mesh;
    for (const std::int32_t material : materials)
      mesh.primitives.push_back(triangle(material, 2 * frame.camera.camera.znear));
    scene::Node node;
    node.mesh = static_cast<std::int32_t>(made.scene.meshes.size());
    made.scene.meshes.push_back(std::move(mesh));
    made.scene.nodes.push_back(node);
    made.worldFromNode.push_back(
        frame.camera.worldFromView *
        glm::mat4(glm::mat3(glm::vec3(mirrors ? -1 : 1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1))));
  }
  return made;
}

}  // namespace tyndall::render
