// Alpha-masked surfaces: where they are, by the distances a camera sees, and the light they let through.
#include "level.hpp"

using namespace truth_test;

namespace {

constexpr float kSide = 4;  ///< of the masked quad, metres

/// A level with a masked quad on z = 0, x and y in [0, 4], whose uv is (x, y) / 4 (v upwards).
struct Masked {
  scene::Scene level;
  scene::Material material;

  Masked(std::uint32_t width, std::uint32_t height, const std::vector<std::uint8_t>& alphas) {
    scene::Image image{"alpha", width, height, {}};
    for (const std::uint8_t alpha : alphas) image.rgba.insert(image.rgba.end(), {255, 255, 255, alpha});
    level.images.push_back(image);
    level.textures.push_back({0, {}});
    material.alphaMode = scene::AlphaMode::kMask;
    material.baseColorTexture.texture = 0;
    material.doubleSided = true;
  }
  scene::Primitive& addToLevel() { return addQuad(level, {0, 0, 0}, {kSide, 0, 0}, {0, kSide, 0}, material); }
  scene::Sampler& sampler() { return level.textures[0].sampler; }

  /// Whether the surface is there at uv: one ray straight at it.
  bool solid(double u, double v) const {
    const glm::vec3 eye(kSide * u, kSide * v, 1);
    const auto picture = rendered(level, cameraAt(eye, {0, 0, -1}), {}, onePixel({0, 1, 0}));
    return picture.distance[0] < 2;
  }
};

}  // namespace

// Two texels, alpha 1 and 0: bilinear between their centres at u = 1/4 and 3/4, so that a cutoff of 1/4 is crossed at
// u = 5/8 and, round the edge with repeat, at 7/8.
TEST(TruthMask, isBilinearWithRepeat) {
  Masked masked(2, 1, {255, 0});
  masked.material.alphaCutoff = 0.25f;
  masked.addToLevel();
  for (const double u : {0.01, 0.3, 0.5, 0.61, 0.89, 0.99}) EXPECT_TRUE(masked.solid(u, 0.3)) << u;
  for (const double u : {0.64, 0.75, 0.86}) EXPECT_FALSE(masked.solid(u, 0.3)) << u;
}

TEST(TruthMask, clampsToTheEdge) {
  Masked masked(2, 1, {255, 0});
  masked.material.alphaCutoff = 0.25f;
  masked.sampler().wrapU = scene::Wrap::kClampToEdge;
  masked.addToLevel();
  EXPECT_TRUE(masked.solid(0.61, 0.3));
  for (const double u : {0.64, 0.86, 0.99}) EXPECT_FALSE(masked.solid(u, 0.3)) << u;
}

TEST(TruthMask, mirrors) {
  Masked masked(2, 1, {255, 0});
  masked.sampler().wrapU = scene::Wrap::kMirroredRepeat;
  masked.material.baseColorTexture.scale = {4, 1};  // two periods of the mirror
  masked.material.baseColorTexture.offset = {-2, 0};
  masked.addToLevel();
  // In periods of 1/4: solid|hole, hole|solid, and again.
  for (const double u : {0.05, 0.45, 0.55, 0.95}) EXPECT_TRUE(masked.solid(u, 0.3)) << u;
  for (const double u : {0.2, 0.3, 0.7, 0.8}) EXPECT_FALSE(masked.solid(u, 0.3)) << u;
}

TEST(TruthMask, nearestSamplerShowsTexels) {
  Masked masked(2, 1, {255, 0});
  masked.material.alphaCutoff = 0.25f;
  masked.sampler().magnify = scene::Filter::kNearest;
  masked.addToLevel();
  for (const double u : {0.01, 0.49}) EXPECT_TRUE(masked.solid(u, 0.3)) << u;
  for (const double u : {0.51, 0.61, 0.99}) EXPECT_FALSE(masked.solid(u, 0.3)) << u;
}

TEST(TruthMask, multipliesFactorAndVertexAlpha) {
  Masked masked(1, 1, {204});  // 0.8
  masked.material.baseColor.a = 0.9f;
  scene::Primitive& quad = masked.addToLevel();
  for (scene::Vertex& vertex : quad.vertices) vertex.color.a = vertex.uv.x;  // 0.72 u against 0.5: u = 0.694
  EXPECT_FALSE(masked.solid(0.68, 0.5));
  EXPECT_TRUE(masked.solid(0.71, 0.5));
  EXPECT_TRUE(masked.solid(0.71, 0.9));
}

TEST(TruthMask, alphaEqualToTheCutoffIsSolid) {
  Masked masked(1, 1, {255});
  masked.material.baseColor.a = 0.5f;
  masked.addToLevel();
  EXPECT_TRUE(masked.solid(0.3, 0.6));
}

// The extension's own example (offset 0,1, a quarter turn, scale 1/2) "utilizes only the lower left quadrant of the
// image": row 1, column 0 of 2x2.
TEST(TruthMask, textureTransformTurnsAsTheExtensionsExample) {
  Masked masked(2, 2, {0, 0, 255, 0});
  masked.sampler().magnify = scene::Filter::kNearest;
  masked.material.baseColorTexture.offset = {0, 1};
  masked.material.baseColorTexture.scale = {0.5f, 0.5f};
  masked.material.baseColorTexture.rotation = std::numbers::pi_v<float> / 2;
  masked.addToLevel();
  for (const double u : {0.1, 0.5, 0.9})
    for (const double v : {0.1, 0.5, 0.9}) EXPECT_TRUE(masked.solid(u, v)) << u << " " << v;
}

// A chequered roof of 8x8 fields, under which the ray walks diagonally to the rows: light and shade by turns.
TEST(TruthMask, chequeredRoofLetsLightThrough) {
  Masked masked(2, 2, {255, 0, 0, 255});
  masked.sampler().magnify = scene::Filter::kNearest;
  masked.material.baseColorTexture.scale = {4, 4};
  addQuad(masked.level, {0, 5, 0}, {16, 0, 0}, {0, 0, 16}, masked.material);  // fields of 2 m; uv along x and z
  const auto sun = sunAlong({0, -1, 0});
  const auto camera = cameraAt({-1, 1, 1}, {1, 0, 0}, 1, 0.1f, 25);  // first row: solid over x in [0,2], [4,6], ...
  const double sigma = 0.08;
  double length = fog(sigma, 0, 25);
  for (int i = 0; i < 4; ++i) length -= fog(sigma, 4 * i + 1, 4 * i + 3);
  const double right = sigma * henyeyGreenstein(0.2, 0) * length;
  const auto picture = rendered(masked.level, camera, {sun}, onePixel({sigma, 1, 0.2}, 8192));
  EXPECT_NEAR(picture.scatter[0].r, right, 1e-3 * right);
}
