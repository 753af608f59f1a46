#include "app/level.hpp"

#include <algorithm>
#include <system_error>

#include "base/file.hpp"
#include "scene/gltf.hpp"

namespace tyndall::app {
namespace fs = std::filesystem;

namespace {

bool looksLikePath(std::string_view text) {
  std::string extension = fs::path(text).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text.find('/') != std::string_view::npos || extension == ".gltf" || extension == ".glb";
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none (the build has not made them)" : text;
}

}  // namespace

fs::path levelFolder() { return executableFolder() / "levels"; }

std::vector<std::string> sampleLevels() {
  std::vector<std::string> names;
  std::error_code missing;
  for (fs::directory_iterator entry(levelFolder(), missing), end; !missing && entry != end; entry.increment(missing))
    if (entry->path().extension() == ".glb") names.push_back(entry->path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

Result<fs::path> findLevel(std::string_view text) {
  if (looksLikePath(text)) return fs::path(text);
  const std::vector<std::string> samples = sampleLevels();
  if (std::find(samples.begin(), samples.end(), text) != samples.end())
    return levelFolder() / (std::string(text) + ".glb");
  const std::string near = text.empty() ? "" : nearestName(text, samples);
  return badCall("LEVEL '" + std::string(text) + "': no such sample level" +
                 (near.empty() ? "" : ", did you mean '" + near + "'?") + "; samples: " + joined(samples) +
                 "; a path to a .gltf or .glb file is also possible");
}

Result<Level> loadLevel(std::string_view text) {
  auto path = findLevel(text);
  if (!path) return path.error();
  auto import = scene::loadGltf(*path);
  if (!import) return import.error();
  Level level;
  level.name = std::string(text);
  level.path = *path;
  level.scene = std::move(import->scene);
  level.contentHash = import->contentHash;
  for (const std::string& warning : import->warnings) level.warnings.push_back(path->string() + ": " + warning);
  if (scene::placedCameras(level.scene, 0).empty())
    level.notes.push_back(path->string() +
                          (level.scene.orthographicCameras > 0
                               ? ": has orthographic cameras only, which are not supported yet and left out"
                               : ": has no perspective camera") +
                          "; one that frames the level is used");
  if (scene::placedLights(level.scene, 0).empty())
    level.notes.push_back(path->string() + ": has no light; a default sun is used");
  return level;
}

std::vector<scene::CameraView> Level::cameras(double seconds) const {
  auto views = scene::placedCameras(scene, seconds);
  if (views.empty()) views.push_back(scene::framingCamera(scene::worldBounds(scene, worldFromNode(seconds))));
  return views;
}

std::vector<scene::LightView> Level::lights(double seconds) const {
  auto views = scene::placedLights(scene, seconds);
  if (views.empty()) views.push_back(scene::defaultSun());
  return views;
}

Result<scene::CameraView> chooseCamera(const Level& level, std::uint32_t index, double seconds) {
  const auto views = level.cameras(seconds);
  if (index < views.size()) return views[index];
  return badCall("--camera " + std::to_string(index) + ": " + level.path.string() + " has " +
                 std::to_string(views.size()) +
                 (views.size() == 1 ? " camera; only 0 is possible"
                                    : " cameras; 0 to " + std::to_string(views.size() - 1) + " are possible"));
}

}  // namespace tyndall::app
