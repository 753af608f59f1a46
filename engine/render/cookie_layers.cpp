#include "cookie_layers.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tyndall::render {

namespace {

constexpr float kPi = 3.14159265358979f;

struct Tap {
  std::uint32_t index;
  float weight;
};

std::uint32_t wrapped(std::int64_t i, std::uint32_t size, scene::Wrap wrap) {
  const auto n = static_cast<std::int64_t>(size);
  if (wrap == scene::Wrap::kRepeat) return static_cast<std::uint32_t>((i % n + n) % n);
  return static_cast<std::uint32_t>(std::clamp<std::int64_t>(i, 0, n - 1));  // mirrored: its first texel is the last
}

// What each of `out` texels takes of `in`.
std::vector<std::vector<Tap>> taps(std::uint32_t in, std::uint32_t out, scene::Wrap wrap) {
  std::vector<std::vector<Tap>> all(out);
  const double scale = static_cast<double>(in) / out;
  for (std::uint32_t i = 0; i < out; ++i) {
    if (in == out) {
      all[i] = {{i, 1.0f}};
    } else if (in < out) {
      const double place = (i + 0.5) * scale - 0.5, low = std::floor(place);
      const auto share = static_cast<float>(place - low);
      const auto first = static_cast<std::int64_t>(low);
      all[i] = {{wrapped(first, in, wrap), 1 - share}, {wrapped(first + 1, in, wrap), share}};
    } else {
      const double begin = i * scale, end = (i + 1) * scale;
      for (auto k = static_cast<std::uint32_t>(begin); k < in && k < end; ++k) {
        const double covered = std::min<double>(k + 1, end) - std::max<double>(k, begin);
        if (covered > 0) all[i].push_back({k, static_cast<float>(covered / scale)});
      }
    }
  }
  return all;
}

glm::vec3 bilinear(const Plane& in, double x, double y) {  // texel centres at half integers; around in x
  const double i = std::floor(x - 0.5), j = std::floor(y - 0.5);
  const auto a = static_cast<float>(x - 0.5 - i), b = static_cast<float>(y - 0.5 - j);
  const auto texel = [&](std::int64_t column, std::int64_t row) {
    return in.texels[std::size_t{wrapped(row, in.height, scene::Wrap::kClampToEdge)} * in.width +
                     wrapped(column, in.width, scene::Wrap::kRepeat)];
  };
  const auto l = static_cast<std::int64_t>(i), t = static_cast<std::int64_t>(j);
  return (1 - b) * ((1 - a) * texel(l, t) + a * texel(l + 1, t)) +
         b * ((1 - a) * texel(l, t + 1) + a * texel(l + 1, t + 1));
}

}  // namespace

Plane linearPlane(const scene::Image& image) {
  std::array<float, 256> decoded{};
  for (std::size_t code = 0; code < decoded.size(); ++code) {
    // IEC 61966-2-1.
    const double c = static_cast<double>(code) / 255;
    decoded[code] = static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
  }
  Plane plane{image.width, image.height, {}};
  plane.texels.reserve(image.rgba.size() / 4);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    plane.texels.emplace_back(decoded[image.rgba[i]], decoded[image.rgba[i + 1]], decoded[image.rgba[i + 2]]);
  return plane;
}

Plane resized(const Plane& in, std::uint32_t width, std::uint32_t height, scene::Wrap wrapU, scene::Wrap wrapV) {
  const auto columns = taps(in.width, width, wrapU), rows = taps(in.height, height, wrapV);
  Plane wide{width, in.height, std::vector<glm::vec3>(std::size_t{width} * in.height, glm::vec3(0))};
  for (std::uint32_t y = 0; y < in.height; ++y)
    for (std::uint32_t x = 0; x < width; ++x)
      for (const Tap& tap : columns[x])
        wide.texels[std::size_t{y} * width + x] += tap.weight * in.texels[std::size_t{y} * in.width + tap.index];
  Plane out{width, height, std::vector<glm::vec3>(std::size_t{width} * height, glm::vec3(0))};
  for (std::uint32_t y = 0; y < height; ++y)
    for (const Tap& tap : rows[y])
      for (std::uint32_t x = 0; x < width; ++x)
        out.texels[std::size_t{y} * width + x] += tap.weight * wide.texels[std::size_t{tap.index} * width + x];
  return out;
}

Plane mirroredOnce(const Plane& in, glm::bvec2 axes) {
  Plane out{in.width * (axes.x ? 2 : 1), in.height * (axes.y ? 2 : 1), {}};
  out.texels.reserve(std::size_t{out.width} * out.height);
  for (std::uint32_t y = 0; y < out.height; ++y)
    for (std::uint32_t x = 0; x < out.width; ++x)
      out.texels.push_back(in.texels[std::size_t{y < in.height ? y : out.height - 1 - y} * in.width +
                                     (x < in.width ? x : out.width - 1 - x)]);
  return out;
}

glm::vec3 cubeDirection(std::uint32_t face, float u, float v) {
  switch (face) {
    case 0: return {1, -v, -u};
    case 1: return {-1, -v, u};
    case 2: return {u, 1, v};
    case 3: return {u, -1, -v};
    case 4: return {u, -v, 1};
    default: return {-u, -v, -1};
  }
}

std::vector<Plane> facesFromEquirectangular(const Plane& in, std::uint32_t side) {
  // A texel in a face's middle is 2 / side wide as seen from the light, one of the image pi / height.
  const auto samples =
      static_cast<std::uint32_t>(std::max(1.0, std::ceil(2.0 * in.height / kPi / static_cast<double>(side) - 1e-6)));
  std::vector<Plane> faces;
  for (std::uint32_t face = 0; face < 6; ++face) {
    Plane& plane = faces.emplace_back(Plane{side, side, {}});
    plane.texels.reserve(std::size_t{side} * side);
    for (std::uint32_t y = 0; y < side; ++y)
      for (std::uint32_t x = 0; x < side; ++x) {
        glm::vec3 sum(0);
        for (std::uint32_t s = 0; s < samples * samples; ++s) {
          const auto at = [&](std::uint32_t texel, std::uint32_t sample) {
            return (static_cast<float>(texel) + (static_cast<float>(sample) + 0.5f) / static_cast<float>(samples)) /
                       static_cast<float>(side) * 2 -
                   1;
          };
          const glm::vec3 d = cubeDirection(face, at(x, s % samples), at(y, s / samples));
          const float u = 0.5f + std::atan2(d.x, -d.z) / (2 * kPi), v = std::acos(d.y / glm::length(d)) / kPi;
          sum += bilinear(in, double{u} * in.width, double{v} * in.height);
        }
        plane.texels.push_back(sum / static_cast<float>(samples * samples));
      }
  }
  return faces;
}

std::vector<Plane> facesFromStrip(const Plane& in, std::uint32_t side) {
  std::vector<Plane> faces;
  for (std::uint32_t face = 0; face < 6; ++face) {
    Plane cut{in.height, in.height, {}};
    for (std::uint32_t y = 0; y < in.height; ++y) {
      const auto row = in.texels.begin() + std::ptrdiff_t{y} * in.width + std::ptrdiff_t{face} * in.height;
      cut.texels.insert(cut.texels.end(), row, row + in.height);
    }
    faces.push_back(resized(cut, side, side, scene::Wrap::kClampToEdge, scene::Wrap::kClampToEdge));
  }
  return faces;
}

}  // namespace tyndall::render
