// Each kind of broken or hostile file is told: in a warning where the rest can be shown, else in one line that refuses
// it, starts with its path and says what is wrong.
#include <cmath>
#include <functional>

#include "gltf_file.hpp"

namespace tyndall::scene {
namespace {

/// `edit` breaks a file that is good; `reason` has to be part of the refusal.
void expectRefused(const std::string& reason, const std::function<void(GltfFile&)>& edit) {
  GltfFile f;
  f.triangle();
  edit(f);
  const auto path = f.save();
  const std::string text = refusal(loadGltf(path), path);
  EXPECT_NE(text.find(reason), std::string::npos) << text << "\n  does not say: " << reason;
}
/// `edit` breaks a part. Alone it is told, be it as a refusal or as a warning; beside a sound part it is a warning, and
/// that part is there.
void expectTold(const std::string& reason, const std::function<void(GltfFile&)>& edit, bool besideToo = true) {
  for (const bool beside : {false, true}) {
    if (beside && !besideToo) break;  // a sound part would mend it
    GltfFile f;
    f.triangle();
    edit(f);
    if (beside) {
      nlohmann::json& j = f.json;
      for (const char* list : {"buffers", "bufferViews", "accessors", "meshes", "nodes"})
        if (!j[list].is_array()) j[list] = nlohmann::json::array();
      f.save();  // makes the file's own buffer
      if (j["buffers"].empty()) j["buffers"] = {{{"uri", "data.bin"}, {"byteLength", f.bytes.size()}}};
      f.folder.write("sound.bin", std::string("\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3f\0\0\0\0\0\0\0\0", 24) +
                                      std::string("\0\0\0\0\0\0\x80\x3f\0\0\0\0", 12));
      j["buffers"].push_back({{"uri", "sound.bin"}, {"byteLength", 36}});
      j["bufferViews"].push_back({{"buffer", j["buffers"].size() - 1}, {"byteLength", 36}});
      j["accessors"].push_back(
          {{"bufferView", j["bufferViews"].size() - 1}, {"componentType", 5126}, {"type", "VEC3"}, {"count", 3}});
      j["meshes"].push_back(
          {{"name", "sound"}, {"primitives", {{{"attributes", {{"POSITION", j["accessors"].size() - 1}}}}}}});
      j["nodes"].push_back({{"mesh", j["meshes"].size() - 1}});
      if (!j["scenes"].is_array()) j["scenes"] = {{{"nodes", nlohmann::json::array()}}};
      j["scenes"][0]["nodes"].push_back(j["nodes"].size() - 1);
    }
    const auto path = f.save();
    const auto loaded = loadGltf(path);
    const std::string text = told(loaded, path);
    EXPECT_NE(text.find(reason), std::string::npos) << text << "\n  does not say: " << reason;
    if (!beside) continue;
    ASSERT_TRUE(loaded.ok()) << reason << ": " << loaded.error().message;
    std::size_t found = 0;
    for (const Mesh& mesh : loaded->scene.meshes)
      if (mesh.name == "sound" && !mesh.primitives.empty()) found += mesh.primitives[0].indices.size();
    EXPECT_EQ(found, 3u) << reason;
  }
}
void expectRefused(const std::string& reason, const std::string& content, const std::string& name = "level.gltf") {
  TemporaryFolder folder;
  const auto path = folder.write(name, content);
  const std::string text = refusal(loadGltf(path), path);
  EXPECT_NE(text.find(reason), std::string::npos) << text << "\n  does not say: " << reason;
}
std::string glb(std::uint32_t version, std::uint32_t length, const std::string& chunks) {
  std::string out = "glTF";
  out.append(reinterpret_cast<const char*>(&version), 4);
  out.append(reinterpret_cast<const char*>(&length), 4);
  return out + chunks;
}

TEST(BadFiles, TheGoodOneLoads) {
  GltfFile f;
  f.triangle();
  EXPECT_EQ(f.scene().meshes.size(), 1u);
}

TEST(BadFiles, Containers) {
  TemporaryFolder folder;
  EXPECT_NE(refusal(loadGltf(folder / "none.glb"), folder / "none.glb").find("No such file"), std::string::npos);
  EXPECT_NE(refusal(loadGltf(folder.path()), folder.path()).find("not a regular file"), std::string::npos);
  expectRefused("is empty", "");
  expectRefused("neither glTF", "PK\x03\x04");
  expectRefused("12 bytes", "glTF\x02");
  expectRefused("version 1", glb(1, 20, "12345678"));
  expectRefused("truncated", glb(2, 4000, "12345678"));
  expectRefused("no room", glb(2, 12, ""));
  expectRefused("announces 4294967295", glb(2, 20, std::string("\xff\xff\xff\xffJSON")));
  expectRefused("not JSON", glb(2, 20, std::string("\0\0\0\0BIN\0", 8)));
}

TEST(BadFiles, Json) {
  expectRefused("JSON is broken", "{");
  expectRefused("JSON is broken", "{\"asset\": {\"version\": \"2.0\"}, \"nodes\": [1e999]}");
  expectRefused("not an object", " [1, 2]");
  expectRefused("asset is missing", "{}");
  expectRefused("glTF 2.0 is read", R"({"asset": {"version": "1.0"}})");
  expectRefused("glTF 2.0 is read", R"({"asset": {"version": "2.0", "minVersion": "2.1"}})");
  expectRefused("asset.version is not a string", R"({"asset": {"version": 2}})");
  expectRefused("nests deeper", "{\"extras\": " + std::string(1'000'000, '['));
  std::string many = "{\"extras\": [0";
  for (int i = 0; i < 5'000'000; ++i) many += ",0";
  expectRefused("more than 4000000 values", many + "]}");
}

TEST(BadFiles, TypesAndIndices) {
  expectTold(
      "nodes is not an array", [](GltfFile& f) { f.json["nodes"] = 3; }, false);
  expectTold("nodes[0] is not an object", [](GltfFile& f) { f.json["nodes"] = {nullptr}; });
  expectTold(
      "nodes[0].mesh is 1; there are 1 meshes", [](GltfFile& f) { f.json["nodes"][0]["mesh"] = 1; }, false);
  expectTold("nodes[0].mesh is -1", [](GltfFile& f) { f.json["nodes"][0]["mesh"] = -1; });
  expectTold("nodes[0].mesh is 0.5", [](GltfFile& f) { f.json["nodes"][0]["mesh"] = 0.5; });
  expectTold("nodes[0].mesh is 4294967296", [](GltfFile& f) { f.json["nodes"][0]["mesh"] = 4294967296; });
  expectTold("nodes[0].matrix has 15 elements",
             [](GltfFile& f) { f.json["nodes"][0]["matrix"] = std::vector<float>(15, 1); });
  expectTold("nodes[0].translation[1]", [](GltfFile& f) { f.json["nodes"][0]["translation"] = {0, 1e300, 0}; });
  expectTold("there are 0 KHR_lights_punctual.lights",
             [](GltfFile& f) { f.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0; });
  expectTold("attributes.POSITION is 9",
             [](GltfFile& f) { f.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 9; });
  expectTold("mode is 7", [](GltfFile& f) { f.json["meshes"][0]["primitives"][0]["mode"] = 7; });
  expectTold("alphaMode is \"\\x0aGLASS\"", [](GltfFile& f) { f.json["materials"] = {{{"alphaMode", "\nGLASS"}}}; });
  expectTold("scene is 5", [](GltfFile& f) { f.json["scene"] = 5; });
}

TEST(BadFiles, NodeTrees) {
  expectTold("child twice", [](GltfFile& f) {
    f.json["nodes"] = {{{"children", {2}}}, {{"children", {2}}}, nlohmann::json::object()};
  });
  expectTold("which is a child of", [](GltfFile& f) { f.json["nodes"] = {{{"children", {1}}}, {{"children", {0}}}}; });
  expectTold("which is a child of", [](GltfFile& f) { f.json["nodes"] = {{{"children", {0}}}}; });
  expectTold("twice", [](GltfFile& f) { f.json["scenes"][0]["nodes"] = {0, 0}; });
  expectTold("not affine", [](GltfFile& f) { f.json["nodes"][0]["matrix"] = std::vector<float>(16, 1); });
  expectTold("beyond", [](GltfFile& f) { f.json["nodes"][0]["scale"] = {1e20, 1, 1}; });
  expectTold("beyond", [](GltfFile& f) {
    f.json["nodes"] = {{{"scale", {1e8, 1, 1}}, {"children", {1}}}, {{"scale", {1e8, 1, 1}}, {"mesh", 0}}};
  });
}

TEST(BadFiles, AccessorsAndViews) {
  expectTold("needs 48 bytes; its buffer view has 36", [](GltfFile& f) { f.json["accessors"][0]["count"] = 4; });
  expectTold("needs 120000000 bytes", [](GltfFile& f) { f.json["accessors"][0]["count"] = 10'000'000; });
  expectRefused("more than 16777216 vertices", [](GltfFile& f) { f.json["accessors"][0]["count"] = 2147483647; });
  expectTold("without elements", [](GltfFile& f) { f.json["accessors"][0]["count"] = 0; });
  expectTold("needs 37 bytes", [](GltfFile& f) { f.json["accessors"][0]["byteOffset"] = 1; });
  expectTold("ends at byte 37; buffers[0] has 36", [](GltfFile& f) { f.json["bufferViews"][0]["byteLength"] = 37; });
  expectTold("a stride of 4 bytes is below", [](GltfFile& f) { f.json["bufferViews"][0]["byteStride"] = 4; });
  expectTold("multiple of 4", [](GltfFile& f) { f.json["bufferViews"][0]["byteStride"] = 13; });
  expectTold("componentType is \"5124\"", [](GltfFile& f) { f.json["accessors"][0]["componentType"] = 5124; });
  expectTold("has 2 components; 3 are expected", [](GltfFile& f) { f.json["accessors"][0]["type"] = "VEC2"; });
  expectTold("is a matrix", [](GltfFile& f) { f.json["accessors"][0]["type"] = "MAT2"; });
  expectTold("no buffer view", [](GltfFile& f) {
    f.json["accessors"].push_back({{"componentType", 5126}, {"type", "VEC3"}, {"count", 2000000}});
    f.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 1;
  });
  expectRefused(
      "more than", [](GltfFile& f) {  // a small file that asks for gigabytes: many parts share one long accessor
        f.json["accessors"].push_back({{"componentType", 5126}, {"type", "VEC3"}, {"count", 1000000}});
        f.json["meshes"][0]["primitives"] = std::vector<nlohmann::json>(1000, {{"attributes", {{"POSITION", 1}}}});
      });
  expectTold("POSITION: element 0 is not finite", [](GltfFile& f) { f.bytes.replace(0, 4, "\0\0\xc0\x7f", 4); });
  expectTold("NORMAL has 2 elements; POSITION has 3", [](GltfFile& f) {
    f.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = f.floats({0, 0, 1, 0, 0, 1}, "VEC3");
  });
  expectTold("indices[2] is 3; there are 3 vertices", [](GltfFile& f) {
    f.json["meshes"][0]["primitives"][0]["indices"] = f.accessor(std::vector<std::uint8_t>{0, 1, 3}, 5121, "SCALAR", 3);
  });
  expectTold("not unsigned integers", [](GltfFile& f) {
    f.json["meshes"][0]["primitives"][0]["indices"] = f.floats({0, 1, 2}, "SCALAR");
  });
  expectTold("strictly increasing", [](GltfFile& f) {
    const int at = f.accessor(std::vector<std::uint8_t>{2, 1}, 5121, "SCALAR", 2),
              values = f.floats({0, 0, 0, 0, 0, 0}, "VEC3");
    f.json["accessors"][0]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", f.json["accessors"][at]["bufferView"]}, {"componentType", 5121}}},
        {"values", {{"bufferView", f.json["accessors"][values]["bufferView"]}}}};
  });
}

TEST(BadFiles, Buffers) {
  const auto buffer = [](const nlohmann::json& b) { return [b](GltfFile& f) { f.json["buffers"] = {b}; }; };
  expectTold("announces 999 bytes; 36 are there", buffer({{"uri", "data.bin"}, {"byteLength", 999}}));
  expectTold("No such file", buffer({{"uri", "none.bin"}, {"byteLength", 36}}));
  expectTold("not valid base64", buffer({{"uri", "data:application/octet-stream;base64,A*B="}, {"byteLength", 36}}));
  expectTold("no comma", buffer({{"uri", "data:application/octet-stream"}, {"byteLength", 36}}));
  expectTold("is empty", buffer({{"uri", ""}, {"byteLength", 36}}));
  expectTold("byteLength is -36", buffer({{"uri", "data.bin"}, {"byteLength", -36}}));
}

TEST(BadFiles, NothingOutsideTheFolderIsRead) {
  TemporaryFolder outside;
  const std::string secret = outside.write("secret.bin", std::string(36, '\0')).string();
  const auto uri = [](const std::string& text) {
    return [text](GltfFile& f) { f.json["buffers"] = {{{"uri", text}, {"byteLength", 36}}}; };
  };
  expectRefused("absolute", uri(secret));
  expectRefused("absolute", uri("%2Fetc/passwd"));
  expectRefused("outside the level's folder", uri("../" + secret));
  expectRefused("outside the level's folder", uri("a/%2e%2E/../b.bin"));
  expectRefused("outside the level's folder", uri("..\\..\\b.bin"));
  expectRefused("network", uri("C:\\b.bin"));
  expectRefused("network", uri("http://localhost/a.bin"));
  expectRefused("network", uri("file://" + secret));
  expectTold("not a file name", uri("data.bin%00.png"));
  expectRefused("link that leads outside", [&](GltfFile& f) {
    std::filesystem::create_symlink(secret, f.folder / "link.bin");
    f.json["buffers"] = {{{"uri", "link.bin"}, {"byteLength", 36}}};
  });
  expectRefused("link that leads outside", [&](GltfFile& f) {
    std::filesystem::create_directory_symlink(outside.path(), f.folder / "linked");
    f.json["buffers"] = {{{"uri", "linked/secret.bin"}, {"byteLength", 36}}};
  });
  expectTold("not a regular file", [&](GltfFile& f) {
    std::filesystem::create_directory(f.folder / "sub");
    f.json["buffers"] = {{{"uri", "sub"}, {"byteLength", 36}}};
  });
  // Links within the folder, folders below it, and escaped names are fine.
  GltfFile f;
  f.triangle();
  f.save();
  std::filesystem::create_directory(f.folder / "sub");
  std::filesystem::copy(f.folder / "data.bin", f.folder / "sub/my data.bin");
  std::filesystem::create_symlink("sub/my data.bin", f.folder / "inner.bin");
  const std::string self = "../" + f.folder.path().filename().string() + "/data.bin";
  for (const std::string& good :
       {std::string("sub/my%20data.bin"), std::string("sub/my data.bin"), std::string("./inner.bin"),
        std::string("sub/../data.bin"), std::string("gone/%2e%2E/data.bin"), std::string("sub\\my data.bin"), self}) {
    f.json["buffers"] = {{{"uri", good}, {"byteLength", 36}}};
    EXPECT_TRUE(f.load().ok()) << good;
  }
}

TEST(BadFiles, RequiredExtensions) {
  for (const char* name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_texture_basisu", "EXT_\nnew"})
    expectRefused(std::string("requires the extension \"") + (name[4] == '\n' ? "EXT_\\x0anew" : name),
                  [&](GltfFile& f) { f.json["extensionsRequired"] = {name}; });
  GltfFile f;
  f.triangle();
  f.json["extensionsUsed"] = {"KHR_mesh_quantization", "KHR_materials_ior"};
  f.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  const auto loaded = f.load();
  ASSERT_TRUE(loaded.ok());
  ASSERT_EQ(loaded->warnings.size(), 1u);
  EXPECT_NE(loaded->warnings[0].find("KHR_materials_ior"), std::string::npos);
}

TEST(BadFiles, CamerasAndAnimations) {
  expectTold("perspective is missing", [](GltfFile& f) { f.json["cameras"] = {{{"type", "perspective"}}}; });
  expectTold("yfov is 4", [](GltfFile& f) {
    f.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 4}, {"znear", 1}}}}};
  });
  const auto animate = [](const nlohmann::json& sampler, int channelSampler) {
    return [=](GltfFile& f) {
      f.floats({0, 1}, "SCALAR");
      f.json["animations"] = {
          {{"samplers", {sampler}},
           {"channels", {{{"sampler", channelSampler}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}};
    };
  };
  expectTold("2 are expected", animate({{"input", 1}, {"output", 0}}, 0));
  expectTold("3 are expected", animate({{"input", 1}, {"output", 1}}, 0));
  expectTold("not a list of floats", animate({{"input", 0}, {"output", 0}}, 0));
  expectTold("with sampler 1; there are 1", animate({{"input", 1}, {"output", 0}}, 1));
  expectTold("interpolation is \"WOBBLE\"", animate({{"input", 1}, {"output", 0}, {"interpolation", "WOBBLE"}}, 0));
}

TEST(CheckScene, FindsWhatAnImporterMustNotHandOut) {
  const auto complaint = [](const std::function<void(Scene&)>& edit) {
    GltfFile f;
    f.triangle();
    Scene s = f.scene();
    edit(s);
    const auto sound = checkScene(s);
    return sound.ok() ? std::string() : sound.error().message;
  };
  EXPECT_EQ(complaint([](Scene&) {}), "");
  EXPECT_NE(complaint([](Scene& s) { s.nodes[0].parent = 0; }), "");
  EXPECT_NE(complaint([](Scene& s) { s.meshes[0].primitives[0].indices.pop_back(); }), "");
  EXPECT_NE(complaint([](Scene& s) { s.meshes[0].primitives[0].indices[1] = 3; }), "");
  EXPECT_NE(complaint([](Scene& s) { s.meshes[0].primitives[0].vertices[1].normal *= 1.1f; }), "");
  EXPECT_NE(complaint([](Scene& s) { s.meshes[0].primitives[0].vertices[1].tangent.w = 0; }), "");
  EXPECT_NE(complaint([](Scene& s) { s.meshes[0].primitives[0].vertices[1].uv.x = NAN; }), "");
  EXPECT_NE(complaint([](Scene& s) { s.meshes[0].primitives[0].bounds.max.x = 9; }), "");
  EXPECT_NE(complaint([](Scene& s) { s.meshes[0].primitives[0].material = 0; }), "");
  EXPECT_NE(complaint([](Scene& s) { s.images = {{"", 2, 2, {1, 2, 3}}}; }), "");
  EXPECT_NE(complaint([](Scene& s) { s.textures = {{0, {}}}; }), "");
  EXPECT_NE(complaint([](Scene& s) { s.cameras = {{"", 0, 1, {}}}; }), "");
  EXPECT_NE(complaint([](Scene& s) { s.lights = {{"", LightKind::kSpot, glm::vec3(1), 1, {}, 0.6f, 0.5f}}; }), "");
  EXPECT_NE(complaint([](Scene& s) { s.nodes[0].rotation = glm::quat(2, 0, 0, 0); }), "");
}

}  // namespace
}  // namespace tyndall::scene
