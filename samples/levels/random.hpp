// PCG32 (O'Neill 2014, "PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms for Random Number
// Generation"): the standard library's distributions may differ between implementations, this does not.
#pragma once

#include <cstdint>

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

namespace tyndall::levels {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed + kIncrement) { bits(); }

  std::uint32_t bits() {
    const std::uint64_t old = state_;
    state_ = old * 6364136223846793005ull + kIncrement;
    const auto mixed = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
    const auto turn = static_cast<std::uint32_t>(old >> 59);
    return (mixed >> turn) | (mixed << ((32u - turn) & 31u));
  }
  /// [0, 1)
  float unit() { return static_cast<float>(bits() >> 8) * 0x1p-24f; }
  float range(float low, float high) { return low + (high - low) * unit(); }
  /// 0..count-1
  int below(int count) { return static_cast<int>(bits() % static_cast<std::uint32_t>(count)); }
  /// Uniform on the sphere.
  glm::vec3 direction() {
    const float y = range(-1.0f, 1.0f), angle = range(0.0f, 2.0f * glm::pi<float>());
    const float r = glm::sqrt(glm::max(0.0f, 1.0f - y * y));
    return {r * glm::cos(angle), y, r * glm::sin(angle)};
  }

 private:
  static constexpr std::uint64_t kIncrement = 1442695040888963407ull;
  std::uint64_t state_;
};

}  // namespace tyndall::levels
