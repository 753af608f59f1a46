// Trees: a trunk and branches of tapering tubes, and cards of leaves on them.
#include "trees.hpp"

#include <glm/gtc/constants.hpp>

#include "random.hpp"
#include "shapes.hpp"

namespace tyndall::levels {
namespace {

constexpr float kGolden = 2.39996323f;  // the golden angle: neighbours never stand above each other

struct Parts {
  MeshBuilder wood, leaves;
};

std::vector<glm::vec3> wander(Random& random, const glm::vec3& from, const glm::vec3& by, float sideways, float rise,
                              int points) {
  std::vector<glm::vec3> path{from};
  const glm::vec3 off = random.direction() * sideways, off2 = random.direction() * (0.5f * sideways);
  for (int i = 1; i < points; ++i) {
    const float s = real(i) / real(points - 1);
    path.push_back(from + by * s + off * glm::sin(3.1f * s) + off2 * glm::sin(6.3f * s) +
                   glm::vec3(0, rise * s * s, 0));
  }
  return path;
}

std::vector<float> taper(float from, float to, std::size_t count) {
  std::vector<float> radii;
  for (std::size_t i = 0; i < count; ++i)
    radii.push_back(glm::mix(from, to, static_cast<float>(i) / static_cast<float>(count - 1)));
  return radii;
}

glm::vec3 along(const std::vector<glm::vec3>& path, float s) {
  const float at = s * static_cast<float>(path.size() - 1);
  const auto i = glm::min(static_cast<std::size_t>(at), path.size() - 2);
  return glm::mix(path[i], path[i + 1], at - static_cast<float>(i));
}

void leafCard(Parts& parts, Random& random, const glm::vec3& at, const glm::vec3& outward, const glm::vec3& crownMiddle,
              const TreeKind& kind) {
  const float size = kind.cardSize * random.range(0.8f, 1.2f);
  const glm::vec3 up = glm::normalize(outward + 0.75f * random.direction() - glm::vec3(0, kind.droop, 0));
  const glm::vec3 right = glm::normalize(glm::cross(up, random.direction() + glm::vec3(0.001f, 0, 0)));
  const glm::vec3 middle = at + 0.5f * size * up;
  // Shaded like the crown's surface, darker inside: hundreds of cards then read as one body of leaves.
  const float deep =
      glm::clamp(glm::length((middle - crownMiddle) /
                             glm::vec3(kind.crownRadius, 0.5f * kind.height * (1 - kind.crownFrom), kind.crownRadius)),
                 0.0f, 1.0f);
  parts.leaves.color = glm::vec4(glm::vec3((0.55f + 0.5f * deep) * random.range(0.85f, 1.1f)), 1);
  card(parts.leaves, at, right * size, up * size,
       glm::normalize(glm::normalize(middle - crownMiddle) + 0.3f * random.direction()));
}

void trunk(Parts& parts, const std::vector<glm::vec3>& path, const TreeKind& kind) {
  std::vector<float> radii = taper(kind.trunk, 0.03f, path.size());
  radii[0] = 1.7f * kind.trunk;  // the roots' flare
  radii[1] = 1.05f * kind.trunk;
  tube(parts.wood, path, radii, kind.trunkSides);
}

/// Broad-leaved: a crown like an egg.
Parts broadParts(const TreeKind& kind, std::uint64_t seed) {
  Parts parts;
  Random random(seed);
  std::vector<glm::vec3> stem = wander(random, {0, 0, 0}, {0, kind.height * 0.94f, 0}, 0.035f * kind.height, 0, 10);
  stem.insert(stem.begin(), {0, -0.5f, 0});
  stem[1] = {0, 0.55f, 0};
  trunk(parts, stem, kind);
  const glm::vec3 crownMiddle{0, kind.height * (0.5f + 0.42f * kind.crownFrom), 0};
  for (int i = 0; i < kind.branches; ++i) {
    const float up = (real(i) + 0.5f) / real(kind.branches);  // 0 lowest, 1 highest branch
    const float profile = glm::sqrt(glm::max(0.05f, 1.0f - glm::pow(1.55f * (up - 0.36f), 2.0f)));
    const float azimuth = kGolden * real(i) + random.range(-0.35f, 0.35f),
                length = kind.crownRadius * profile * random.range(0.8f, 1.1f);
    const float climb = glm::mix(0.25f, 1.25f, up);
    const float at = glm::mix(kind.crownFrom, 0.97f, glm::pow(up, 0.9f));
    const glm::vec3 out = glm::normalize(glm::vec3(glm::cos(azimuth), climb, glm::sin(azimuth)));
    const std::vector<glm::vec3> branch =
        wander(random, along(stem, at), out * length, 0.09f * length, 0.12f * length, 5);
    const float thick = glm::mix(0.42f, 0.5f, up) * glm::mix(kind.trunk, 0.03f, at);
    tube(parts.wood, branch, taper(thick, 0.012f, branch.size()), 5);
    for (int k = 0; k < kind.twigs; ++k) {
      const float s = 0.3f + 0.7f * (real(k) + 0.7f) / real(kind.twigs);
      const glm::vec3 root = along(branch, glm::min(s, 1.0f));
      const glm::vec3 way =
          glm::normalize(out * 0.55f + random.direction() * glm::vec3(1, 0.6f, 1) + glm::vec3(0, 0.1f, 0));
      const float reach = (0.30f + 0.12f * random.unit()) * length * (1.15f - 0.5f * s);
      const std::vector<glm::vec3> twig = {root, root + way * reach};
      if (kind.twigWood) tube(parts.wood, twig, taper(0.28f * thick, 0.006f, twig.size()), 3);
      for (int c = 0; c < kind.cards; ++c)
        leafCard(parts, random, along(twig, random.range(0.25f, 1.0f)), way, crownMiddle, kind);
    }
    for (int c = 0; c < kind.cards; ++c)
      leafCard(parts, random, along(branch, random.range(0.75f, 1.0f)), out, crownMiddle, kind);
  }
  return parts;
}

/// A spruce: whorls of hanging fronds, each bent once, with a second card across so that it has body from every side.
Parts spruceParts(const TreeKind& kind, std::uint64_t seed) {
  Parts parts;
  Random random(seed);
  std::vector<glm::vec3> stem = wander(random, {0, 0, 0}, {0, kind.height, 0}, 0.008f * kind.height, 0, 7);
  stem.insert(stem.begin(), {0, -0.5f, 0});
  stem[1] = {0, 0.5f, 0};
  trunk(parts, stem, kind);
  int count = 0;
  for (int whorl = 0; whorl < kind.branches; ++whorl) {
    const float up = (real(whorl) + 0.3f) / real(kind.branches), at = glm::mix(kind.crownFrom, 0.985f, up);
    for (int k = 0; k < kind.twigs; ++k) {
      const float azimuth = kGolden * real(count++) + random.range(-0.3f, 0.3f);
      const float length = (kind.crownRadius * glm::pow(1.0f - up, 0.85f) + 0.25f) * random.range(0.8f, 1.1f),
                  width = 0.62f * length + 0.12f;
      const glm::vec3 out{glm::cos(azimuth), 0, glm::sin(azimuth)}, right{-out.z, 0, out.x};
      const glm::vec3 root = along(stem, at) + glm::vec3(0, random.range(-0.15f, 0.15f), 0);
      const float hang = glm::mix(-0.35f, 0.45f, up);
      const glm::vec3 first = glm::normalize(out + glm::vec3(0, hang + 0.1f, 0)) * (0.5f * length);
      const glm::vec3 second = glm::normalize(out + glm::vec3(0, hang - kind.droop, 0)) * (0.5f * length);
      parts.leaves.color = glm::vec4(glm::vec3(random.range(0.75f, 1.1f)), 1);
      const glm::vec3 normal = glm::normalize(out * 0.6f + glm::vec3(0, 0.8f, 0));
      card(parts.leaves, root, right * width, first, normal, {0, 0.5f}, {1, 1});
      card(parts.leaves, root + first, right * width, second, normal, {0, 0}, {1, 0.5f});
      const glm::vec3 across = glm::normalize(glm::cross(right, first)) * (0.5f * width) + 0.3f * width * right;
      card(parts.leaves, root, across, first, glm::normalize(out + right), {0, 0.5f}, {1, 1});
      card(parts.leaves, root + first, across, second, glm::normalize(out + right), {0, 0}, {1, 0.5f});
    }
  }
  return parts;
}

std::int32_t meshOf(LevelBuilder& level, const std::string& name, const Parts& parts, const Coat& bark,
                    std::int32_t leaves) {
  return level.mesh(name, {bark.finish(parts.wood), parts.leaves.finish(leaves)});
}

}  // namespace

std::int32_t broadTree(LevelBuilder& level, const std::string& name, const TreeKind& kind, std::uint64_t seed,
                       const Coat& bark, std::int32_t leaves) {
  return meshOf(level, name, broadParts(kind, seed), bark, leaves);
}

std::int32_t spruceTree(LevelBuilder& level, const std::string& name, const TreeKind& kind, std::uint64_t seed,
                        const Coat& bark, std::int32_t needles) {
  return meshOf(level, name, spruceParts(kind, seed), bark, needles);
}

}  // namespace tyndall::levels
