#include "bench/error_split.hpp"

#include <algorithm>
#include <cmath>

namespace tyndall::bench {
namespace {

constexpr float kLightRadius = 16;      // pixels
constexpr float kDepthStep = 0.05f;     // of the smaller distance
constexpr float kOtherSurface = 0.01f;  // of transmittance

enum class Part { kSilhouette, kInterior, kLight };

/// Absolute and signed errors of one part.
struct Sums {
  double squares = 0, signedSum = 0, greatest = 0;
  std::vector<float> values;

  void add(double difference) {
    squares += difference * difference;
    signedSum += difference;
    greatest = std::max(greatest, std::abs(difference));
    values.push_back(static_cast<float>(std::abs(difference)));
  }
  std::optional<Errors> over(double mean) {
    if (values.empty()) return std::nullopt;
    const auto count = static_cast<double>(values.size());
    const auto rank = static_cast<std::size_t>(std::ceil(0.99 * count)) - 1;
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rank), values.end());
    return Errors{std::sqrt(squares / count) / mean, static_cast<double>(values[rank]) / mean, greatest / mean,
                  signedSum / count / mean, values.size() / 3};
  }
};

bool stepBeside(const std::vector<float>& distance, std::uint32_t width, std::uint32_t height, std::uint32_t x,
                std::uint32_t y) {
  const float own = distance[std::size_t{y} * width + x];
  for (std::uint32_t v = y > 0 ? y - 1 : 0; v <= std::min(y + 1, height - 1); ++v)
    for (std::uint32_t u = x > 0 ? x - 1 : 0; u <= std::min(x + 1, width - 1); ++u) {
      const float other = distance[std::size_t{v} * width + u];
      if (std::abs(other - own) > kDepthStep * std::min(other, own)) return true;
    }
  return false;
}

}  // namespace

std::vector<glm::vec2> lightsInPicture(const std::vector<scene::LightView>& lights, const scene::CameraView& camera,
                                       Size size) {
  const glm::vec2 pixels(static_cast<float>(size.first), static_cast<float>(size.second));
  const glm::mat3 axes(camera.worldFromView);
  const glm::vec3 eye(camera.worldFromView[3]);
  std::vector<glm::vec2> places;
  for (const scene::LightView& light : lights) {
    const glm::vec3 towards =
        light.light.kind == scene::LightKind::kDirectional ? -light.direction : light.position - eye;
    const glm::vec3 v = glm::transpose(axes) * towards;
    if (v.z >= 0) continue;
    const float reach = std::tan(0.5f * camera.camera.yfov);
    const glm::vec2 onScreen(v.x / (-v.z * reach * pixels.x / pixels.y), v.y / (-v.z * reach));
    places.push_back({0.5f * pixels.x * (1 + onScreen.x), 0.5f * pixels.y * (1 - onScreen.y)});
  }
  return places;
}

bool insidePicture(const std::vector<glm::vec2>& places, Size size) {
  return std::any_of(places.begin(), places.end(), [&](const glm::vec2& p) {
    return p.x >= 0 && p.y >= 0 && p.x < static_cast<float>(size.first) && p.y < static_cast<float>(size.second);
  });
}

image::FloatImage onSameSurface(const image::FloatImage& picture, const image::FloatImage& reference) {
  image::FloatImage result = picture;
  if (picture.width != reference.width || picture.height != reference.height || picture.channels != 4 ||
      reference.channels != 4)
    return result;
  for (std::uint32_t y = 0; y < picture.height; ++y)
    for (std::uint32_t x = 0; x < picture.width; ++x)
      if (std::abs(picture.at(x, y, 3) - reference.at(x, y, 3)) > kOtherSurface)
        for (std::uint32_t c = 0; c < 4; ++c) result.at(x, y, c) = reference.at(x, y, c);
  return result;
}

Result<SplitErrors> splitErrors(const image::FloatImage& picture, const image::FloatImage& reference,
                                const std::vector<float>& distance, const std::vector<glm::vec2>& lights) {
  const std::uint32_t width = reference.width, height = reference.height;
  if (picture.width != width || picture.height != height || picture.channels != 4 || reference.channels != 4)
    return failed("pictures of different sizes or channels cannot be compared");
  if (!distance.empty() && distance.size() != std::size_t{width} * height)
    return failed("the distances are of another size than the picture");
  double sum = 0;
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x)
      for (std::uint32_t c = 0; c < 4; ++c) {
        if (!std::isfinite(picture.at(x, y, c)) || !std::isfinite(reference.at(x, y, c)))
          return failed("pixel " + std::to_string(x) + ", " + std::to_string(y) + " is not finite");
        if (c < 3) sum += static_cast<double>(reference.at(x, y, c));
      }
  const double mean = sum / (3.0 * width * height);
  if (!(mean > 0)) return failed("the reference is black: nothing can be divided by its mean");

  Sums all, parts[3];
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x) {
      const glm::vec2 at(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      Part part = Part::kInterior;
      if (std::abs(picture.at(x, y, 3) - reference.at(x, y, 3)) > kOtherSurface ||
          (!distance.empty() && stepBeside(distance, width, height, x, y)))
        part = Part::kSilhouette;
      for (const glm::vec2& light : lights)
        if (glm::length(light - at) <= kLightRadius) part = Part::kLight;
      for (std::uint32_t c = 0; c < 3; ++c) {
        const double difference = static_cast<double>(picture.at(x, y, c)) - static_cast<double>(reference.at(x, y, c));
        all.add(difference);
        parts[static_cast<int>(part)].add(difference);
      }
    }
  return SplitErrors{all.over(mean), parts[0].over(mean), parts[1].over(mean), parts[2].over(mean)};
}

}  // namespace tyndall::bench
