// Triangles out of every way that glTF has to write them.
#include <cmath>
#include <set>

#include "gltf_file.hpp"

namespace tyndall::scene {
namespace {

/// 3 x 2 grid points in the plane z = 0.
const std::vector<float> kPoints = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 2, 0, 0, 2, 1, 0};

/// Signed area in the xy plane and number of the triangles.
std::pair<double, std::size_t> area(const Scene& s) {
  double sum = 0;
  std::size_t count = 0;
  for (const Mesh& mesh : s.meshes)
    for (const Primitive& p : mesh.primitives)
      for (std::size_t i = 0; i < p.indices.size(); i += 3, ++count) {
        const glm::dvec3 a(p.vertices[p.indices[i]].position), b(p.vertices[p.indices[i + 1]].position),
            c(p.vertices[p.indices[i + 2]].position);
        sum += glm::cross(b - a, c - a).z / 2;
      }
  return {sum, count};
}

TEST(Triangles, StripKeepsOrientation) {
  GltfFile f;
  f.mesh({{"attributes", {{"POSITION", f.floats(kPoints, "VEC3")}}}, {"mode", 5}});
  const auto [signedArea, count] = area(f.scene());
  EXPECT_EQ(count, 4u);
  EXPECT_NEAR(signedArea, -2, 1e-6);  // all four clockwise as seen from +z: areas add up
}

TEST(Triangles, FanKeepsOrientation) {
  GltfFile f;
  f.mesh({{"attributes", {{"POSITION", f.floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3")}}}, {"mode", 6}});
  const auto [signedArea, count] = area(f.scene());
  EXPECT_EQ(count, 2u);
  EXPECT_NEAR(signedArea, 1, 1e-6);
}

TEST(Triangles, PointsAndLinesAreLeftOutWithAWarning) {
  for (const int mode : {0, 1, 2, 3}) {
    GltfFile f;
    f.mesh({{"attributes", {{"POSITION", f.floats(kPoints, "VEC3")}}}, {"mode", mode}});
    auto loaded = f.load();
    ASSERT_TRUE(loaded.ok());
    EXPECT_EQ(area(loaded->scene).second, 0u);
    EXPECT_EQ(loaded->warnings.size(), 1u);
  }
}

template <class T>
void indexed(int componentType) {
  GltfFile f;
  const int position = f.floats(kPoints, "VEC3");
  f.mesh({{"attributes", {{"POSITION", position}}},
          {"indices", f.accessor(std::vector<T>{0, 2, 1, 1, 2, 3, 2, 4, 3, 3, 4, 5}, componentType, "SCALAR", 12)}});
  const auto [signedArea, count] = area(f.scene());
  EXPECT_EQ(count, 4u);
  EXPECT_NEAR(signedArea, 2, 1e-6);
}
TEST(Triangles, IndicesOfEveryType) {
  indexed<std::uint8_t>(5121);
  indexed<std::uint16_t>(5123);
  indexed<std::uint32_t>(5125);
}

TEST(Triangles, MissingNormalsBecomeFlat) {
  GltfFile f;
  // Two triangles at a right angle that share an edge.
  const int position = f.floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, "VEC3");
  f.mesh({{"attributes", {{"POSITION", position}}},
          {"indices", f.accessor(std::vector<std::uint8_t>{0, 1, 2, 0, 2, 3}, 5121, "SCALAR", 6)}});
  const Scene s = f.scene();
  const Primitive& p = s.meshes[0].primitives[0];
  ASSERT_EQ(p.vertices.size(), 6u);
  for (int i = 0; i < 3; ++i) {
    EXPECT_LT(glm::distance(p.vertices[i].normal, glm::vec3(0, 0, 1)), 1e-6f);
    EXPECT_LT(glm::distance(p.vertices[3 + i].normal, glm::vec3(1, 0, 0)), 1e-6f);
  }
}

TEST(Triangles, TangentsFollowTextureCoordinates) {
  GltfFile f;
  const int position = f.floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3"),
            normal = f.floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  // u grows along +y, v along +x: a mirrored layout. glTF: bitangent = cross(normal, tangent) * w.
  const int uv = f.floats({0, 0, 0, 1, 1, 0}, "VEC2");
  f.mesh({{"attributes", {{"POSITION", position}, {"NORMAL", normal}, {"TEXCOORD_0", uv}}}});
  const Scene s = f.scene();
  for (const Vertex& v : s.meshes[0].primitives[0].vertices) {
    EXPECT_LT(glm::distance(glm::vec3(v.tangent), glm::vec3(0, 1, 0)), 1e-6f);
    EXPECT_LT(glm::distance(glm::cross(v.normal, glm::vec3(v.tangent)) * v.tangent.w, glm::vec3(1, 0, 0)), 1e-6f);
  }
}

TEST(Triangles, UnusedVerticesAreDropped) {
  GltfFile f;
  std::vector<float> points(3 * 1000, 7.0f), normals;
  for (int i = 0; i < 1000; ++i) normals.insert(normals.end(), {0, 0, 1});
  for (int i = 0; i < 9; ++i) points[3 * 500 + i] = std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}[i];
  const int position = f.floats(points, "VEC3"), normal = f.floats(normals, "VEC3");
  f.mesh({{"attributes", {{"POSITION", position}, {"NORMAL", normal}}},
          {"indices", f.accessor(std::vector<std::uint16_t>{500, 501, 502}, 5123, "SCALAR", 3)}});
  const Scene s = f.scene();
  EXPECT_EQ(s.meshes[0].primitives[0].vertices.size(), 3u);
  EXPECT_NEAR(area(s).first, 0.5, 1e-6);
  EXPECT_EQ(s.meshes[0].primitives[0].bounds.max, glm::vec3(1, 1, 0));
}

TEST(Accessors, SparseReplacesSomeElements) {
  GltfFile f;
  const int position = f.floats(kPoints, "VEC3");
  const int at = f.accessor(std::vector<std::uint16_t>{1, 4}, 5123, "SCALAR", 2),
            values = f.floats({0, 1, 5, 2, 0, 6}, "VEC3");
  f.json["accessors"][position]["sparse"] = {
      {"count", 2},
      {"indices", {{"bufferView", f.json["accessors"][at]["bufferView"]}, {"componentType", 5123}}},
      {"values", {{"bufferView", f.json["accessors"][values]["bufferView"]}}}};
  f.mesh({{"attributes", {{"POSITION", position}}}});
  const Scene s = f.scene();
  const auto& v = s.meshes[0].primitives[0].vertices;
  EXPECT_EQ(v[0].position, glm::vec3(0, 0, 0));
  EXPECT_EQ(v[1].position, glm::vec3(0, 1, 5));
  EXPECT_EQ(v[4].position, glm::vec3(2, 0, 6));
}

TEST(Accessors, NormalizedIntegersAndStrides) {
  GltfFile f;
  // Shorts with four bytes of stride padding: three shorts and a gap, which glTF wants for alignment.
  const int position =
      f.accessor(std::vector<std::int16_t>{0, 0, 0, 99, 32767, 0, 0, 99, 0, -32768, 0, 99}, 5122, "VEC3", 3, true);
  f.json["bufferViews"][0]["byteStride"] = 8;
  const int color =
      f.accessor(std::vector<std::uint8_t>{255, 0, 51, 255, 255, 255, 255, 255, 0, 0, 0, 0}, 5121, "VEC4", 3, true);
  const int uv = f.accessor(std::vector<std::uint16_t>{0, 65535, 13107, 0, 0, 0}, 5123, "VEC2", 3, true);
  f.mesh({{"attributes", {{"POSITION", position}, {"COLOR_0", color}, {"TEXCOORD_0", uv}}}});
  const Scene s = f.scene();
  const auto& v = s.meshes[0].primitives[0].vertices;
  EXPECT_EQ(v[1].position, glm::vec3(1, 0, 0));
  EXPECT_EQ(v[2].position, glm::vec3(0, -1, 0));  // -32768 and -32767 are both -1
  EXPECT_LT(glm::distance(v[0].color, glm::vec4(1, 0, 0.2f, 1)), 1e-6f);
  EXPECT_LT(glm::distance(v[0].uv, glm::vec2(0, 1)), 1e-6f);
  EXPECT_NEAR(v[1].uv.x, 0.2, 1e-6);
}

TEST(Scenes, DefaultFirstOrAllRoots) {
  const auto names = [](GltfFile& f) {
    std::set<std::string> out;
    for (const Node& n : f.scene().nodes) out.insert(n.name);
    return out;
  };
  GltfFile f;
  f.json["nodes"] = {{{"name", "a"}, {"children", {1}}}, {{"name", "b"}}, {{"name", "c"}}};
  EXPECT_EQ(names(f), (std::set<std::string>{"a", "b", "c"}));
  f.json["scenes"] = {{{"nodes", {2}}}, {{"nodes", {0}}}};
  EXPECT_EQ(names(f), (std::set<std::string>{"c"}));
  f.json["scene"] = 1;
  EXPECT_EQ(names(f), (std::set<std::string>{"a", "b"}));
}

TEST(Scenes, DeepTreesNeedNoStack) {
  GltfFile f;
  constexpr int kDepth = 100'000;
  for (int i = 0; i < kDepth; ++i) {
    f.json["nodes"].push_back({{"translation", {1, 0, 0}}});
    if (i + 1 < kDepth) f.json["nodes"].back()["children"] = {i + 1};
  }
  const Scene s = f.scene();
  ASSERT_EQ(s.nodes.size(), static_cast<std::size_t>(kDepth));
  EXPECT_FLOAT_EQ(worldMatrices(s, 0).back()[3].x, kDepth);
}

}  // namespace
}  // namespace tyndall::scene
