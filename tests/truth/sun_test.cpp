// Directional lights against closed forms.
#include "level.hpp"

using namespace truth_test;

TEST(TruthSun, withoutOccludersIsTheClosedForm) {
  const auto camera = cameraAt({3, 1.5f, -2}, {1, -0.3f, 0.4f});
  const auto sun = sunAlong({-0.5f, -1, 0.2f}, {3, 2, 0.5f});
  for (const double sigma : {0.0, 1e-6, 0.03, 5.0})
    for (const double g : {-0.9, -0.3, 0.0, 0.5, 0.9}) {
      truth::Settings settings;
      settings.width = 16, settings.height = 9;
      settings.medium = {sigma, 0.8, g};
      settings.samples = 1;
      const auto picture = rendered({}, camera, {sun}, settings);
      for (std::uint32_t y = 0; y < 9; ++y)
        for (std::uint32_t x = 0; x < 16; ++x) {
          const Ray ray = rayThrough(camera, settings, x, y);
          const double length = 20 / ray.cosine;
          const double cosine = -glm::dot(glm::dvec3(sun.direction), ray.direction);
          const double expected = 0.8 * sigma * 3 * henyeyGreenstein(g, cosine) * fog(sigma, 0, length);
          const glm::vec4 pixel = picture.scatter[y * 16 + x];
          ASSERT_NEAR(pixel.r, expected, 1e-6 * expected) << sigma << " " << g << " " << x << " " << y;
          ASSERT_NEAR(pixel.g, expected * 2 / 3, 1e-6 * expected);
          ASSERT_NEAR(pixel.b, expected / 6, 1e-6 * expected);
          ASSERT_NEAR(pixel.a, std::exp(-sigma * length), 1e-6);
          ASSERT_NEAR(picture.distance[y * 16 + x], length, 1e-5);
        }
    }
}

