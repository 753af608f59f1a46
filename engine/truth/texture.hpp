// Fetching from images as a GPU fetches from the full-resolution image.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <glm/glm.hpp>

#include "scene/scene.hpp"

namespace tyndall::truth {

/// Moves a coordinate into the wrap mode's first period, so that huge ones fit an integer after scaling.
inline double reduced(double coordinate, scene::Wrap wrap) {
  switch (wrap) {
    case scene::Wrap::kRepeat: return coordinate - std::floor(coordinate);
    case scene::Wrap::kMirroredRepeat: return coordinate - 2 * std::floor(coordinate / 2);
    case scene::Wrap::kClampToEdge: break;
  }
  return std::clamp(coordinate, -1.0, 2.0);
}

/// Vulkan 1.3, "Wrapping Operation".
inline std::int64_t wrapped(std::int64_t texel, std::int64_t size, scene::Wrap wrap) {
  const auto modulo = [](std::int64_t i, std::int64_t n) { return (i % n + n) % n; };
  switch (wrap) {
    case scene::Wrap::kRepeat: return modulo(texel, size);
    case scene::Wrap::kMirroredRepeat: {
      const std::int64_t i = modulo(texel, 2 * size) - size;
      return size - 1 - (i >= 0 ? i : -(1 + i));
    }
    case scene::Wrap::kClampToEdge: break;
  }
  return std::clamp<std::int64_t>(texel, 0, size - 1);
}

struct Grid {
  std::int64_t width, height;
  scene::Wrap wrapU, wrapV;
};

/// Bilinear over the texels around uv * size - 1/2; `texel(column, row)` gives one.
template <class Texel>
auto bilinear(const Grid& grid, glm::dvec2 uv, Texel&& texel) {
  const double x = reduced(uv.x, grid.wrapU) * static_cast<double>(grid.width);
  const double y = reduced(uv.y, grid.wrapV) * static_cast<double>(grid.height);
  const auto column = [&](double i) { return wrapped(static_cast<std::int64_t>(i), grid.width, grid.wrapU); };
  const auto row = [&](double j) { return wrapped(static_cast<std::int64_t>(j), grid.height, grid.wrapV); };
  const double i = std::floor(x - 0.5), j = std::floor(y - 0.5);
  const double a = x - 0.5 - i, b = y - 0.5 - j;
  const std::int64_t left = column(i), right = column(i + 1), top = row(j), bottom = row(j + 1);
  return (1 - b) * ((1 - a) * texel(left, top) + a * texel(right, top)) +
         b * ((1 - a) * texel(left, bottom) + a * texel(right, bottom));
}

}  // namespace tyndall::truth
