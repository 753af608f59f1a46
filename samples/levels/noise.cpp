#include "noise.hpp"

namespace tyndall::levels {
namespace {

int wrap(int i, int period) {
  const int r = i % period;
  return r < 0 ? r + period : r;
}

}  // namespace

float cellHash(int x, int y, std::uint32_t seed) {
  // Finalizer of MurmurHash3 (Appleby, public domain) over a linear mix of the inputs.
  std::uint32_t h =
      static_cast<std::uint32_t>(x) * 0x9E3779B1u ^ static_cast<std::uint32_t>(y) * 0x85EBCA77u ^ seed * 0xC2B2AE3Du;
  h = (h ^ (h >> 16)) * 0x85EBCA6Bu;
  h = (h ^ (h >> 13)) * 0xC2B2AE35u;
  return static_cast<float>((h ^ (h >> 16)) >> 8) * 0x1p-24f;
}

float valueNoise(glm::vec2 p, glm::ivec2 period, std::uint32_t seed) {
  const glm::vec2 cell = glm::floor(p), f = p - cell, s = f * f * f * (f * (f * 6.0f - 15.0f) + 10.0f);
  const int x0 = wrap(static_cast<int>(cell.x), period.x), x1 = wrap(x0 + 1, period.x);
  const int y0 = wrap(static_cast<int>(cell.y), period.y), y1 = wrap(y0 + 1, period.y);
  const float low = glm::mix(cellHash(x0, y0, seed), cellHash(x1, y0, seed), s.x);
  const float high = glm::mix(cellHash(x0, y1, seed), cellHash(x1, y1, seed), s.x);
  return glm::mix(low, high, s.y);
}

float fbm(glm::vec2 p, glm::ivec2 period, int octaves, std::uint32_t seed) {
  float sum = 0, weight = 0, strength = 1;
  for (int i = 0; i < octaves; ++i) {
    sum += strength * valueNoise(p, period, seed + static_cast<std::uint32_t>(i));
    weight += strength;
    strength *= 0.5f, p *= 2.0f, period *= 2;
  }
  return sum / weight;
}

Cellular cellular(glm::vec2 p, glm::ivec2 period, std::uint32_t seed) {
  const glm::ivec2 cell(glm::floor(p));
  Cellular result{9, 9, 0};
  for (int y = cell.y - 1; y <= cell.y + 1; ++y) {
    for (int x = cell.x - 1; x <= cell.x + 1; ++x) {
      const int wx = wrap(x, period.x), wy = wrap(y, period.y);
      const glm::vec2 feature = glm::vec2(x, y) + glm::vec2(cellHash(wx, wy, seed), cellHash(wx, wy, seed + 1));
      const float distance = glm::length(feature - p);
      if (distance < result.nearest) {
        result = {distance, result.nearest, cellHash(wx, wy, seed + 2)};
      } else {
        result.second = glm::min(result.second, distance);
      }
    }
  }
  return result;
}

}  // namespace tyndall::levels
