// A level by sample name or path, with the camera and light that a file may lack. Needs no GPU.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "scene/scene.hpp"

namespace tyndall::app {

struct Level {
  std::string name;  ///< the sample's name or the path, as it was asked for
  std::filesystem::path path;
  scene::Scene scene;
  std::uint64_t contentHash = 0;      ///< of every file that was read for it
  std::vector<std::string> warnings;  ///< of the importer, each starting with the path
  std::vector<std::string> notes;     ///< "... has no camera ...", "... has no light ..."

  std::vector<glm::mat4> worldFromNode(double seconds) const { return scene::worldMatrices(scene, seconds); }
  /// The file's perspective cameras in node order, or one that frames the level when it has none. Never empty.
  std::vector<scene::CameraView> cameras(double seconds) const;
  /// The file's lights, or the default sun when it has none.
  std::vector<scene::LightView> lights(double seconds) const;
};

/// Folder of the sample levels: levels/ beside the executable.
std::filesystem::path levelFolder();
/// Names of the sample levels, sorted.
std::vector<std::string> sampleLevels();

/// What `text` means: a sample's name, or a path when it has a slash or ends in .gltf or .glb. An unknown name is a bad
/// call that lists the samples.
Result<std::filesystem::path> findLevel(std::string_view text);
Result<Level> loadLevel(std::string_view text);

/// Camera `index` of the level, or a bad call that says how many there are.
Result<scene::CameraView> chooseCamera(const Level& level, std::uint32_t index, double seconds);

}  // namespace tyndall::app
