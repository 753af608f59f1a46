// The level in small that pipelines are made ahead with: every kind of drawing is in it, nothing else of the level's
// size.
#include <set>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "stand_in.hpp"

namespace tyndall::render {
namespace {

TEST(StandIn, SidesStayPowersOfTwoOrNot) {
  EXPECT_EQ(smallSide(1), 1u);
  for (const std::uint32_t power : {2u, 4u, 1024u}) EXPECT_EQ(smallSide(power), 2u);
  for (const std::uint32_t other : {3u, 6u, 1000u, 1920u}) EXPECT_EQ(smallSide(other), 3u);
}

TEST(StandIn, HasEachMaterialOnceForEachHandedness) {
  scene::Scene level;
  level.materials.resize(3);
  level.images = {{"bricks", 256, 100, std::vector<std::uint8_t>(256 * 100 * 4)},
                  {"glass", 64, 64, std::vector<std::uint8_t>(64 * 64 * 4, 7)}};
  level.textures = {{0, {}}, {1, {}}};
  level.materials[0].baseColorTexture.texture = 0;
  scene::Primitive many;
  many.vertices.resize(3000);
  many.indices.resize(9000);
  for (const std::vector<std::int32_t>& materials : {std::vector<std::int32_t>{0, 1, 0}, {2, scene::kNone}}) {
    scene::Mesh mesh;
    for (const std::int32_t material : materials) {
      many.material = material;
      mesh.primitives.push_back(many);
    }
    level.meshes.push_back(mesh);
  }
  std::vector<glm::mat4> matrices;
  const auto add = [&](std::int32_t mesh, const glm::vec3& scale) {
    scene::Node node;
    node.mesh = mesh;
    level.nodes.push_back(node);
    matrices.push_back(glm::translate(glm::mat4(1), {100, 0, 0}) * glm::scale(glm::mat4(1), scale));
  };
  add(0, {1, 1, 1}), add(0, {2, 2, 2}), add(1, {1, 1, 1}), add(0, {-1, 1, 1}), add(scene::kNone, {1, 1, 1});
  scene::Light light;
  light.kind = scene::LightKind::kSpot;
  light.cookie = scene::Cookie{1, {}};
  level.lights = {light};
  Renderer::Input frame{level, matrices, {}, {}};
  frame.camera.worldFromView = glm::translate(glm::mat4(1), {5, 6, 7});

  const StandIn small = standInFor(frame);
  ASSERT_EQ(small.scene.nodes.size(), small.worldFromNode.size());
  std::multiset<std::pair<bool, std::int32_t>> kinds;
  for (std::size_t n = 0; n < small.scene.nodes.size(); ++n)
    for (const scene::Primitive& p :
         small.scene.meshes[static_cast<std::size_t>(small.scene.nodes[n].mesh)].primitives) {
      kinds.emplace(glm::determinant(glm::mat3(small.worldFromNode[n])) < 0, p.material);
      EXPECT_EQ(p.indices.size(), 3u);
      // Before the camera, beyond its near plane: culled triangles would compile nothing.
      for (const scene::Vertex& v : p.vertices) {
        const glm::vec3 seen(glm::inverse(frame.camera.worldFromView) * small.worldFromNode[n] *
                             glm::vec4(v.position, 1));
        EXPECT_LT(seen.z, -frame.camera.camera.znear);
        EXPECT_LT(std::max(std::abs(seen.x), std::abs(seen.y)), -0.2f * seen.z);
      }
    }
  EXPECT_EQ(kinds, (std::multiset<std::pair<bool, std::int32_t>>{
                       {false, 0}, {false, 1}, {false, 2}, {false, scene::kNone}, {true, 0}, {true, 1}}));
  EXPECT_EQ(small.scene.materials.size(), level.materials.size());
  EXPECT_EQ(small.scene.images[0].width, 2u);
  EXPECT_EQ(small.scene.images[0].height, 3u);
  EXPECT_EQ(small.scene.images[0].rgba.size(), 24u);
  EXPECT_EQ(small.scene.images[1].rgba, level.images[1].rgba) << "a cookie's";
}

}  // namespace
}  // namespace tyndall::render
