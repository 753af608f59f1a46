// The written file against the glTF 2.0 specification, read by a few lines of our own rather than by the importer.
#include <cstdint>
#include <fstream>
#include <iterator>
#include <set>

#include "gltf_file.hpp"
#include "scene/write_glb.hpp"

namespace tyndall::scene {
namespace {

std::uint32_t word(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

Scene lamps() {
  Scene s;
  Primitive p;
  for (int i = 0; i < 3; ++i) p.vertices.push_back({glm::vec3(i, i * i, 1 - i)});
  p.indices = {0, 1, 2};
  p.material = 0;
  Material m;
  m.emissive = {3, 0, 0};
  m.unlit = true;
  m.baseColorTexture = {0, {0, 0}, {2, 2}, 0};
  s.materials = {m};
  s.images = {{"", 1, 1, {9, 8, 7, 255}}};
  s.textures = {{0, {}}};
  s.meshes = {{"", {p}}};
  s.lights = {{}};
  s.nodes.resize(2);
  s.nodes[0].mesh = 0;
  s.nodes[1].light = 0;
  return s;
}

TEST(GlbFormat, HoldsTheSpecification) {
  TemporaryFolder folder;
  const auto written = writeGlb(lamps(), folder / "a.glb");
  ASSERT_TRUE(written.ok()) << written.error().message;
  std::ifstream file(folder / "a.glb", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  // Section 4.4: header and chunks.
  ASSERT_GT(bytes.size(), 28u);
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(word(bytes, 4), 2u);
  EXPECT_EQ(word(bytes, 8), bytes.size());
  const std::size_t jsonSize = word(bytes, 12);
  EXPECT_EQ(jsonSize % 4, 0u);
  EXPECT_EQ(bytes.substr(16, 4), "JSON");
  const std::size_t binary = 20 + jsonSize;
  EXPECT_EQ(word(bytes, binary) % 4, 0u);
  EXPECT_EQ(bytes.substr(binary + 4, 4), std::string("BIN\0", 4));
  EXPECT_EQ(binary + 8 + word(bytes, binary), bytes.size());
  const auto json = nlohmann::json::parse(bytes.substr(20, jsonSize));

  const std::size_t bufferSize = json["buffers"][0]["byteLength"];
  EXPECT_LE(bufferSize, word(bytes, binary));
  EXPECT_LT(word(bytes, binary) - bufferSize, 4u);
  for (const auto& view : json["bufferViews"]) {
    EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0u);
    EXPECT_LE(view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>(), bufferSize);
  }
  // Section 3.7.2.1: positions state their exact bounds.
  const auto& primitive = json["meshes"][0]["primitives"][0];
  const auto& position = json["accessors"][primitive["attributes"]["POSITION"].get<int>()];
  EXPECT_EQ(position["min"], nlohmann::json({0.0, 0.0, -1.0}));
  EXPECT_EQ(position["max"], nlohmann::json({2.0, 4.0, 1.0}));
  EXPECT_EQ(json["bufferViews"][position["bufferView"].get<int>()]["target"], 34962);
  const auto& indices = json["accessors"][primitive["indices"].get<int>()];
  EXPECT_EQ(json["bufferViews"][indices["bufferView"].get<int>()]["target"], 34963);
  EXPECT_EQ(indices["componentType"], 5123);
  EXPECT_FALSE(json["bufferViews"][json["images"][0]["bufferView"].get<int>()].contains("target"));
  // Every extension object that is present is declared, and nothing else.
  std::set<std::string> used, declared;
  const auto flat = json.flatten();
  for (const auto& item : flat.items()) {
    const std::size_t at = item.key().find("/extensions/");
    if (at == std::string::npos) continue;
    const std::string rest = item.key().substr(at + 12);
    used.insert(rest.substr(0, rest.find('/')));
  }
  for (const auto& name : json["extensionsUsed"]) declared.insert(name.get<std::string>());
  EXPECT_EQ(used, declared);
  EXPECT_EQ(declared, (std::set<std::string>{"KHR_lights_punctual", "KHR_materials_emissive_strength",
                                             "KHR_materials_unlit", "KHR_texture_transform"}));
  // Factors stay within 0..1; the strength carries the rest.
  EXPECT_EQ(json["materials"][0]["emissiveFactor"], nlohmann::json({1.0, 0.0, 0.0}));
  EXPECT_EQ(json["materials"][0]["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"], 3.0);
  // Empty arrays and objects with no meaning are forbidden.
  for (const auto& [key, value] : json.items())
    if (value.is_array()) {
      EXPECT_FALSE(value.empty()) << key;
    }
}

}  // namespace
}  // namespace tyndall::scene
