// Materials, their extensions, and textures.
#include "gltf_file.hpp"
#include "scene/write_glb.hpp"

namespace tyndall::scene {
namespace {

Material one(const nlohmann::json& material) {
  GltfFile f;
  f.triangle();
  f.json["materials"] = {material};
  const Scene s = f.scene();
  return s.materials.empty() ? Material{} : s.materials[0];
}

TEST(Materials, DefaultsAreThoseOfGltf) {
  const Material m = one(nlohmann::json::object());
  EXPECT_EQ(m.baseColor, glm::vec4(1));
  EXPECT_EQ(m.metallic, 1);
  EXPECT_EQ(m.roughness, 1);
  EXPECT_EQ(m.emissive, glm::vec3(0));
  EXPECT_EQ(m.alphaMode, AlphaMode::kOpaque);
  EXPECT_EQ(m.alphaCutoff, 0.5f);
  EXPECT_FALSE(m.doubleSided);
  EXPECT_FALSE(m.unlit);
}

TEST(Materials, Extensions) {
  EXPECT_TRUE(one({{"extensions", {{"KHR_materials_unlit", nlohmann::json::object()}}}}).unlit);
  EXPECT_EQ(one({{"emissiveFactor", {1, 0.5, 0}},
                 {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 6}}}}}})
                .emissive,
            glm::vec3(6, 3, 0));
  const Material glossy = one({{"extensions",
                                {{"KHR_materials_pbrSpecularGlossiness",
                                  {{"diffuseFactor", {0.1, 0.2, 0.3, 0.4}}, {"glossinessFactor", 0.75}}}}}});
  EXPECT_EQ(glossy.baseColor, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
  EXPECT_EQ(glossy.metallic, 0);
  EXPECT_FLOAT_EQ(glossy.roughness, 0.25f);
}

TEST(Materials, FactorsOutsideTheirRangeAreRepairedWithAWarning) {
  GltfFile f;
  f.triangle();
  f.json["materials"] = {
      {{"pbrMetallicRoughness", {{"roughnessFactor", 1.5}, {"metallicFactor", -1}}}, {"alphaCutoff", -0.5}}};
  const auto loaded = f.load();
  ASSERT_TRUE(loaded.ok()) << loaded.error().message;
  EXPECT_EQ(loaded->scene.materials[0].roughness, 1);
  EXPECT_EQ(loaded->scene.materials[0].metallic, 0);
  EXPECT_EQ(loaded->scene.materials[0].alphaCutoff, 0);
  EXPECT_EQ(loaded->warnings.size(), 3u);
}

/// A .glb's image bytes are borrowed from writeGlb, so that no PNG has to be written by hand.
TEST(Textures, OnlyShownImagesAreKept) {
  Scene s;
  s.images = {{"a", 1, 1, {1, 2, 3, 255}}, {"b", 1, 1, {4, 5, 6, 255}}};
  s.textures = {{0, {}}, {1, {}}};
  Material m;
  m.baseColorTexture = {1};
  s.materials = {m};
  TemporaryFolder folder;
  ASSERT_TRUE(writeGlb(s, folder / "a.glb").ok());
  const auto loaded = loadGltf(folder / "a.glb");
  ASSERT_TRUE(loaded.ok()) << loaded.error().message;
  ASSERT_EQ(loaded->scene.images.size(), 1u);
  EXPECT_EQ(loaded->scene.images[0].name, "b");
  EXPECT_EQ(loaded->scene.materials[0].baseColorTexture.texture, 0);
}

TEST(Textures, SecondTextureCoordinates) {
  GltfFile f;
  const int position = f.floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3"), uv0 = f.floats({0, 0, 0, 0, 0, 0}, "VEC2"),
            uv1 = f.floats({0, 1, 2, 3, 4, 5}, "VEC2");
  f.mesh({{"attributes", {{"POSITION", position}, {"TEXCOORD_0", uv0}, {"TEXCOORD_1", uv1}}}, {"material", 0}});
  // A one-pixel PNG from the PNG specification's minimum: made by the writer below.
  Scene pixel;
  pixel.images = {{"", 1, 1, {7, 7, 7, 255}}};
  pixel.textures = {{0, {}}};
  Material shown;
  shown.baseColorTexture = {0};
  pixel.materials = {shown};
  ASSERT_TRUE(writeGlb(pixel, f.folder / "pixel.glb").ok());
  std::ifstream in(f.folder / "pixel.glb", std::ios::binary);
  const std::string glb{std::istreambuf_iterator<char>(in), {}};
  f.folder.write("pixel.png", glb.substr(glb.find("\x89PNG")));
  f.json["images"] = {{{"uri", "pixel.png"}}};
  f.json["textures"] = {{{"source", 0}}};
  f.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}, {"texCoord", 1}}}}}}};
  const Scene s = f.scene();
  const auto& v = s.meshes[0].primitives[0].vertices;
  EXPECT_EQ(v[1].uv, glm::vec2(2, 3));
  EXPECT_EQ(v[2].uv, glm::vec2(4, 5));
  // The transform's own choice of coordinates wins (KHR_texture_transform).
  f.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"] = {
      {"texCoord", 0}, {"offset", {0.5, 0.25}}, {"scale", {2, 3}}, {"rotation", 0.5}};
  const Scene moved = f.scene();
  EXPECT_EQ(moved.meshes[0].primitives[0].vertices[2].uv, glm::vec2(0));
  EXPECT_EQ(moved.materials[0].baseColorTexture.offset, glm::vec2(0.5f, 0.25f));
  EXPECT_EQ(moved.materials[0].baseColorTexture.scale, glm::vec2(2, 3));
  EXPECT_EQ(moved.materials[0].baseColorTexture.rotation, 0.5f);
}

}  // namespace
}  // namespace tyndall::scene
