// Brute-force rays against a level, independent of everything that renders.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "scene/scene.hpp"

namespace tyndall::levels {

struct Triangle {
  glm::vec3 corner, edge1, edge2;
};

/// World-space triangles at `seconds` of the nodes that `wanted` accepts (all if it is empty). Surfaces that are
/// blended are left out: they neither shadow nor end rays. Cut-outs count as if they were whole.
std::vector<Triangle> trianglesOf(const scene::Scene& scene, double seconds = 0,
                                  const std::function<bool(const scene::Node&)>& wanted = {});

/// Distance to the nearest triangle in front of `origin`, from either side (Möller and Trumbore 1997).
std::optional<float> nearest(const std::vector<Triangle>& triangles, const glm::vec3& origin,
                             const glm::vec3& direction);
/// Is there any triangle in front?
bool blocked(const std::vector<Triangle>& triangles, const glm::vec3& origin, const glm::vec3& direction);

/// Numbers for the tests: splitmix64 (Steele, Lea and Flood 2014).
class TestRandom {
 public:
  explicit TestRandom(std::uint64_t seed) : state_(seed) {}
  float range(float low, float high) { return low + (high - low) * static_cast<float>(next() >> 40) * 0x1p-24f; }
  glm::vec3 inside(const glm::vec3& min, const glm::vec3& max) {
    const float x = range(min.x, max.x), y = range(min.y, max.y);
    return {x, y, range(min.z, max.z)};
  }
  glm::vec3 direction() {
    for (;;) {
      const glm::vec3 p = inside(glm::vec3(-1), glm::vec3(1));
      const float length = glm::length(p);
      if (length > 0.1f && length < 1.0f) return p / length;
    }
  }

 private:
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15ull;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

}  // namespace tyndall::levels
