#include "bench/truths.hpp"

#include <cstdio>

#include <glm/gtc/matrix_transform.hpp>

#include "base/file.hpp"
#include "base/hash.hpp"

namespace tyndall::bench {
namespace {

/// Changes when the truth's own code does, so that old pictures are not taken for new ones.
constexpr const char* kGeneration = "1";

}  // namespace

scene::CameraView turned(const scene::CameraView& start, double degrees) {
  scene::CameraView camera = start;
  const glm::mat4 turn = glm::rotate(glm::mat4(1), static_cast<float>(glm::radians(degrees)), glm::vec3(0, 1, 0));
  glm::mat4 axes = start.worldFromView;
  const glm::vec4 place = axes[3];
  axes[3] = glm::vec4(0, 0, 0, 1);
  camera.worldFromView = turn * axes;
  camera.worldFromView[3] = place;
  return camera;
}

std::uint64_t levelHash(const std::string& level, const std::string& text) {
  Hash hash;
  hash.text(text);
  if (auto path = app::findLevel(level))
    if (auto bytes = readFile(*path)) hash.bytes(*bytes);
  return hash.value();
}

Result<Truth> truthOf(const app::Level& level, std::uint32_t camera, double degrees, Size size, double seconds, const truth::Medium& medium, std::uint32_t samples,
                      const std::function<bool(double)>& progress) {
  auto view = app::chooseCamera(level, camera, seconds);
  if (!view) return view.error();
  *view = turned(*view, degrees);
  auto bytes = readFile(level.path);
  if (!bytes) return bytes.error();
  char key[256];
  std::snprintf(key, sizeof key, "%s %u %ux%u %.17g %.17g %.17g %.17g %u", kGeneration, camera, size.first, size.second, seconds, medium.sigma_t, medium.albedo,
                medium.g, samples);
  if (degrees != 0) std::snprintf(key + std::char_traits<char>::length(key), 32, " turned %.9g", degrees);
  const std::uint64_t hash = Hash().bytes(*bytes).text(key).value();
  char name[32];
  std::snprintf(name, sizeof name, "%016llx", static_cast<unsigned long long>(hash));
  const std::filesystem::path folder = cacheFolder() / "truths";
  const auto scatterFile = folder / (std::string(name) + "-scatter.exr"), distanceFile = folder / (std::string(name) + "-distance.exr");
  if (std::filesystem::exists(scatterFile) && std::filesystem::exists(distanceFile)) {
    auto scatter = image::readExr(scatterFile);
    auto distance = image::readExr(distanceFile);
    if (scatter && distance && scatter->channels == 4 && distance->channels == 1 && scatter->width == size.first && distance->width == size.first)
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
  for (const glm::vec4& p : picture->scatter) made.scatter.values.insert(made.scatter.values.end(), {p.r, p.g, p.b, p.a});
  std::error_code none;
  std::filesystem::create_directories(folder, none);
  if (!none && image::writeExr(scatterFile, made.scatter)) (void)image::writeExr(distanceFile, {size.first, size.second, 1, made.distance});
  return made;
}

}  // namespace tyndall::bench
