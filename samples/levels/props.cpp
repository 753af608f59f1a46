#include "props.hpp"

#include <glm/gtc/constants.hpp>

#include "random.hpp"
#include "shapes.hpp"

namespace tyndall::levels {
namespace {

constexpr float kTurn = 2.0f * glm::pi<float>();

}  // namespace

std::int32_t crateMesh(LevelBuilder& level, const Coat& boarding, const Coat& edges) {
  MeshBuilder boards, wood;
  const float h = 0.45f, t = 0.05f;
  chamferBox(boards, {-h + t, 0.02f, -h + t}, {h - t, 2 * h - 0.02f, h - t}, 0.0f);
  for (const float a : {-1.0f, 1.0f}) {
    for (const float c : {-1.0f, 1.0f}) {  // the twelve edges
      const float p = a * (h - t), q = c * (h - t);
      chamferBox(wood, {p - t, 0, q - t}, {p + t, 2 * h, q + t}, 0.012f);
      chamferBox(wood, {-h + t, h + q - t, p - t}, {h - t, h + q + t, p + t}, 0.012f);
      chamferBox(wood, {p - t, h + q - t, -h + t}, {p + t, h + q + t, h - t}, 0.012f);
    }
    beam(wood, {-h + t, 0.08f, a * (h - 0.02f)}, {h - t, 2 * h - 0.08f, a * (h - 0.02f)}, 0.04f, 0.12f, 0.01f);
  }
  return level.mesh("crate", {boarding.finish(boards), edges.finish(wood)});
}

std::int32_t barrelMesh(LevelBuilder& level, const Coat& wood, const Coat& hoops) {
  MeshBuilder staves, iron;
  lathe(staves,
        {{0.05f, 0.03f},
         {0.29f, 0.03f},
         {0.29f, 0.03f},
         {0.30f, 0},
         {0.30f, 0},
         {0.345f, 0.2f},
         {0.37f, 0.46f},
         {0.345f, 0.72f},
         {0.30f, 0.92f},
         {0.30f, 0.92f},
         {0.28f, 0.92f},
         {0.28f, 0.92f},
         {0.28f, 0.89f},
         {0.28f, 0.89f},
         {0.01f, 0.89f}},
        20);
  for (const auto& [y, r] :
       {std::pair{0.08f, 0.322f}, std::pair{0.26f, 0.358f}, std::pair{0.63f, 0.362f}, std::pair{0.81f, 0.328f}}) {
    lathe(iron,
          {{r - 0.012f, y},
           {r + 0.004f, y},
           {r + 0.004f, y},
           {r + 0.004f, y + 0.045f},
           {r + 0.004f, y + 0.045f},
           {r - 0.012f, y + 0.045f}},
          20);
  }
  return level.mesh("barrel", {wood.finish(staves), hoops.finish(iron)});
}

std::int32_t rockMesh(LevelBuilder& level, const Coat& coat, std::uint64_t seed) {
  Random random(seed);
  std::vector<glm::vec4> planes;
  for (int i = 0; i < 17; ++i) planes.emplace_back(random.direction(), random.range(0.66f, 1.0f));
  const glm::vec3 stretch{random.range(0.9f, 1.3f), random.range(0.55f, 0.8f), random.range(0.8f, 1.1f)};
  MeshBuilder stone;
  surface(stone, 16, 10, {6, 3}, [&](float u, float v) {
    const float angle = 2.0f * glm::pi<float>() * u,
                tilt = glm::mix(0.012f, glm::pi<float>() - 0.012f, v);  // no pole: it has no normal
    const glm::vec3 d{glm::cos(angle) * glm::sin(tilt), -glm::cos(tilt), -glm::sin(angle) * glm::sin(tilt)};
    float sum = 0;  // smooth minimum: eighth-power mean of the planes' inverse distances
    for (const glm::vec4& plane : planes)
      sum += glm::pow(glm::max(0.0f, glm::dot(d, glm::vec3(plane))) / plane.w, 8.0f);
    return d * glm::pow(sum + 0.2f, -0.125f) * stretch;
  });
  return level.mesh("rock", {coat.finish(stone)});
}

std::vector<glm::vec3> ringPath(float radius, const glm::vec2& centre, int sides, float depth) {
  std::vector<glm::vec3> path;
  for (int i = 0; i < sides; ++i) {
    const float angle = kTurn * real(i) / real(sides);
    path.emplace_back(centre + radius * glm::vec2(glm::cos(angle), glm::sin(angle)), depth);
  }
  return path;
}

void chain(MeshBuilder& b, float length, float link, float wire) {
  constexpr int kArc = 5;  // segments of each half circle
  const float half = 0.5f * link - wire, radius = 0.32f * link;
  std::vector<glm::vec3> oval;
  for (int i = 0; i <= 2 * kArc + 1; ++i) {
    const bool upper = i <= kArc;
    const float angle = glm::pi<float>() * real(upper ? i : i - 1) / real(kArc);
    oval.emplace_back(radius * glm::cos(angle), radius * glm::sin(angle) + (upper ? 1.0f : -1.0f) * (half - radius), 0);
  }
  oval.push_back(oval.front());
  const std::vector<float> radii(oval.size(), wire);
  const float pitch = link - 3.0f * wire;  // the next link hangs in this one's bend
  const glm::mat4 before = b.frame;
  const int count = glm::max(1, static_cast<int>(length / pitch));
  for (int i = 0; i < count; ++i) {
    b.frame = before * placed({0, -length * (real(i) + 0.5f) / real(count), 0}, real(i % 2) * glm::half_pi<float>());
    tube(b, oval, radii, 5);
  }
  b.frame = before;
}

void bentRod(MeshBuilder& b, const glm::vec3& from, const glm::vec3& to, float radius, const glm::vec3& bend,
             int sides) {
  const int pieces = bend == glm::vec3(0) ? 1 : 10;
  std::vector<glm::vec3> path;
  for (int i = 0; i <= pieces; ++i) {
    const float t = real(i) / real(pieces);
    const float give = glm::sin(glm::pi<float>() * t);
    path.push_back(glm::mix(from, to, t) + bend * give * give);
  }
  tube(b, path, std::vector<float>(path.size(), radius), sides, true);
}

void ladder(MeshBuilder& b, float length) {
  for (const float x : {-0.24f, 0.24f}) beam(b, {x, 0, 0}, {x, length, 0}, 0.045f, 0.07f, 0.008f, {0, 0, 1});
  for (float y = 0.3f; y < length - 0.1f; y += 0.3f) tube(b, {{-0.24f, y, 0}, {0.24f, y, 0}}, {0.018f, 0.018f}, 8);
}

}  // namespace tyndall::levels
