// Small glTF files made on the spot, in a folder that goes away with the test.
#pragma once

#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include "scene/check.hpp"
#include "scene/gltf.hpp"

namespace tyndall::scene {

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "scene-test-XXXXXX").string();
    if (!::mkdtemp(pattern.data())) ADD_FAILURE() << "no temporary folder";
    path_ = pattern;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path write(const std::string& name, const std::string& content) const {
    std::ofstream(path_ / name, std::ios::binary) << content;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

/// A .gltf with its buffer beside it. `json` may be edited freely before load().
struct GltfFile {
  nlohmann::json json = {{"asset", {{"version", "2.0"}}}};
  std::string bytes;
  TemporaryFolder folder;

  /// Adds a view and an accessor over `values`; returns the accessor's index.
  template <class T>
  int accessor(const std::vector<T>& values, int componentType, const std::string& type, std::size_t count,
               bool normalized = false) {
    bytes.resize((bytes.size() + 3) / 4 * 4);
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", values.size() * sizeof(T)}});
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                 {"componentType", componentType},
                                 {"type", type},
                                 {"count", count}});
    if (normalized) json["accessors"].back()["normalized"] = true;
    return static_cast<int>(json["accessors"].size()) - 1;
  }
  int floats(const std::vector<float>& values, const std::string& type) {
    const std::size_t width = type == "SCALAR" ? 1 : static_cast<std::size_t>(type.back() - '0');
    return accessor(values, 5126, type, values.size() / width);
  }
  /// One mesh of one primitive on one node in one scene.
  void mesh(const nlohmann::json& primitive) {
    json["meshes"] = {{{"primitives", {primitive}}}};
    json["nodes"] = {{{"mesh", 0}}};
    json["scenes"] = {{{"nodes", {0}}}};
    json["scene"] = 0;
  }
  /// A right triangle in the plane z = 0, in the unit square's corner.
  void triangle() { mesh({{"attributes", {{"POSITION", floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3")}}}}); }

  std::filesystem::path save() {
    if (!bytes.empty()) {
      folder.write("data.bin", bytes);
      if (!json.contains("buffers")) json["buffers"] = {{{"uri", "data.bin"}, {"byteLength", bytes.size()}}};
    }
    return folder.write("level.gltf", json.dump());
  }
  Result<Import> load() { return loadGltf(save()); }

  /// Loads a file that has to load, and checks the promise on what came.
  Scene scene() {
    auto result = load();
    if (!result) {
      ADD_FAILURE() << result.error().message;
      return {};
    }
    const auto sound = checkScene(result->scene);
    EXPECT_TRUE(sound.ok()) << (sound.ok() ? "" : sound.error().message);
    return result.take().scene;
  }
};

/// One line that starts with the path; returns it without the path.
inline std::string refusal(const Result<Import>& result, const std::filesystem::path& path) {
  if (result.ok()) {
    ADD_FAILURE() << path << " was loaded";
    return {};
  }
  const std::string& message = result.error().message;
  EXPECT_TRUE(message.starts_with(path.string() + ": ")) << message;
  for (const char c : message) EXPECT_GE(static_cast<unsigned char>(c), 0x20) << "control character in: " << message;
  EXPECT_GT(message.size(), path.string().size() + 6) << message;
  EXPECT_LT(message.size(), path.string().size() + 500) << message;
  return message.substr(std::min(message.size(), path.string().size() + 2));
}

/// What is said of a file: its refusal, else its warnings, one line each.
inline std::string told(const Result<Import>& result, const std::filesystem::path& path) {
  if (!result.ok()) return refusal(result, path);
  std::string lines;
  for (const std::string& warning : result->warnings) {
    for (const char c : warning) EXPECT_GE(static_cast<unsigned char>(c), 0x20) << "control character in: " << warning;
    lines += warning + "\n";
  }
  const auto sound = checkScene(result->scene);
  EXPECT_TRUE(sound.ok()) << (sound.ok() ? "" : sound.error().message);
  return lines;
}

}  // namespace tyndall::scene
