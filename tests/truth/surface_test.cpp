// Where view rays end.
#include "level.hpp"

using namespace truth_test;

namespace {

constexpr double kFar = 20;

truth::Settings small() {
  truth::Settings settings;
  settings.width = 32, settings.height = 18;
  settings.medium = {0.05, 1, 0};
  settings.samples = 4;
  return settings;
}

/// Distance seen straight along -z from the origin.
float ahead(const scene::Scene& level, float znear = 0.1f) {
  return rendered(level, cameraAt({0, 0, 0}, {0, 0, -1}, 1, znear, kFar), {}, onePixel({0.05, 1, 0})).distance[0];
}

scene::Scene wall(float z, bool facing, scene::Material material = {}) {
  scene::Scene level;
  if (facing)
    addQuad(level, {-3, -3, z}, {6, 0, 0}, {0, 6, 0}, material);
  else
    addQuad(level, {-3, -3, z}, {0, 6, 0}, {6, 0, 0}, material);
  return level;
}

}  // namespace

TEST(TruthSurface, groundPlaneIsAtTheAnalyticDistanceElseTheFarPlane) {
  scene::Scene level;
  addQuad(level, {-500, 0, 500}, {1000, 0, 0}, {0, 0, -1000});
  const auto camera = cameraAt({100, 1.7f, -30}, {0.3f, -0.2f, -1});
  const auto settings = small();
  const auto picture = rendered(level, camera, {sunAlong({0, -1, 0})}, settings);
  int ground = 0, far = 0;
  for (std::uint32_t y = 0; y < settings.height; ++y)
    for (std::uint32_t x = 0; x < settings.width; ++x) {
      const Ray ray = rayThrough(camera, settings, x, y);
      const double plane = ray.direction.y < 0 ? double{1.7f} / -ray.direction.y : 1e9;
      const bool hit = plane < kFar / ray.cosine;
      ++(hit ? ground : far);
      const double right = hit ? plane : kFar / ray.cosine;
      EXPECT_NEAR(picture.distance[y * settings.width + x], right, 2e-5 * right) << x << " " << y;
      EXPECT_NEAR(picture.scatter[y * settings.width + x].a, std::exp(-0.05 * right), 1e-5);
      // The ground shades nothing above itself.
      EXPECT_NEAR(picture.scatter[y * settings.width + x].r, 0.05 * henyeyGreenstein(0, 0) * fog(0.05, 0, right), 1e-6)
          << x << " " << y;
    }
  EXPECT_GT(ground, 100);
  EXPECT_GT(far, 100);
}

TEST(TruthSurface, missingFarPlaneReachesTheLevel) {
  auto camera = cameraAt({0, 0, 0}, {0, 0, -1});
  camera.camera.zfar.reset();
  EXPECT_FLOAT_EQ(rendered({}, camera, {}, onePixel({0.001, 1, 0})).distance[0], 1000);
  EXPECT_FLOAT_EQ(rendered(wall(-7000, true), camera, {}, onePixel({0.001, 1, 0})).distance[0], 7000);
  camera.camera.znear = 2000;
  EXPECT_FLOAT_EQ(rendered(wall(-7, true), camera, {}, onePixel({0.001, 1, 0})).distance[0], 4000);
}

// znear is a distance along the optical axis: at the picture's corner the ray is longer.
TEST(TruthSurface, nearPlaneCutsAlongTheAxis) {
  EXPECT_FLOAT_EQ(ahead(wall(-0.5f, true), 0.49f), 0.5f);
  EXPECT_FLOAT_EQ(ahead(wall(-0.5f, true), 0.51f), static_cast<float>(kFar));
  const auto settings = small();
  const auto camera = [](float znear) {
    return cameraAt({0, 0, 0}, {0, 0, -1}, 2.0f, znear, static_cast<float>(kFar));
  };
  const double corner = 0.5 / rayThrough(camera(0.1f), settings, 0, 0).cosine;
  EXPECT_GT(corner, 1);
  EXPECT_NEAR(rendered(wall(-0.5f, true), camera(0.49f), {}, settings).distance[0], corner, 1e-5);
  EXPECT_GT(rendered(wall(-0.5f, true), camera(0.51f), {}, settings).distance[0], 20);
}

