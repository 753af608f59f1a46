#include "sky_maps.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shadow_cache.hpp"
#include "shadow_fit.hpp"

namespace tyndall::render {

namespace {

using shared::kSkyCascades;
using shared::kSkyDirections;
using shared::kSkyTexels;

// Half side of the finest square, metres: with 512 texels a room's corners are sharp to 6 cm.
constexpr double kFinest = 16;
// Texels that the filter and the receiver's offset read beyond a place.
constexpr double kBorderTexels = 8;

struct Square {
  glm::vec3 center{0};
  double radius = 1;
};

// Finest first; the last one holds all casters. The eye stays in the middle half of the others.
std::vector<Square> squares(const scene::Bounds& casters, const glm::vec3& eye) {
  const glm::vec3 center = 0.5f * (casters.min + casters.max);
  const double radius = std::max(1e-3, 0.5 * glm::length(glm::dvec3(casters.max) - glm::dvec3(casters.min))) /
                        (1 - 2 * kBorderTexels / kSkyTexels);
  std::vector<double> around;
  if (radius > 1.5 * kFinest) around.push_back(kFinest);
  if (radius > 8 * kFinest) around.push_back(std::sqrt(kFinest * radius));
  std::vector<Square> all;
  for (const double r : around) {
    const auto step = static_cast<float>(r / 2);
    all.push_back({glm::round(eye / step) * step, r});
  }
  all.push_back({center, radius});
  return all;
}

bool same(const SkyLayer& a, const SkyLayer& b) {
  return a.content == b.content && a.map.u == b.map.u && a.map.v == b.map.v && a.map.depth == b.map.depth;
}

}  // namespace

std::vector<glm::vec3> skyDirections() {
  // Equal steps of height are equal solid angles; turned by the golden angle (Gonzalez 2010, Measurement of Areas on a
  // Sphere Using Fibonacci and Latitude-Longitude Lattices).
  std::vector<glm::vec3> directions;
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  for (std::uint32_t i = 0; i < kSkyDirections; ++i) {
    const double y = (i + 0.5) / kSkyDirections, across = std::sqrt(1 - y * y), turn = golden * i;
    directions.emplace_back(across * std::cos(turn), y, across * std::sin(turn));
  }
  return directions;
}

shared::SkyMap fitSkyMap(const glm::vec3& direction, const glm::vec3& center, double radius,
                         const scene::Bounds& casters) {
  const glm::dvec3 d(direction);
  const glm::dvec3 x = glm::normalize(glm::cross(d.y > 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0), d));
  const glm::dvec3 y = glm::cross(d, x);
  double top = -1e30, bottom = 1e30;
  for (const glm::vec3& corner : boxCorners(casters, center)) {
    const double along = glm::dot(glm::dvec3(corner), d);
    top = std::max(top, along), bottom = std::min(bottom, along);
  }
  const double pad = 1e-3 * (top - bottom) + 1e-3;
  top += pad, bottom -= pad;
  const double width = 2 * radius, depth = top - bottom;
  shared::SkyMap map{};
  map.u = glm::vec4(glm::dvec4(x / width, 0.5 - glm::dot(x, glm::dvec3(center)) / width));
  map.v = glm::vec4(glm::dvec4(y / width, 0.5 - glm::dot(y, glm::dvec3(center)) / width));
  map.depth = glm::vec4(glm::dvec4(-d / depth, top / depth));
  map.texel = static_cast<float>(width / kSkyTexels);
  return map;
}

glm::mat4 clipFromWorld(const shared::SkyMap& map) {
  const glm::vec4 one(0, 0, 0, 1);
  return glm::transpose(glm::mat4(2.0f * map.u - one, 2.0f * map.v - one, map.depth, one));
}

Result<std::shared_ptr<const SkyFrame>> SkyMaps::plan(const FrameData& frame, float strength) {
  auto sky = std::make_shared<SkyFrame>();
  const std::vector<glm::vec3> directions = skyDirections();
  std::copy(directions.begin(), directions.end(), sky->block.directions);
  sky->block.strength = strength;
  const scene::Bounds& casters = frame.draws.casters;
  // Without maps the sky is seen whole: where it gives no light, that is as good.
  if (casters.empty() || strength <= 0) return std::shared_ptr<const SkyFrame>(sky);

  const std::vector<Square> all = squares(casters, frame.view.eye);
  const auto count = static_cast<std::uint32_t>(all.size()) * kSkyDirections;
  if (!kept_ || kept_->layers.size() != count) {
    kept_.reset();
    gpu::ImageDesc desc;
    desc.name = "sky maps";
    desc.format = VK_FORMAT_R32_SFLOAT;
    desc.width = desc.height = kSkyTexels;
    desc.layers = count;
    desc.usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    Result<gpu::Image> image = device_.createImage(desc);
    if (!image) return image.error();
    kept_ = std::make_shared<KeptSky>();
    kept_->image = image.take();
    kept_->layers.resize(count);
  }
  sky->kept = kept_;

  std::vector<SkyLayer> shown = kept_->layers;
  const std::uint64_t content = casterContent(frame);
  for (std::uint32_t layer = 0; layer < count; ++layer) {
    const Square& square = all[layer / kSkyDirections];
    SkyLayer wanted{fitSkyMap(directions[layer % kSkyDirections], square.center, square.radius, casters), content};
    wanted.map.layer = layer;
    if (kept_->drawn && same(wanted, kept_->layers[layer])) continue;
    shown[layer] = wanted;
    sky->drawn.emplace_back(layer, wanted);
  }
  for (std::uint32_t i = 0; i < kSkyDirections * kSkyCascades; ++i) {
    const std::uint32_t cascade = std::min(i / kSkyDirections, count / kSkyDirections - 1);
    sky->block.maps[i] = shown[cascade * kSkyDirections + i % kSkyDirections].map;
  }
  return std::shared_ptr<const SkyFrame>(sky);
}

}  // namespace tyndall::render
