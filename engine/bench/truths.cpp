#include "bench/truths.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <glm/gtc/matrix_transform.hpp>

#include "base/file.hpp"
#include "base/hash.hpp"
#include "bench/error_split.hpp"

namespace tyndall::bench {
namespace {

/// Changes when the truth's own code does, so that old pictures are not taken for new ones.
constexpr const char* kGeneration = "2";

}  // namespace

scene::CameraView turned(const scene::CameraView& start, Turn turn) {
  scene::CameraView camera = start;
  const glm::mat4 yaw = glm::rotate(glm::mat4(1), static_cast<float>(glm::radians(turn.yaw)), glm::vec3(0, 1, 0));
  const glm::mat4 pitch = glm::rotate(glm::mat4(1), static_cast<float>(glm::radians(turn.pitch)), glm::vec3(1, 0, 0));
  glm::mat4 axes = start.worldFromView;
  const glm::vec4 place = axes[3];
  axes[3] = glm::vec4(0, 0, 0, 1);
  camera.worldFromView = yaw * axes * pitch;
  camera.worldFromView[3] = place;
  return camera;
}

std::optional<Turn> turnTowardsLight(const std::vector<scene::LightView>& lights, const scene::CameraView& camera,
                                     Size size) {
  struct Direction {
    double azimuth, elevation;  // degrees; azimuth grows to the left, as Turn::yaw
  };
  const auto directionOf = [](const glm::vec3& v) {
    const glm::dvec3 d = glm::normalize(glm::dvec3(v));
    return Direction{glm::degrees(std::atan2(-d.x, -d.z)), glm::degrees(std::asin(std::clamp(d.y, -1.0, 1.0)))};
  };
  const Direction ahead = directionOf(-glm::vec3(camera.worldFromView[2]));
  const double height = 0.5 * static_cast<double>(camera.camera.yfov);
  const double halfHeight = glm::degrees(std::atan(0.5 * std::tan(height)));
  const double halfWidth = glm::degrees(std::atan(0.5 * std::tan(height) * size.first / size.second));
  std::optional<Turn> best;
  for (const scene::LightView& light : lights) {
    const glm::vec3 towards = light.light.kind == scene::LightKind::kDirectional
                                  ? -light.direction
                                  : light.position - glm::vec3(camera.worldFromView[3]);
    if (glm::length(towards) < 1e-6f) continue;
    const Direction there = directionOf(towards);
    const Turn whole{std::remainder(there.azimuth - ahead.azimuth, 360.0), there.elevation - ahead.elevation};
    const auto shortOf = [](double angle, double by) {
      return std::copysign(std::max(0.0, std::abs(angle) - by), angle);
    };
    // Near the zenith azimuths run together and half way is not where it was reckoned: then the light goes to the
    // middle.
    for (const Turn& turn : {Turn{shortOf(whole.yaw, halfWidth), shortOf(whole.pitch, halfHeight)}, whole}) {
      if (!insidePicture(lightsInPicture({light}, turned(camera, turn), size), size)) continue;
      if (!best || std::hypot(turn.yaw, turn.pitch) < std::hypot(best->yaw, best->pitch)) best = turn;
      break;
    }
  }
  return best;
}

Result<Truth> truthOf(const app::Level& level, std::uint32_t camera, Turn turn, Size size, double seconds,
                      const truth::Medium& medium, std::uint32_t samples, const std::function<bool(double)>& progress) {
  auto view = app::chooseCamera(level, camera, seconds);
  if (!view) return view.error();
  *view = turned(*view, turn);
  char key[256];
  std::snprintf(key, sizeof key, "%s %u %ux%u %.17g %.17g %.17g %.17g %u", kGeneration, camera, size.first, size.second,
                seconds, medium.sigma_t, medium.albedo, medium.g, samples);
  const auto append = [&](const char* what, double degrees) {
    const std::size_t length = std::char_traits<char>::length(key);
    if (degrees != 0) std::snprintf(key + length, sizeof key - length, " %s %.9g", what, degrees);
  };
  append("turned", turn.yaw), append("raised", turn.pitch);
  const std::uint64_t hash = Hash().add(level.contentHash).text(key).value();
  char name[32];
  std::snprintf(name, sizeof name, "%016llx", static_cast<unsigned long long>(hash));
  const std::filesystem::path cache = cacheFolder(), folder = cache / "truths";
  const auto scatterFile = folder / (std::string(name) + "-scatter.exr"),
             distanceFile = folder / (std::string(name) + "-distance.exr");
  if (!cache.empty() && std::filesystem::exists(scatterFile) && std::filesystem::exists(distanceFile)) {
    auto scatter = image::readExr(scatterFile);
    auto distance = image::readExr(distanceFile);
    if (scatter && distance && scatter->channels == 4 && distance->channels == 1 && scatter->width == size.first &&
        distance->width == size.first && scatter->height == size.second && distance->height == size.second)
      return Truth{scatter.take(), std::move(distance->values)};
  }
  truth::Settings settings;
  settings.width = size.first;
  settings.height = size.second;
  settings.seconds = seconds;
  settings.medium = medium;
  settings.samples = samples;
  settings.progress = progress;
  auto picture = truth::render(level.scene, *view, level.lights(seconds), settings);
  if (!picture) return picture.error();
  Truth made{{size.first, size.second, 4, {}}, std::move(picture->distance)};
  for (const glm::vec4& p : picture->scatter)
    made.scatter.values.insert(made.scatter.values.end(), {p.r, p.g, p.b, p.a});
  if (cache.empty()) return made;
  std::error_code none;
  std::filesystem::create_directories(folder, none);
  if (!none && image::writeExr(scatterFile, made.scatter))
    (void)image::writeExr(distanceFile, {size.first, size.second, 1, made.distance});
  return made;
}

}  // namespace tyndall::bench
