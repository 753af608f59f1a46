#include "plants.hpp"

#include <glm/gtc/constants.hpp>

#include "shapes.hpp"

namespace tyndall::levels {

std::int32_t foliage(LevelBuilder& level, const std::string& name, std::int32_t texture, const glm::vec3& tint) {
  return level.cutout(name, texture, tint, 0.9f);  // bent normals would make grazing light glitter on anything smoother
}

void grassTuft(MeshBuilder& b, Random& random, const glm::vec3& at, const glm::vec3& normal, float size,
               const glm::vec2& uvMax) {
  const float turn = random.range(0, glm::pi<float>());
  for (int i = 0; i < 3; ++i) {
    const float angle = turn + glm::pi<float>() * real(i) / 3.0f;
    const glm::vec3 right{glm::cos(angle) * size, 0, glm::sin(angle) * size};
    const glm::vec3 up = glm::vec3(random.range(-0.2f, 0.2f), 1.0f, random.range(-0.2f, 0.2f)) * (0.9f * size);
    card(b, at - 0.04f * normal, right, up, normal, {0.0f, 0.0f}, uvMax);
  }
}

void fern(MeshBuilder& b, Random& random, const glm::vec3& at, float size) {
  const int fronds = 6 + random.below(3);
  const float turn = random.range(0, 6);
  for (int i = 0; i < fronds; ++i) {
    const float angle = turn + 2.0f * glm::pi<float>() * (real(i) + random.range(-0.2f, 0.2f)) / real(fronds);
    const glm::vec3 out{glm::cos(angle), 0, glm::sin(angle)}, right = glm::vec3(-out.z, 0, out.x) * (0.55f * size);
    const glm::vec3 rise = (out * 0.45f + glm::vec3(0, 0.62f, 0)) * (0.55f * size),
                    droop = (out * 0.75f + glm::vec3(0, random.range(-0.2f, 0.1f), 0)) * (0.55f * size);
    card(b, at, right, rise,
         glm::normalize(glm::cross(right, rise) * glm::sign(glm::cross(right, rise).y) + glm::vec3(0, 0.2f, 0)),
         {0.5f, 0.5f}, {1, 1});
    card(b, at + rise, right, droop, glm::normalize(glm::cross(right, droop) * glm::sign(glm::cross(right, droop).y)),
         {0.5f, 0}, {1, 0.5f});
  }
}

std::int32_t bushMesh(LevelBuilder& level, const Coat& bark, std::int32_t leafCards, int seed) {
  MeshBuilder wood, leaves;
  Random random(static_cast<std::uint64_t>(seed));
  for (int i = 0; i < 9; ++i) {
    const glm::vec3 out = glm::normalize(random.direction() * glm::vec3(1, 0.25f, 1) + glm::vec3(0, 0.55f, 0));
    const float length = random.range(0.7f, 1.15f);
    tube(wood, {{0, -0.1f, 0}, out * (0.5f * length), out * length + glm::vec3(0, 0.1f, 0)}, {0.03f, 0.02f, 0.006f}, 4);
    for (int k = 0; k < 7; ++k) {
      const glm::vec3 at = out * (length * random.range(0.35f, 1.0f)) + random.direction() * 0.15f;
      const glm::vec3 up = glm::normalize(out + 0.8f * random.direction() + glm::vec3(0, 0.3f, 0)),
                      right = glm::normalize(glm::cross(up, random.direction()));
      leaves.color = glm::vec4(glm::vec3(random.range(0.7f, 1.05f)), 1);
      const float size = random.range(0.42f, 0.6f);
      card(leaves, at, right * size, up * size, glm::normalize(at + glm::vec3(0, 0.3f, 0)));
    }
  }
  return level.mesh("bush", {bark.finish(wood), leaves.finish(leafCards)});
}

}  // namespace tyndall::levels
