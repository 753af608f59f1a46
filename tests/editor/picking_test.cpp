// Picking: the node that a ray meets first, whatever moves, turns, scales and mirrors it.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "picking.hpp"

namespace tyndall::editor {
namespace {

/// A square of side 2 in the plane z = 0, facing +z.
scene::Mesh square() {
  scene::Primitive primitive;
  for (const glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
    scene::Vertex vertex;
    vertex.position = glm::vec3(corner, 0);
    primitive.bounds.add(vertex.position);
    primitive.vertices.push_back(vertex);
  }
  primitive.indices = {0, 1, 2, 0, 2, 3};
  return {"square", {primitive}};
}

class Picking : public testing::Test {
 protected:
  Picking() { scene_.meshes.push_back(square()); }
  int add(const glm::mat4& world, std::int32_t parent = scene::kNone) {
    scene::Node node;
    node.matrix = world, node.mesh = 0, node.parent = parent;
    scene_.nodes.push_back(node);
    return static_cast<int>(scene_.nodes.size()) - 1;
  }
  std::optional<int> hit(const glm::vec3& from, const glm::vec3& along) const {
    return nodeUnder(scene_, scene::worldMatrices(scene_, 0), from, along);
  }
  scene::Scene scene_;
};

glm::mat4 at(float x, float y, float z) { return glm::translate(glm::mat4(1), glm::vec3(x, y, z)); }

TEST_F(Picking, TheNearerOfTwoIsMetHoweverItIsScaled) {
  const int far = add(at(0, 0, -10) * glm::scale(glm::mat4(1), glm::vec3(100)));
  const int near = add(at(0, 0, -2) * glm::scale(glm::mat4(1), glm::vec3(0.5f, 0.5f, 40)));
  EXPECT_EQ(hit({0, 0, 0}, {0, 0, -1}), near);
  EXPECT_EQ(hit({0, 0, 0}, {0, 0, -7}), near) << "the length of the direction is of no account";
  EXPECT_EQ(hit({0.6f, 0, 0}, {0, 0, -1}), far);
  EXPECT_EQ(hit({0, 0, 0}, {0, 0, 1}), std::nullopt) << "both lie behind";
  EXPECT_EQ(hit({0, 0, -5}, {0, 0, -1}), far);
}

TEST_F(Picking, BothSidesCountAndParentsMoveTheirChildren) {
  const int parent = add(at(5, 0, 0) * glm::rotate(glm::mat4(1), glm::radians(90.0f), glm::vec3(0, 1, 0)));
  const int child = add(at(0, 3, 0) * glm::scale(glm::mat4(1), glm::vec3(-1, 1, 1)), parent);
  EXPECT_EQ(hit({0, 0.5f, 0.5f}, {1, 0, 0}), parent);
  EXPECT_EQ(hit({9, 0.5f, 0.5f}, {-1, 0, 0}), parent);
  EXPECT_EQ(hit({0, 3.5f, 0.5f}, {1, 0, 0}), child);
  EXPECT_EQ(hit({0, 1.5f, 0}, {1, 0, 0}), std::nullopt) << "between the two";
  EXPECT_EQ(hit({5, 0, 5}, {0, 0, -1}), std::nullopt) << "along the plane";
}

TEST_F(Picking, WhatIsScaledToNothingIsNotMet) {
  add(at(0, 0, -1) * glm::scale(glm::mat4(1), glm::vec3(0)));
  EXPECT_EQ(hit({0, 0, 0}, {0, 0, -1}), std::nullopt);
}

}  // namespace
}  // namespace tyndall::editor