// What the near plane cuts away is not seen, but its shadow is there.
TEST(TruthSurface, castersBeforeTheNearPlaneShade) {
  scene::Scene level;
  addQuad(level, {-50, 0.01f, -50}, {100, 0, 0}, {0, 0, 100});
  const auto picture = rendered(level, cameraAt({0, 0, 0}, {0.01f, 1, 0}, 0.1f, 0.1f, 20), {sunAlong({0, -1, 0})},
                                onePixel({0.05, 1, 0}));
  EXPECT_NEAR(picture.distance[0], 20, 1e-4);
  EXPECT_NEAR(picture.scatter[0].r, 0.05 * henyeyGreenstein(0, 1) * fog(0.05, 0.01, 20), 2e-5);
}

TEST(TruthSurface, backFacesAreSeenOnlyWhenDoubleSided) {
  scene::Material both;
  both.doubleSided = true;
  EXPECT_FLOAT_EQ(ahead(wall(-5, true)), 5);
  EXPECT_FLOAT_EQ(ahead(wall(-5, false)), static_cast<float>(kFar));
  EXPECT_FLOAT_EQ(ahead(wall(-5, false, both)), 5);
}

TEST(TruthSurface, mirroringNodesTurnTheFrontRound) {
  auto front = wall(-5, true), back = wall(-5, false);
  front.nodes[0].scale = back.nodes[0].scale = {-1, 1, 1};
  EXPECT_FLOAT_EQ(ahead(front), 5);
  EXPECT_FLOAT_EQ(ahead(back), static_cast<float>(kFar));
  front.nodes[0].scale = {1, 1, -1};  // behind the eye
  EXPECT_FLOAT_EQ(ahead(front), static_cast<float>(kFar));
}

TEST(TruthSurface, nodesPlaceMeshes) {
  auto level = wall(-5, true);
  scene::Node parent;
  parent.translation = {0, 0, -2};
  parent.scale = {1, 1, 2};
  level.nodes.insert(level.nodes.begin(), parent);
  level.nodes[1].parent = 0;
  EXPECT_FLOAT_EQ(ahead(level), 12);
}

// A roof seen from neither side shades all the same; a BLEND one does not.
TEST(TruthSurface, backFacesShadeAndBlendedOnesDoNot) {
  scene::Material blend;
  blend.alphaMode = scene::AlphaMode::kBlend;
  scene::Scene up, down, glass;
  addQuad(up, {-50, 3, -50}, {0, 0, 100}, {100, 0, 0});
  addQuad(down, {-50, 3, -50}, {100, 0, 0}, {0, 0, 100});
  addQuad(glass, {-50, 3, -50}, {100, 0, 0}, {0, 0, 100}, blend);
  const auto light = [](const scene::Scene& level) {
    return rendered(level, cameraAt({0, 0, 0}, {0, 0, -1}), {sunAlong({0, -1, 0})}, onePixel({0.05, 1, 0}))
        .scatter[0]
        .r;
  };
  EXPECT_EQ(light(up), 0);
  EXPECT_EQ(light(down), 0);
  EXPECT_FLOAT_EQ(light(glass), light({}));
  EXPECT_GT(light({}), 0);
  EXPECT_FLOAT_EQ(ahead(wall(-5, true, blend)), static_cast<float>(kFar));
}

// Row 0 is the top, column 0 the left.
TEST(TruthSurface, picturesAreUpright) {
  scene::Scene level;
  addQuad(level, {-9, 0, -5}, {9, 0, 0}, {0, 9, 0});  // the upper left quarter of the view
  const auto picture = rendered(level, cameraAt({0, 0, 0}, {0, 0, -1}), {}, small());
  const auto seen = [&](std::uint32_t x, std::uint32_t y) { return picture.distance[y * 32 + x] < 15; };
  EXPECT_TRUE(seen(0, 0));
  EXPECT_FALSE(seen(31, 0));
  EXPECT_FALSE(seen(0, 17));
  EXPECT_FALSE(seen(31, 17));
  EXPECT_TRUE(seen(15, 8));
  EXPECT_FALSE(seen(16, 8));
  EXPECT_FALSE(seen(15, 9));
}

// A level a hundred kilometres from the origin is as sharp as floats let its own vertices be.
TEST(TruthSurface, distancesDoNotSufferFarFromTheOrigin) {
  auto level = wall(-5.25f, true);
  level.nodes[0].translation = {100000, 0, 65536};
  const auto camera = cameraAt({100000, 0, 65536}, {0, 0, -1});
  EXPECT_NEAR(rendered(level, camera, {}, onePixel({0.05, 1, 0})).distance[0], 5.25, 1e-5);
}
