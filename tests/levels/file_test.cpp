// The .glb files: there, sound, small enough, and the same bytes each time.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "levels/levels.hpp"
#include "scene/check.hpp"
#include "scene/gltf.hpp"
#include "scene/write_glb.hpp"

namespace tyndall::levels {
namespace {

namespace fs = std::filesystem;

fs::path builtFile(const std::string& name) { return fs::path(TYNDALL_BIN_DIR) / "levels" / (name + ".glb"); }

std::string bytesOf(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class File : public testing::TestWithParam<const char*> {
 protected:
  static scene::Scene made() {
    for (const Sample& sample : kSamples)
      if (GetParam() == std::string(sample.name)) return sample.make();
    return {};
  }
};

TEST_P(File, LoadsWithoutAWordOfWarningAndHoldsWhatWasMade) {
  const auto import = scene::loadGltf(builtFile(GetParam()));
  ASSERT_TRUE(import) << import.error().message;
  EXPECT_TRUE(import->warnings.empty()) << import->warnings.front();
  const scene::Scene& loaded = import->scene;
  const auto sound = scene::checkScene(loaded);
  EXPECT_TRUE(sound) << sound.error().message;
  const scene::Scene expected = made();
  EXPECT_EQ(loaded.nodes.size(), expected.nodes.size());
  EXPECT_EQ(loaded.meshes.size(), expected.meshes.size());
  EXPECT_EQ(loaded.materials.size(), expected.materials.size());
  EXPECT_EQ(loaded.images.size(), expected.images.size());
  EXPECT_EQ(loaded.cameras.size(), 4u);
  ASSERT_EQ(loaded.lights.size(), expected.lights.size());
  for (std::size_t i = 0; i < loaded.lights.size(); ++i) {
    const scene::Light &a = loaded.lights[i], &b = expected.lights[i];
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.intensity, b.intensity);
    EXPECT_EQ(a.range, b.range);
    EXPECT_EQ(a.cookie.has_value(), b.cookie.has_value());
    if (b.kind == scene::LightKind::kSpot) {
      EXPECT_EQ(a.innerConeAngle, b.innerConeAngle);
      EXPECT_EQ(a.outerConeAngle, b.outerConeAngle);
    }
  }
  ASSERT_EQ(loaded.animations.size(), 1u);
  EXPECT_EQ(loaded.animations[0].channels.size(), expected.animations[0].channels.size());
  EXPECT_EQ(instancedTriangles(loaded), instancedTriangles(expected));
}

TEST_P(File, KeepsItsBudgets) {
  EXPECT_LE(fs::file_size(builtFile(GetParam())), 12u << 20);
  const scene::Scene scene = made();
  EXPECT_LE(instancedTriangles(scene), 250'000u);
  EXPECT_GE(instancedTriangles(scene), 40'000u);  // a level, not a box
  EXPECT_LE(scene.nodes.size(), 400u);            // draws of a frame that culls nothing
}

TEST_P(File, IsTheSameEveryTime) {
  const fs::path again = fs::path(testing::TempDir()) / (std::string("levels_again_") + GetParam() + ".glb");
  const auto written = scene::writeGlb(made(), again);
  ASSERT_TRUE(written) << written.error().message;
  EXPECT_TRUE(bytesOf(again) == bytesOf(builtFile(GetParam())));
  fs::remove(again);
}

TEST_P(File, EveryVertexIsShadeable) {
  const scene::Scene scene = made();
  for (const scene::Mesh& mesh : scene.meshes) {
    SCOPED_TRACE(mesh.name);
    for (const scene::Primitive& primitive : mesh.primitives) {
      ASSERT_FALSE(primitive.indices.empty());
      std::size_t bad = 0;
      for (const scene::Vertex& v : primitive.vertices) {
        const glm::vec3 t(v.tangent);
        // Written so that a NaN counts as bad.
        const bool good = glm::abs(glm::length(v.normal) - 1) < 1e-4f && glm::abs(glm::length(t) - 1) < 1e-4f &&
                          glm::abs(glm::dot(t, v.normal)) < 1e-3f && glm::abs(v.tangent.w) == 1.0f &&
                          glm::all(glm::lessThanEqual(v.color, glm::vec4(1))) && v.color.a == 1.0f;
        bad += good ? 0 : 1;
      }
      EXPECT_EQ(bad, 0u);
      for (const std::uint32_t index : primitive.indices) ASSERT_LT(index, primitive.vertices.size());
    }
  }
}

/// Fronts face the way normals point (foliage too: its cards are turned to their bent normals), and the tangent frame
/// follows the image: tangent to increasing u, bitangent against increasing v.
TEST_P(File, WindingNormalsAndTangentsAgree) {
  const scene::Scene scene = made();
  for (const scene::Mesh& mesh : scene.meshes) {
    SCOPED_TRACE(mesh.name);
    for (const scene::Primitive& p : mesh.primitives) {
      std::size_t turned = 0, mirrored = 0;
      for (std::size_t i = 0; i + 2 < p.indices.size(); i += 3) {
        const scene::Vertex &a = p.vertices[p.indices[i]], &b = p.vertices[p.indices[i + 1]],
                            &c = p.vertices[p.indices[i + 2]];
        const glm::vec3 e1 = b.position - a.position, e2 = c.position - a.position;
        const glm::vec3 front = glm::cross(e1, e2);
        turned += glm::dot(front, a.normal + b.normal + c.normal) > 0 ? 0 : 1;
        const glm::vec2 d1 = b.uv - a.uv, d2 = c.uv - a.uv;
        const float area = d1.x * d2.y - d2.x * d1.y;
        if (glm::abs(area) < 1e-9f) continue;
        const glm::vec3 alongU = (e1 * d2.y - e2 * d1.y) / area, alongV = (e2 * d1.x - e1 * d2.x) / area;
        const glm::vec3 bitangent = glm::cross(a.normal, glm::vec3(a.tangent)) * a.tangent.w;
        mirrored += glm::dot(glm::vec3(a.tangent), alongU) > 0 && glm::dot(bitangent, alongV) < 0 ? 0 : 1;
      }
      const std::size_t triangles = p.indices.size() / 3;
      EXPECT_LE(turned, triangles / 100) << "of " << triangles;
      EXPECT_LE(mirrored, triangles / 50) << "of " << triangles;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Levels, File,
                         testing::Values("hall", "forest", "vault", "cage", "terrain", "tower", "town", "lattice"));

}  // namespace
}  // namespace tyndall::levels
