#include "draw_list.hpp"

#include <algorithm>
#include <tuple>

#include "base/assert.hpp"
#include "culling.hpp"

namespace tyndall::render {

namespace {

shared::InstanceBlock instanceBlock(const glm::mat4& worldFromObject) {
  shared::InstanceBlock block{};
  block.worldFromObject = worldFromObject;
  const glm::vec3 x(worldFromObject[0]), y(worldFromObject[1]), z(worldFromObject[2]);
  // The cofactor matrix turns normals as the inverse transpose does, up to the determinant: mirroring needs its sign.
  const float sign = glm::dot(glm::cross(x, y), z) < 0 ? -1.0f : 1.0f;
  block.normalX = sign * glm::cross(y, z);
  block.normalY = sign * glm::cross(z, x);
  block.normalZ = sign * glm::cross(x, y);
  block.mirrored = sign < 0 ? 1u : 0u;
  return block;
}

}  // namespace

DrawList buildDrawList(const scene::Scene& scene, const SceneResources& resources,
                       const std::vector<glm::mat4>& worldFromNode, const glm::vec3& eye) {
  TY_ASSERT(worldFromNode.size() == scene.nodes.size() && resources.meshes.size() == scene.meshes.size(),
            "the scene is not the one given to setScene: " + std::to_string(scene.nodes.size()) + " nodes, " +
                std::to_string(worldFromNode.size()) + " matrices, " + std::to_string(resources.meshes.size()) +
                " meshes uploaded");
  DrawList list;
  for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
    if (scene.nodes[n].mesh == scene::kNone) continue;
    for (const DrawRange& range : resources.meshes[static_cast<std::size_t>(scene.nodes[n].mesh)]) {
      if (range.indexCount == 0) continue;
      const MaterialBindings& material = resources.materials[range.material];
      Draw draw;
      draw.range = range;
      draw.instance = static_cast<std::uint32_t>(list.instances.size());
      list.instances.push_back(instanceBlock(worldFromNode[n]));
      draw.facing = material.doubleSided                  ? Facing::kBoth
                    : list.instances.back().mirrored != 0 ? Facing::kFrontMirrored
                                                          : Facing::kFront;
      draw.mask = material.alphaMode == scene::AlphaMode::kMask;
      draw.textures = material.textures;
      draw.casts = scene.nodes[n].castsShadow && material.castsShadow;
      draw.bounds = transformBounds(range.bounds, worldFromNode[n]);
      if (material.alphaMode == scene::AlphaMode::kBlend) {
        draw.distance = glm::distance(eye, 0.5f * (draw.bounds.min + draw.bounds.max));
        list.blended.push_back(draw);
      } else {
        draw.distance = glm::distance(eye, glm::clamp(eye, draw.bounds.min, draw.bounds.max));
        if (draw.casts) list.casters.add(draw.bounds);
        list.solid.push_back(draw);
      }
    }
  }
  const auto key = [](const Draw& d) {
    return std::tuple(d.mask, d.facing, d.textures, d.distance, d.range.material, d.instance);
  };
  std::sort(list.solid.begin(), list.solid.end(), [&](const Draw& a, const Draw& b) { return key(a) < key(b); });
  std::stable_sort(list.blended.begin(), list.blended.end(),
                   [](const Draw& a, const Draw& b) { return a.distance > b.distance; });
  return list;
}

}  // namespace tyndall::render
