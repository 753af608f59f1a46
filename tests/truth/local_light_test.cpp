// Spot and point lights against adaptive quadrature of the contract's integral.
#include "level.hpp"

using namespace truth_test;

namespace {

/// The integrand without visibility, for a light of one candela, from KHR_lights_punctual's formulas.
double integrand(const scene::LightView& view, const Ray& ray, const truth::Medium& medium, double t) {
  const scene::Light& light = view.light;
  const glm::dvec3 toPoint = ray.at(t) - glm::dvec3(view.position);
  const double d = glm::length(toPoint);
  double attenuation = 1 / (d * d);
  if (light.range) attenuation *= std::max(std::min(1 - std::pow(d / *light.range, 4), 1.0), 0.0);
  if (light.kind == scene::LightKind::kSpot) {
    const double cosInner = std::cos(double{light.innerConeAngle}), cosOuter = std::cos(double{light.outerConeAngle});
    const double cd = glm::dot(toPoint / d, glm::normalize(glm::dvec3(view.direction)));
    const double linear = cosInner > cosOuter ? (cd - cosOuter) / (cosInner - cosOuter) : cd > cosOuter ? 1 : 0;
    const double angular = std::min(std::max(linear, 0.0), 1.0);
    attenuation *= angular * angular;
  }
  const double cosine = glm::dot(toPoint / d, -ray.direction);
  return std::exp(-medium.sigma_t * (t + d)) * henyeyGreenstein(medium.g, cosine) * attenuation;
}

double expected(const scene::LightView& light, const Ray& ray, const truth::Medium& medium, double begin, double end) {
  return medium.albedo * medium.sigma_t *
         quadrature([&](double t) { return integrand(light, ray, medium, t); }, begin, end);
}

scene::LightView spotAt(glm::vec3 position, glm::vec3 direction, float inner, float outer) {
  auto light = pointAt(position);
  light.light.kind = scene::LightKind::kSpot;
  light.direction = glm::normalize(direction);
  light.light.innerConeAngle = inner;
  light.light.outerConeAngle = outer;
  return light;
}

void compareWithQuadrature(const scene::LightView& light, const char* what, double tolerance) {
  const auto camera = cameraAt({-4, 1, 2}, {1, 0.1f, -0.2f});
  for (const double sigma : {0.0, 1e-6, 0.03, 0.5, 5.0})
    for (const double g : {-0.6, 0.0, 0.9}) {
      truth::Settings settings;
      settings.width = 8, settings.height = 5;
      settings.medium = {sigma, 0.9, g};
      const auto picture = rendered({}, camera, {light}, settings);
      for (std::uint32_t y = 0; y < 5; ++y)
        for (std::uint32_t x = 0; x < 8; ++x) {
          const Ray ray = rayThrough(camera, settings, x, y);
          const double right = expected(light, ray, settings.medium, 0, 20 / ray.cosine);
          ASSERT_NEAR(picture.scatter[y * 8 + x].r, right, tolerance * right + 1e-30)
              << what << " sigma_t " << sigma << " g " << g << " pixel " << x << " " << y;
        }
    }
}

}  // namespace

TEST(TruthLocalLight, pointIsTheIntegral) {
  compareWithQuadrature(pointAt({2, 1.7f, 0.6f}), "in view", 1e-5);
  compareWithQuadrature(pointAt({-4.2f, 1.1f, 2.1f}), "behind the eye", 1e-5);
  compareWithQuadrature(pointAt({-80, 60, 30}), "far away", 1e-5);
  auto ranged = pointAt({2, 1.7f, 0.6f});
  ranged.light.range = 3.5f;
  compareWithQuadrature(ranged, "with range", 1e-5);
}

TEST(TruthLocalLight, spotIsTheIntegral) {
  compareWithQuadrature(spotAt({2, 5, 0.6f}, {0, -1, 0.1f}, 0.2f, 0.5f), "down", 1e-4);
  compareWithQuadrature(spotAt({2, 5, 0.6f}, {0, -1, 0.1f}, 0.0f, 0.05f), "narrow", 1e-4);
  // The falloff's width is 0.0004 in cosines.
  compareWithQuadrature(spotAt({2, 5, 0.6f}, {0, -1, 0.1f}, 0.04f, 0.05f), "narrow, with a steep edge", 1e-3);
  compareWithQuadrature(spotAt({8, 2, 0}, {-1, 0, 0.1f}, 0.3f, 0.9f), "towards the eye", 1e-4);
  compareWithQuadrature(spotAt({-6, 1, 2}, {1, 0, 0}, 0.3f, 1.5707963f), "along the view, half a sphere", 1e-4);
  auto ranged = spotAt({2, 5, 0.6f}, {0, -1, 0.1f}, 0.2f, 0.5f);
  ranged.light.range = 6;
  compareWithQuadrature(ranged, "with range", 1e-4);
}

