// Geometry, materials and output of the frame.
#include "stage.hpp"

namespace tyndall::render::test {
namespace {

using SurfaceTest = FrameTest;

scene::Material unlit(const glm::vec4& color, scene::AlphaMode mode = scene::AlphaMode::kOpaque) {
  scene::Material m;
  m.baseColor = color;
  m.unlit = true;
  m.alphaMode = mode;
  return m;
}

TEST_F(SurfaceTest, DistanceIsAlongTheRay) {
  Level level;
  level.quad({0, 0, 0}, {500, 0, 0}, {0, 0, -500}, level.material(Level::grey(128)));
  const scene::CameraView camera = lookAt({1, 3, 2}, {4, 1, -6}, 1.1f, 60);
  Stage::Options options;
  options.width = 96;
  options.height = 48;
  const Shot shot = stage().render(level.scene, camera, {}, options);
  const glm::dmat4 pose(camera.worldFromView);
  const double tangent = std::tan(0.55);
  int floor = 0, sky = 0;
  for (std::uint32_t y = 0; y < shot.height; ++y) {
    for (std::uint32_t x = 0; x < shot.width; ++x) {
      const glm::dvec3 inView(((x + 0.5) / 48 - 1) * tangent * 2, (1 - (y + 0.5) / 24) * tangent, -1);
      const glm::dvec3 ray(pose * glm::dvec4(inView, 0));  // one metre along the axis
      const double steps = ray.y < 0 ? 3 / -ray.y : 1e9;
      const double expected = std::min(steps, 60.0) * glm::length(inView);
      ASSERT_NEAR(shot.distance[y * shot.width + x], expected, 2e-4 * expected) << x << "," << y;
      (steps < 60 ? floor : sky)++;
    }
  }
  EXPECT_GT(floor, 500);
  EXPECT_GT(sky, 500);
}

TEST_F(SurfaceTest, CutOutsAndTheirShadowsAgree) {
  Level level;
  level.quad({0, 0, 0}, {8, 0, 0}, {0, 0, -8}, level.material(Level::grey(188)));
  scene::Image image{"half", 64, 1, {}};
  for (int x = 0; x < 64; ++x) {
    for (const int v : {255, 255, 255, x < 32 ? 0 : 255}) image.rgba.push_back(static_cast<std::uint8_t>(v));
  }
  level.scene.images.push_back(image);
  scene::Texture texture;
  texture.image = 0;
  texture.sampler.wrapU = scene::Wrap::kClampToEdge;
  level.scene.textures.push_back(texture);
  scene::Material leaf = Level::grey(188);
  leaf.alphaMode = scene::AlphaMode::kMask;
  leaf.doubleSided = true;
  leaf.baseColorTexture.texture = 0;
  level.quad({0, 1, 0}, {1, 0, 0}, {0, 0, -1}, level.material(leaf));  // its left half is a hole
  const scene::CameraView camera = lookAt({0, 5, 0.01f}, {0, 0, 0}, 1.3f);
  const Shot shot = stage().render(level.scene, camera, {sun({2, -1, 0}, 10)});
  const auto distanceAt = [&](const glm::vec3& p) {
    const glm::ivec2 q = pixelOf(camera, shot, p);
    return shot.distance[static_cast<std::size_t>(q.y) * shot.width + static_cast<std::size_t>(q.x)];
  };
  EXPECT_NEAR(distanceAt({-0.5f, 1, 0}), 5.03, 0.05) << "through the hole to the floor";
  EXPECT_NEAR(distanceAt({0.5f, 1, 0}), 4.03, 0.05) << "on the leaf";
  // One metre higher, the shadow lies 2 m to the right: hole at 1..2, leaf at 2..3 (the camera sees the floor
  // beyond 1.25).
  const float litFloor = radianceAt(camera, shot, {-1.5f, 0, 0}).r;
  EXPECT_NEAR(radianceAt(camera, shot, {1.6f, 0, 0}).r, litFloor, 0.02f * litFloor);
  EXPECT_LT(radianceAt(camera, shot, {2.5f, 0, 0}).r, 0.4f * litFloor);
}

// Palette textures give each face one texel; a triangle's edges must not see others through a wrong choice of mip
// level.
TEST_F(SurfaceTest, ConstantTextureCoordinatesGiveOneColor) {
  Level level;
  scene::Image image{"palette", 64, 64, {}};
  for (int i = 0; i < 64 * 64; ++i) {
    const bool red = i % 64 / 8 == 2 && i / 64 / 8 == 2;
    for (const int v : {red ? 255 : 0, 0, red ? 0 : 255, 255}) image.rgba.push_back(static_cast<std::uint8_t>(v));
  }
  level.scene.images.push_back(image);
  level.scene.textures.push_back({0, {}});
  scene::Material m;
  m.baseColorTexture.texture = 0;
  level.quad({0, 0, -5}, {9, 0, 0}, {0, 9, 0}, level.material(m));
  for (scene::Vertex& v : level.scene.meshes[0].primitives[0].vertices) v.uv = glm::vec2(20.0f / 64);
  Stage::Options options;
  options.settings.debugView = "base_color";
  const Shot shot = stage().render(level.scene, lookAt({0, 0, 0}, {0, 0, -1}), {}, options);
  for (const glm::u8vec4& p : shot.picture) ASSERT_EQ(p, glm::u8vec4(255, 0, 0, 255));
}

TEST_F(SurfaceTest, BlendedSurfacesAreDrawnBackToFront) {
  Level level;
  level.quad({0, 0, -5}, {9, 0, 0}, {0, 9, 0}, level.material(unlit({0, 0, 1, 1})));
  const std::int32_t red = level.material(unlit({1, 0, 0, 0.5f}, scene::AlphaMode::kBlend));
  const std::int32_t green = level.material(unlit({0, 1, 0, 0.25f}, scene::AlphaMode::kBlend));
  const std::int32_t hidden = level.material(unlit({1, 1, 1, 1}, scene::AlphaMode::kBlend));
  level.quad({0, 0, -2}, {1, 0, 0}, {0, 1, 0}, red);  // nearer, declared first
  level.quad({0, 0, -3}, {1, 0, 0}, {0, 1, 0}, green);
  level.quad({0, 0, -6}, {1, 0, 0}, {0, 1, 0}, hidden);  // behind the opaque wall
  const Shot shot = stage().render(level.scene, lookAt({0, 0, 0}, {0, 0, -1}), {sun({0, -1, -1}, 5)});
  const glm::vec4 middle = shot.at(32, 32);
  EXPECT_NEAR(middle.r, 0.5, 1e-3);
  EXPECT_NEAR(middle.g, 0.5 * 0.25, 1e-3);
  EXPECT_NEAR(middle.b, 0.5 * 0.75, 1e-2);
  EXPECT_NEAR(middle.a, 1, 1e-6);
}

TEST_F(SurfaceTest, BlendedSurfacesAreLitLikeOpaqueOnes) {
  for (const bool roof : {false, true}) {
    glm::vec4 color[2];
    for (const bool blend : {false, true}) {
      Level level;
      scene::Material m = Level::grey(188);
      m.alphaMode = blend ? scene::AlphaMode::kBlend : scene::AlphaMode::kOpaque;
      level.quad({0, 0, 0}, {4, 0, 0}, {0, 0, -4}, level.material(m));
      if (roof)
        level.quad({0, 6, 0}, {2, 0, 0}, {0, 0, -2}, level.material(Level::grey(10)));
      else
        level.quad({0, 6, 90}, {1, 0, 0}, {0, 0, -1}, level.material(Level::grey(10)));
      color[blend] =
          stage()
              .render(level.scene, lookAt({0, 3, 4}, {0, 0, 0}), {sun({0, -1, 0}, 10), pointLight({1, 2, 1}, 3)})
              .at(32, 32);
    }
    // The G-buffer holds sRGB codes; software devices decode them 0.14 percent off.
    EXPECT_NEAR(color[0].r, color[1].r, 2e-3 * color[0].r) << (roof ? "in shadow" : "lit");
  }
}

TEST_F(SurfaceTest, BackFacesAreInvisibleButCastShadows) {
  Level level;
  level.quad({0, 0, 0}, {6, 0, 0}, {0, 0, -6}, level.material(Level::grey(188)));
  level.quad({0, 2, 0}, {1, 0, 0}, {0, 0, 1}, level.material(Level::grey(188)));  // faces down
  const scene::CameraView camera = lookAt({0, 6, 0.01f}, {0, 0, 0});
  const Shot shot = stage().render(level.scene, camera, {sun({0, -1, 0}, 10)});
  EXPECT_NEAR(shot.distance[32 * 64 + 32], 6, 0.1) << "the camera looks through the back face";
  EXPECT_LT(radianceAt(camera, shot, {0.3f, 0, 0.3f}).r, 0.4f * radianceAt(camera, shot, {-2, 0, -1.5f}).r);
}

TEST_F(SurfaceTest, MirroredAndDoubleSidedSurfacesShowTheirFront) {
  for (const bool doubleSided : {false, true}) {
    Level level;
    scene::Material m = Level::grey(188);
    m.doubleSided = doubleSided;
    const std::int32_t material = level.material(m);
    level.quad({0, 0, 0}, {4, 0, 0}, {0, 0, -4}, material).scale = {-1, 1, 1};
    const scene::CameraView camera = lookAt({0, 3, 4}, {0, 0, 0});
    const Shot mirrored = stage().render(level.scene, camera, {sun({0, -1, 0}, 10)});
    level.scene.nodes[0].scale = {1, 1, 1};
    const Shot plain = stage().render(level.scene, camera, {sun({0, -1, 0}, 10)});
    EXPECT_NEAR(mirrored.at(32, 32).r, plain.at(32, 32).r, 1e-4);
    if (!doubleSided) continue;
    // Seen from below under a sun from below, the back is lit as the front is.
    const Shot below = stage().render(level.scene, lookAt({0, -3, 4}, {0, 0, 0}), {sun({0, 1, 0}, 10)});
    EXPECT_GT(below.at(32, 32).r, 0.9f * 10 * linearFromSrgb(188) / 3.1416f);
  }
}

TEST_F(SurfaceTest, EmptyLevelsAndTinyPicturesWork) {
  const scene::Scene empty;
  const Shot sky = stage().render(empty, lookAt({0, 0, 0}, {0, 0.2f, -1}), {sun({0, -1, -1}, 10)});
  EXPECT_GT(sky.at(32, 32).b, sky.at(32, 32).r) << "a blue sky";
  EXPECT_GT(sky.at(32, 32).b, 0.05f);
  EXPECT_NEAR(sky.distance[32 * 64 + 32], 100, 0.5);
  Level level;
  level.quad({0, 0, 0}, {4, 0, 0}, {0, 0, -4}, scene::kNone);
  Stage::Options one;
  one.width = one.height = 1;
  one.settings.shadowResolution = 1;
  const Shot shot = stage().render(level.scene, lookAt({0, 3, 0.01f}, {0, 0, 0}),
                                   {sun({0, -1, 0}, 10), pointLight({0, 2, 0}, 5)}, one);
  EXPECT_NEAR(shot.distance[0], 3, 0.01);
  for (const glm::vec4& c : shot.color) EXPECT_TRUE(std::isfinite(c.r + c.g + c.b));
}

TEST_F(SurfaceTest, NumbersOfMaterialsAreThoseOfTheFrame) {
  Level level;
  level.quad({0, 0, 0}, {4, 0, 0}, {0, 0, -4}, level.material(Level::grey(128)));
  scene::Material glass = Level::grey(188);
  glass.alphaMode = scene::AlphaMode::kBlend;
  level.quad({1, 1, 0}, {1, 0, 0}, {0, 0, -1}, level.material(glass));
  const scene::CameraView camera = lookAt({0, 5, 0.01f}, {0, 0, 0}, 1.3f);
  const std::vector<scene::LightView> lights{sun({0.3f, -1, 0}, 10)};
  const Shot before = stage().render(level.scene, camera, lights);
  level.scene.materials[0].baseColor = {0.8f, 0.2f, 0.1f, 1};
  level.scene.materials[0].roughness = 0.4f;
  level.scene.materials[1].baseColor.a = 0.25f;
  level.scene.materials[1].emissive = {0, 0, 2};
  Stage::Options live;
  live.upload = false;
  const Shot edited = stage().render(level.scene, camera, lights, live);
  const Shot anew = stage().render(level.scene, camera, lights);
  EXPECT_EQ(edited.color, anew.color);
  EXPECT_NE(edited.color, before.color);
  EXPECT_LT(before.at(10, 32).r, before.at(10, 32).b * 1.5f);
  EXPECT_GT(edited.at(10, 32).r, 2 * edited.at(10, 32).b);  // the floor is red now, under a blue sky
}

TEST_F(SurfaceTest, WrongSizesAreRefused) {
  const scene::Scene empty;
  ASSERT_TRUE(stage().renderer().setScene(empty).ok());
  GraphMemory memory(stage().device());
  Graph graph(stage().device(), memory);
  Renderer::Input input{empty, {}, lookAt({0, 0, 0}, {0, 0, -1}), {}};
  input.width = 0;
  EXPECT_FALSE(stage().renderer().addFrame(graph, input).ok());
  input.width = 1000000;
  EXPECT_FALSE(stage().renderer().addFrame(graph, input).ok());
  input.width = 16;
  input.settings.shadowResolution = 1000000;
  EXPECT_FALSE(stage().renderer().addFrame(graph, input).ok());
}

}  // namespace
}  // namespace tyndall::render::test
