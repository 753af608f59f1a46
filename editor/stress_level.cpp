#include "stress_level.hpp"

namespace tyndall::editor {
namespace {

using Random = std::mt19937_64;

float between(Random& random, float low, float high) {
  return std::uniform_real_distribution<float>(low, high)(random);
}
int upTo(Random& random, int most) { return std::uniform_int_distribution<int>(0, most)(random); }

/// A box from `low` to `high`, each face with its own vertices.
scene::Primitive box(glm::vec3 low, glm::vec3 high, std::int32_t material) {
  scene::Primitive primitive;
  primitive.material = material;
  for (int axis = 0; axis < 3; ++axis)
    for (int end = 0; end < 2; ++end) {
      const auto first = static_cast<std::uint32_t>(primitive.vertices.size());
      glm::vec3 normal(0), tangent(0);
      normal[axis] = end ? 1.0f : -1.0f;
      tangent[(axis + 1) % 3] = 1;
      for (int corner = 0; corner < 4; ++corner) {
        scene::Vertex vertex;
        const bool u = corner == 1 || corner == 2, v = corner >= 2;
        vertex.position[axis] = (end ? high : low)[axis];
        vertex.position[(axis + 1) % 3] = (u ? high : low)[(axis + 1) % 3];
        vertex.position[(axis + 2) % 3] = (v ? high : low)[(axis + 2) % 3];
        vertex.normal = normal;
        vertex.tangent = glm::vec4(tangent, 1);
        vertex.uv = {u, v};
        primitive.bounds.add(vertex.position);
        primitive.vertices.push_back(vertex);
      }
      // Counter-clockwise from outside: the other way round on the lower of two faces.
      for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u})
        primitive.indices.push_back(first + (end ? i : (4 - i) % 4));
    }
  return primitive;
}

}  // namespace

app::Level stressLevel(Random& random) {
  scene::Scene scene;
  const auto addBox = [&](glm::vec3 low, glm::vec3 high, scene::AlphaMode mode) {
    scene::Material material;
    material.baseColor = {between(random, 0, 1), between(random, 0, 1), between(random, 0, 1),
                          mode == scene::AlphaMode::kBlend ? 0.4f : 1.0f};
    material.alphaMode = mode;
    scene.materials.push_back(material);
    scene.meshes.push_back({"box", {box(low, high, static_cast<std::int32_t>(scene.materials.size()) - 1)}});
    scene::Node node;
    node.mesh = static_cast<std::int32_t>(scene.meshes.size()) - 1;
    node.order = static_cast<std::uint32_t>(scene.nodes.size());
    scene.nodes.push_back(node);
  };
  addBox({-10, -1, -10}, {10, 0, 10}, scene::AlphaMode::kOpaque);
  for (int i = upTo(random, 3); i >= 0; --i) {
    const glm::vec3 at(between(random, -6, 6), between(random, 0, 3), between(random, -6, 6));
    addBox(at, at + glm::vec3(between(random, 0.2f, 3)),
           upTo(random, 3) == 0 ? scene::AlphaMode::kBlend : scene::AlphaMode::kOpaque);
  }
  if (upTo(random, 1)) {
    scene::AnimationChannel channel;
    channel.node = static_cast<std::int32_t>(scene.nodes.size()) - 1;
    channel.times = {0, 1};
    channel.values = {glm::vec4(0), glm::vec4(1, 1, 0, 0)};
    scene.animations.push_back({"to and fro", 1, {channel}});
  }
  for (int i = upTo(random, 5); i > 0; --i) {
    scene::Light light;
    light.kind = static_cast<scene::LightKind>(upTo(random, 2));
    light.intensity = light.kind == scene::LightKind::kDirectional ? 10.0f : 200.0f;
    if (upTo(random, 1)) light.range = between(random, 2, 20);
    light.outerConeAngle = between(random, 0.2f, 1.2f);
    if (upTo(random, 2) == 0) {
      // 2:1, which a point light's image may be.
      scene.images.push_back({"cookie", 4, 2, std::vector<std::uint8_t>(4 * 2 * 4, 255)});
      for (std::uint8_t& byte : scene.images.back().rgba) byte = static_cast<std::uint8_t>(upTo(random, 255));
      scene.textures.push_back({static_cast<std::int32_t>(scene.images.size()) - 1, {}});
      light.cookie =
          scene::Cookie{static_cast<std::int32_t>(scene.textures.size()) - 1, glm::vec2(between(random, 1, 10))};
    }
    scene.lights.push_back(light);
    scene::Node node;
    node.light = static_cast<std::int32_t>(scene.lights.size()) - 1;
    node.translation = {between(random, -8, 8), between(random, 1, 8), between(random, -8, 8)};
    node.rotation = glm::angleAxis(between(random, -2.8f, -0.3f), glm::vec3(1, 0, 0));
    node.order = static_cast<std::uint32_t>(scene.nodes.size());
    scene.nodes.push_back(node);
  }
  app::Level level;
  level.name = level.path = "a level made up by chance";
  level.scene = std::move(scene);
  return level;
}

}  // namespace tyndall::editor