// A film of air around the eye (zfar 1 cm): what a light gives it falls with the square of the distance, and with the
// range.
TEST(TruthLocalLight, fallsWithTheSquareOfTheDistanceAndEndsAtItsRange) {
  const auto camera = cameraAt({0, 0, 0}, {0, 0, -1}, 1, 0.001f, 0.01f);
  const auto at = [&](float distance, std::optional<float> range) {
    auto light = pointAt({distance, 0, 0});
    light.light.range = range;
    return double{rendered({}, camera, {light}, onePixel({1e-5, 1, 0})).scatter[0].r};
  };
  const double unit = 1e-5 * 0.25 / std::numbers::pi * 0.01;
  EXPECT_NEAR(at(2, {}) / unit, 1.0 / 4, 1e-4);
  EXPECT_NEAR(at(4, {}) / unit, 1.0 / 16, 1e-4);
  EXPECT_NEAR(at(4, 5.0f) / unit, 1.0 / 16 * (1 - std::pow(0.8, 4)), 1e-4);
  EXPECT_EQ(at(6, 5.0f), 0);
}

// A wall between the light and one part of the ray: by similar triangles its shadow begins at x = 2 on the ray.
TEST(TruthLocalLight, shadowOfAWall) {
  scene::Scene level;
  addQuad(level, {-100, 2, -100}, {101, 0, 0}, {0, 0, 200});  // height 2, up to x = 1
  const auto light = pointAt({0, 4, 0.5f});  // straight above: the ray at height 0 is lit from x = 2 on
  const auto camera = cameraAt({-5, 0, 0.5f}, {1, 0, 0});
  const truth::Medium medium{0.05, 0.9, 0.5};
  const Ray ray{{-5, 0, 0.5}, {1, 0, 0}, 1};
  const double right = expected(light, ray, medium, 7, 20);
  double last = 1;
  for (const std::uint32_t samples : {64u, 1024u, 16384u}) {
    const double got = rendered(level, camera, {light}, onePixel(medium, samples)).scatter[0].r;
    const double error = std::abs(got - right) / right;
    EXPECT_LT(error, 4.0 / samples);
    EXPECT_LE(error, last);
    last = error;
  }
}

// What lies behind a light casts no shadow on the air before it; a closed box around it casts one everywhere.
TEST(TruthLocalLight, onlySurfacesInBetweenOcclude) {
  const truth::Medium medium{0.05, 0.9, 0.5};
  const auto light = pointAt({0, 4, 0.5f});
  const auto camera = cameraAt({-5, 0, 0.5f}, {1, 0, 0});
  scene::Scene behind, around;
  addQuad(behind, {-100, 4.01f, -100}, {200, 0, 0}, {0, 0, 200});
  addQuad(behind, {-100, -0.01f, -100}, {200, 0, 0}, {0, 0, 200});
  for (const float y : {3.0f, 5.0f}) addQuad(around, {-1, y, -1}, {2, 0, 0}, {0, 0, 3});
  for (const float x : {-1.0f, 1.0f}) addQuad(around, {x, 3, -1}, {0, 2, 0}, {0, 0, 3});
  for (const float z : {-1.0f, 2.0f}) addQuad(around, {-1, 3, z}, {2, 0, 0}, {0, 2, 0});
  const float free = rendered({}, camera, {light}, onePixel(medium)).scatter[0].r;
  EXPECT_FLOAT_EQ(rendered(behind, camera, {light}, onePixel(medium)).scatter[0].r, free);
  EXPECT_EQ(rendered(around, camera, {light}, onePixel(medium)).scatter[0].r, 0);
}

// Ten borders of shadow, each wrong by at most half a stratum and by 0.29 of one in the mean (uniform distribution):
// about 0.29 sqrt(10) / 1024 = 0.9e-3 of the whole.
TEST(TruthLocalLight, tenfoldSamplesChangeLittle) {
  scene::Scene level;
  for (int i = 0; i < 5; ++i) addQuad(level, {2 * static_cast<float>(i) - 5, 2, -50}, {1, 0, 0}, {0, 0, 100});
  const auto spot = spotAt({0, 6, 0}, {0.1f, -1, 0}, 0.3f, 1.0f);
  const auto camera = cameraAt({-6, 0.3f, 0.5f}, {1, -0.02f, 0});
  truth::Settings settings = onePixel({0.05, 0.9, 0.7});
  settings.width = 8, settings.height = 8;
  const auto coarse = rendered(level, camera, {spot}, settings);
  settings.samples *= 10;
  const auto fine = rendered(level, camera, {spot}, settings);
  double sum = 0, difference = 0;
  for (int i = 0; i < 64; ++i) {
    sum += fine.scatter[i].r;
    difference += std::abs(fine.scatter[i].r - coarse.scatter[i].r);
  }
  EXPECT_GT(sum, 0);
  EXPECT_LT(difference / sum, 2e-3);
}

// A view ray exactly through the light: finite, and brighter than one that passes a centimetre away.
TEST(TruthLocalLight, rayThroughTheLightIsFinite) {
  const auto camera = cameraAt({0, 0, 0}, {0, 0, -1});
  const auto settings = onePixel({0.05, 0.9, 0.7}, 1023);
  const float through = rendered({}, camera, {pointAt({0, 0, -5})}, settings).scatter[0].r;
  const float beside = rendered({}, camera, {pointAt({0.01f, 0, -5})}, settings).scatter[0].r;
  EXPECT_TRUE(std::isfinite(through));
  EXPECT_GT(through, beside);
  EXPECT_TRUE(std::isfinite(rendered({}, camera, {pointAt({0, 0, 0})}, settings).scatter[0].r));
}