// The phase function as the pictures of all six sides show it: its integral over the sphere is 1, its mean cosine g.
TEST(TruthSun, phaseIsNormalisedWithMeanCosineG) {
  const double sigma = 0.1;
  const auto sun = sunAlong({0.3f, -1, 0.2f});
  for (const double g : {-0.7, 0.0, 0.5, 0.8}) {
    double norm = 0, mean = 0;
    for (const glm::vec3 side : {glm::vec3{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) {
      const auto camera = cameraAt({0, 0, 0}, side, std::numbers::pi_v<float> / 2);
      truth::Settings settings;
      settings.width = settings.height = 128;
      settings.medium = {sigma, 1, g};
      const auto picture = rendered({}, camera, {sun}, settings);
      for (std::uint32_t i = 0; i < 128 * 128; ++i) {
        const Ray ray = rayThrough(camera, settings, i % 128, i / 128);
        const double solidAngle = std::pow(2.0 / 128 * ray.cosine, 2) * ray.cosine;  // of the pixel, steradian
        const double p = picture.scatter[i].r / (1 - picture.scatter[i].a);
        norm += p * solidAngle;
        mean += p * solidAngle * -glm::dot(ray.direction, glm::dvec3(sun.direction));
      }
    }
    EXPECT_NEAR(norm, 1, 1e-3) << g;
    EXPECT_NEAR(mean, g, 1e-3) << g;
  }
}

TEST(TruthSun, forwardScatteringIsBrightTowardsTheLight) {
  const auto settings = onePixel({0.05, 1, 0.8});
  const auto sun = sunAlong({-1, 0, 0});
  const float towards = rendered({}, cameraAt({0, 0, 0}, {1, 0, 0}), {sun}, settings).scatter[0].r;
  const float away = rendered({}, cameraAt({0, 0, 0}, {-1, 0, 0}), {sun}, settings).scatter[0].r;
  EXPECT_NEAR(towards / away, std::pow(1.8 / 0.2, 3), 1e-2);
}

namespace {

/// A roof at height 4 above the eye over x < 3 (world), and a sun from the upper right: points left of
/// x = 3 + slope * 4 are in its shadow, those right of it are lit.
struct HalfSpace {
  scene::Scene level;
  scene::LightView sun = sunAlong({0.5f, -1, 0});
  scene::CameraView camera = cameraAt({-1, 2, 5}, {1, 0, 0});
  double border = 4 + 2;  ///< along the ray: from x = -1 to x = 3 + 0.5 * 4

  HalfSpace() { addQuad(level, {-4000, 6, -4000}, {4003, 0, 0}, {0, 0, 8000}); }
};

}  // namespace

// The estimate can only be wrong within the stratum that the shadow's border cuts, by at most half of it.
TEST(TruthSun, halfSpaceOccluder) {
  const HalfSpace half;
  for (const double sigma : {0.0, 1e-6, 0.03, 0.4})
    for (const double g : {-0.5, 0.0, 0.7})
      for (const std::uint32_t samples : {1u, 16u, 256u, 4096u}) {
        const double p = henyeyGreenstein(g, -glm::dot(glm::dvec3(half.sun.direction), glm::dvec3(1, 0, 0)));
        const double expected = sigma * p * fog(sigma, half.border, 20);
        const double bound = 0.5 / samples * sigma * p * fog(sigma, 0, 20) + 1e-5 * expected;
        const auto picture = rendered(half.level, half.camera, {half.sun}, onePixel({sigma, 1, g}, samples));
        EXPECT_NEAR(picture.scatter[0].r, expected, bound) << sigma << " " << g << " " << samples;
      }
}

TEST(TruthSun, errorFallsAsSamplesRise) {
  const HalfSpace half;
  const double sigma = 0.1;
  const auto meanError = [&](std::uint32_t samples) {
    double sum = 0;
    for (int i = 0; i < 40; ++i) {  // other eyes: other places of the border within its stratum
      const auto camera = cameraAt({-1 + 0.0317f * static_cast<float>(i), 2, 5}, {1, 0, 0});
      const double border = half.border - 0.0317 * i;
      const double expected = sigma * henyeyGreenstein(0, 0) * fog(sigma, border, 20);
      sum +=
          std::abs(rendered(half.level, camera, {half.sun}, onePixel({sigma, 1, 0}, samples)).scatter[0].r - expected) /
          expected;
    }
    return sum / 40;
  };
  const double coarse = meanError(8), middle = meanError(64), fine = meanError(512);
  EXPECT_LT(middle, coarse / 3);
  EXPECT_LT(fine, middle / 3);
  EXPECT_LT(fine, 1e-3);
}

// A row of boards: the sum of the exponentials over the gaps, and over the lit ends before and behind the boards.
TEST(TruthSun, boardsWithGaps) {
  scene::Scene level;
  constexpr int kBoards = 7;
  for (int i = 0; i < kBoards; ++i) addQuad(level, {2 * static_cast<float>(i), 6, -50}, {1, 0, 0}, {0, 0, 100});
  const auto sun = sunAlong({0.5f, -1, 0.1f});
  const auto camera = cameraAt({-3, 2, 0}, {1, 0, 0}, 1.0f, 0.1f, 30.0f);
  for (const double sigma : {1e-6, 0.05, 0.3}) {
    double length = fog(sigma, 0, 30);
    // The shadow of x at the roof lies 0.5 * 4 further along at the eye's height; the eye is at x = -3.
    for (int i = 0; i < kBoards; ++i) length -= fog(sigma, 2 * i + 5, 2 * i + 6);
    const double p = henyeyGreenstein(0.3, -double{sun.direction.x});
    const auto picture = rendered(level, camera, {sun}, onePixel({sigma, 0.7, 0.3}, 4096));
    EXPECT_NEAR(picture.scatter[0].r, 0.7 * sigma * p * length, 0.7 * sigma * p * length * 1e-3) << sigma;
  }
}

// A ray that no shadow can reach needs no samples at all; one that looks up past the roof is lit from the roof on.
TEST(TruthSun, partsOutOfEveryShadowAreExact) {
  scene::Scene level;
  addQuad(level, {0, 6, -1}, {2, 0, 0}, {0, 0, 2});
  const double sigma = 0.1;
  const auto sun = sunAlong({0, -1, 0});
  const auto beside = rendered(level, cameraAt({-3, 2, 1.5f}, {1, 0, 0}), {sun}, onePixel({sigma, 1, 0.4}, 1));
  EXPECT_NEAR(beside.scatter[0].r, sigma * henyeyGreenstein(0.4, 0) * fog(sigma, 0, 20), 1e-8);
  // Under the middle of the roof, looking along x: in shadow up to x = 2, and the strata end there.
  const auto under = rendered(level, cameraAt({1, 2, 0}, {1, 0, 0}), {sun}, onePixel({sigma, 1, 0.4}, 1));
  EXPECT_NEAR(under.scatter[0].r, sigma * henyeyGreenstein(0.4, 0) * fog(sigma, 1, 20), 1e-4);
}

TEST(TruthSun, severalSunsAdd) {
  const HalfSpace half;
  const auto other = sunAlong({-1, -0.2f, 0.3f}, {0.5f, 0, 2});
  const auto settings = onePixel({0.05, 0.9, 0.2}, 256);
  const glm::vec4 a = rendered(half.level, half.camera, {half.sun}, settings).scatter[0];
  const glm::vec4 b = rendered(half.level, half.camera, {other}, settings).scatter[0];
  const glm::vec4 both = rendered(half.level, half.camera, {half.sun, other}, settings).scatter[0];
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(both[c], a[c] + b[c], 1e-6 * both[c]);
  EXPECT_EQ(both.a, a.a);
}
