// Files made by others, where they are at hand: none crashes or takes long; each loads soundly or is refused in a line.
#include <chrono>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "gltf_file.hpp"

namespace tyndall::scene {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files(const fs::path& folder) {
  std::vector<fs::path> out;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb"))
      out.push_back(entry.path());
  std::sort(out.begin(), out.end());
  return out;
}

/// The files that the Khronos validator finds no error in.
std::set<std::string> validFiles(const fs::path& manifest) {
  std::ifstream in(manifest);
  std::set<std::string> out;
  for (std::string line; std::getline(in, line);) {
    std::istringstream fields(line);
    std::string path, bytes, errors;
    if (std::getline(fields, path, '\t') && std::getline(fields, bytes, '\t') && std::getline(fields, errors, '\t') &&
        errors == "0")
      out.insert(path);
  }
  return out;
}

TEST(Corpus, BadFilesLoadSoundlyOrAreRefused) {
  const fs::path folder = fs::path(TYNDALL_SHARED_DIR) / "bad";
  if (!fs::exists(folder)) GTEST_SKIP() << "no " << folder;
  const std::set<std::string> valid = validFiles(folder / "validator_manifest.tsv");
  // Valid by the letter, and refused with reason.
  const std::set<std::string> exceptions = {
      "unknown_type.gltf",                              // an accessor type, a light type that nobody knows
      "min_version_valid.gltf",                         // wants glTF 2.1
      "non_relative_uri.gltf",                          // a network address
      "perspective_yfov.gltf",                          // a field of view beyond pi
      "named_objects.gltf",     "unused_objects.gltf",  // meshes in buffers that are not there
  };
  int loadedCount = 0, refused = 0;
  for (const fs::path& path : files(folder)) {
    const auto begin = std::chrono::steady_clock::now();
    const auto loaded = loadGltf(path);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    EXPECT_LT(taken.count(), 10) << path;
    if (!loaded.ok()) {
      ++refused;
      refusal(loaded, path);
      const bool excused =
          !valid.contains(fs::relative(path, folder).string()) || exceptions.contains(path.filename().string());
      EXPECT_TRUE(excused) << "valid, but " << loaded.error().message;
      continue;
    }
    ++loadedCount;
    const auto sound = checkScene(loaded->scene);
    EXPECT_TRUE(sound.ok()) << path << ": " << (sound.ok() ? "" : sound.error().message);
    for (const std::string& warning : loaded->warnings) EXPECT_EQ(warning.find('\n'), std::string::npos) << warning;
  }
  std::printf("%d loaded, %d refused\n", loadedCount, refused);
  EXPECT_GT(loadedCount, 0);
  EXPECT_GT(refused, 0);
}

/// Triangles on screen (instances counted), cameras and lights, counted once by a script of another language.
struct Content {
  std::size_t triangles, cameras, lights;
};

TEST(Corpus, RealLevelsLoadWithTheirContent) {
  const fs::path folder = fs::path(TYNDALL_SHARED_DIR) / "scenes";
  if (!fs::exists(folder)) GTEST_SKIP() << "no " << folder;
  const std::map<std::string, Content> known = {{"AlphaBlendModeTest.gltf", {61, 0, 0}},
                                                {"Mountains.gltf", {25600, 0, 0}},
                                                {"terrain.glb", {31422, 0, 0}},
                                                {"VolumetricFogExample.glb", {360, 0, 1}},
                                                {"comp_fence.glb", {3054, 1, 4}},
                                                {"comp_forest.glb", {76246, 1, 1}},
                                                {"comp_kenney_town.glb", {207342, 1, 1}},
                                                {"zdm2.glb", {58772, 0, 0}},
                                                {"japanese_bridge_garden_plain.glb", {21883, 0, 0}},
                                                {"Lights.glb", {12, 1, 4}},
                                                {"vr-gallery.glb", {1930, 0, 0}},
                                                {"gltf_KHR_lights_punctual_test.glb", {14, 1, 3}}};
  for (const fs::path& path : files(folder)) {
    const auto begin = std::chrono::steady_clock::now();
    const auto loaded = loadGltf(path);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    ASSERT_TRUE(loaded.ok()) << loaded.error().message;
    EXPECT_LT(taken.count(), 60) << path;
    const Scene& s = loaded->scene;
    const auto sound = checkScene(s);
    EXPECT_TRUE(sound.ok()) << path << ": " << (sound.ok() ? "" : sound.error().message);
    std::size_t triangles = 0;
    for (const Node& node : s.nodes)
      if (node.mesh != kNone)
        for (const Primitive& p : s.meshes[node.mesh].primitives) triangles += p.indices.size() / 3;
    const auto matrices = worldMatrices(s, 0);
    EXPECT_FALSE(worldBounds(s, matrices).empty()) << path;
    if (const auto expected = known.find(path.filename().string()); expected != known.end()) {
      EXPECT_EQ(triangles, expected->second.triangles) << path;
      EXPECT_EQ(placedCameras(s, 0).size(), expected->second.cameras) << path;
      EXPECT_EQ(placedLights(s, 0).size(), expected->second.lights) << path;
    }
  }
}

}  // namespace
}  // namespace tyndall::scene
