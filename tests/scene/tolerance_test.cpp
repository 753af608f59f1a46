// One bad part does not lose the level: what is repaired, what is left out, and that one line says how often.
#include <cmath>
#include <cstdio>

#include <jpeglib.h>

#include "gltf_file.hpp"

namespace tyndall::scene {
namespace {

/// A square of two triangles in the plane z = 0 with normals; each attribute may be edited before it is written.
struct Square : GltfFile {
  std::vector<float> positions{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, normals{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
  std::vector<std::uint16_t> indices{0, 1, 2, 0, 2, 3};
  Import import() {
    mesh({{"attributes", {{"POSITION", floats(positions, "VEC3")}, {"NORMAL", floats(normals, "VEC3")}}},
          {"indices", accessor(indices, 5123, "SCALAR", indices.size())}});
    auto loaded = load();
    EXPECT_TRUE(loaded.ok()) << (loaded.ok() ? "" : loaded.error().message);
    return loaded.ok() ? loaded.take() : Import{};
  }
};

TEST(Tolerance, NormalsThatAreNoNumbersAreRepairedLikeZeroOnes) {
  Square square;
  square.normals[0] = NAN;
  square.normals[5] = INFINITY;
  const Import loaded = square.import();
  ASSERT_EQ(loaded.scene.meshes.size(), 1u);
  for (const Vertex& v : loaded.scene.meshes[0].primitives[0].vertices)
    EXPECT_LT(glm::distance(v.normal, glm::vec3(0, 0, 1)), 1e-5f);
  ASSERT_FALSE(loaded.warnings.empty());
  EXPECT_NE(loaded.warnings.back().find("2, the first"), std::string::npos) << loaded.warnings.back();
}

TEST(Tolerance, TrianglesWithoutAPlaceAreLeftOutAndCounted) {
  Square beyond;
  beyond.indices[5] = 4;
  const Import one = beyond.import();
  ASSERT_EQ(one.scene.meshes[0].primitives[0].indices.size(), 3u);
  EXPECT_NE(one.warnings.back().find("indices[5] is 4; there are 4 vertices"), std::string::npos);
  Square nowhere;
  nowhere.positions[9] = NAN;
  const Import other = nowhere.import();
  ASSERT_EQ(other.scene.meshes[0].primitives[0].indices.size(), 3u);
  EXPECT_TRUE(std::isfinite(other.scene.meshes[0].primitives[0].bounds.max.x));
  EXPECT_NE(other.warnings.back().find("element 3 is not finite"), std::string::npos);
}

TEST(Tolerance, WhatNobodyUsesMayBeEmpty) {
  Square square;
  square.import();  // writes data.bin
  square.json["accessors"].push_back({{"componentType", 5126}, {"type", "VEC3"}, {"count", 0}});
  square.json["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 0}});
  square.json["buffers"] = {{{"uri", "data.bin"}, {"byteLength", square.bytes.size()}},
                            {{"uri", "data:"}, {"byteLength", 0}}};
  const auto loaded = square.load();
  ASSERT_TRUE(loaded.ok()) << loaded.error().message;
  EXPECT_EQ(loaded->scene.meshes[0].primitives[0].indices.size(), 6u);
  EXPECT_TRUE(loaded->warnings.empty()) << loaded->warnings[0];
}

TEST(Tolerance, MembersOfAnotherTypeAreAsIfTheyWereNotThere) {
  Square square;
  square.import();
  square.json["nodes"][0]["name"] = nullptr;
  square.json["meshes"][0]["name"] = 7;
  square.json["materials"] = {{{"doubleSided", "yes"}, {"alphaMode", 3}}, {{"name", nullptr}}};
  square.json["animations"] = {
      {{"samplers", {{{"input", 0}, {"output", 0}, {"interpolation", 9728}}}}, {"channels", nlohmann::json::array()}}};
  const auto loaded = square.load();
  ASSERT_TRUE(loaded.ok()) << loaded.error().message;
  EXPECT_EQ(loaded->scene.meshes[0].primitives[0].indices.size(), 6u);
  EXPECT_FALSE(loaded->scene.materials[0].doubleSided);
  ASSERT_EQ(loaded->warnings.size(), 1u);
  EXPECT_TRUE(loaded->warnings[0].starts_with("broken values: 6, the first ")) << loaded->warnings[0];
}

TEST(Tolerance, ABrokenLightOrCameraIsNotThere) {
  GltfFile file;
  file.triangle();
  file.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "laser"}}, {{"type", "point"}}};
  file.json["cameras"] = {{{"type", "perspective"}},
                          {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
  for (const int i : {0, 1})
    file.json["nodes"].push_back({{"camera", i}, {"extensions", {{"KHR_lights_punctual", {{"light", i}}}}}});
  file.json["scenes"][0]["nodes"] = {0, 1, 2};
  const auto loaded = file.load();
  ASSERT_TRUE(loaded.ok()) << loaded.error().message;
  EXPECT_EQ(placedLights(loaded->scene, 0).size(), 1u);
  EXPECT_EQ(placedCameras(loaded->scene, 0).size(), 1u);
  EXPECT_EQ(loaded->warnings.size(), 2u);
}

/// A JPEG of one colour in four inks, each 0 (none) to 255, as Adobe's programs store it or plainly.
std::string inksJpeg(const unsigned char (&inks)[4], bool adobe) {
  jpeg_compress_struct encoder;
  jpeg_error_mgr errors;
  encoder.err = jpeg_std_error(&errors);
  jpeg_create_compress(&encoder);
  unsigned char* memory = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&encoder, &memory, &size);
  encoder.image_width = encoder.image_height = 16;
  encoder.input_components = 4;
  encoder.in_color_space = JCS_CMYK;
  jpeg_set_defaults(&encoder);
  jpeg_set_quality(&encoder, 100, TRUE);
  encoder.write_Adobe_marker = adobe ? TRUE : FALSE;
  jpeg_start_compress(&encoder, TRUE);
  std::vector<unsigned char> row(16 * 4);
  for (std::size_t i = 0; i < row.size(); ++i)
    row[i] = static_cast<unsigned char>(adobe ? 255 - inks[i % 4] : inks[i % 4]);
  JSAMPROW rows = row.data();
  while (encoder.next_scanline < 16) jpeg_write_scanlines(&encoder, &rows, 1);
  jpeg_finish_compress(&encoder);
  std::string out(reinterpret_cast<char*>(memory), size);
  jpeg_destroy_compress(&encoder);
  std::free(memory);
  return out;
}

TEST(Tolerance, InksOfAJpegBecomeColours) {
  for (const bool adobe : {false, true}) {
    GltfFile file;
    file.triangle();
    file.folder.write("inks.jpg", inksJpeg({255, 0, 128, 51}, adobe));  // cyan, half yellow, a fifth black
    file.json["images"] = {{{"uri", "inks.jpg"}}};
    file.json["textures"] = {{{"source", 0}}};
    file.json["materials"] = {{{"emissiveTexture", {{"index", 0}}}}};
    const Scene scene = file.scene();
    ASSERT_EQ(scene.images.size(), 1u) << adobe;
    EXPECT_NEAR(scene.images[0].rgba[0], 0, 2) << adobe;
    EXPECT_NEAR(scene.images[0].rgba[1], 204, 2) << adobe;
    EXPECT_NEAR(scene.images[0].rgba[2], 102, 2) << adobe;
    EXPECT_EQ(scene.images[0].rgba[3], 255) << adobe;
  }
}

TEST(Tolerance, ManyOfAKindAreOneLine) {
  GltfFile file;
  file.triangle();
  for (int i = 0; i < 60; ++i) {
    file.json["images"].push_back({{"uri", "gone" + std::to_string(i) + ".png"}});
    file.json["textures"].push_back({{"source", i}});
    file.json["materials"].push_back({{"emissiveTexture", {{"index", i}}}});
  }
  const auto loaded = file.load();
  ASSERT_TRUE(loaded.ok()) << loaded.error().message;
  ASSERT_EQ(loaded->warnings.size(), 1u);
  EXPECT_TRUE(loaded->warnings[0].starts_with("textures without a usable image: 60, the first images[0] \"gone0.png\""))
      << loaded->warnings[0];
}

}  // namespace
}  // namespace tyndall::scene
