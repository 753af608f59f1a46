// Lights that shine through images, against closed forms.
#include "level.hpp"

using namespace truth_test;

namespace {

using Texel = std::array<std::uint8_t, 3>;
constexpr Texel kBlack{0, 0, 0}, kWhite{255, 255, 255};

scene::Scene levelWith(std::uint32_t width, std::uint32_t height, const std::vector<Texel>& texels,
                       scene::Wrap wrap = scene::Wrap::kRepeat) {
  scene::Scene level;
  scene::Image image{"cookie", width, height, {}};
  for (const Texel& t : texels) image.rgba.insert(image.rgba.end(), {t[0], t[1], t[2], 7});
  level.images = {image};
  scene::Sampler sampler;
  sampler.wrapU = sampler.wrapV = wrap;
  level.textures = {{0, sampler}};
  return level;
}

/// A light at `position` that looks along -Z of a frame turned by `turn`, one candela or lux.
scene::LightView light(scene::LightKind kind, glm::vec3 position, const glm::mat3& turn = glm::mat3(1)) {
  scene::LightView out = pointAt(position);
  out.light.kind = kind;
  out.worldFromLight = turn;
  out.direction = -turn[2];
  out.light.innerConeAngle = 0.7f, out.light.outerConeAngle = 0.9f;
  out.light.cookie = scene::Cookie{0, {2, 1}};
  return out;
}

/// What the image leaves of the light in a millimetre of air around a point.
glm::dvec3 colorAt(const scene::Scene& level, scene::LightView lamp, glm::vec3 point) {
  const auto camera = cameraAt(point, {0, 0, -1}, 1, 1e-5f, 1e-3f);
  const auto settings = onePixel({1e-5, 1, 0}, 8);
  const glm::dvec3 with(rendered(level, camera, {lamp}, settings).scatter[0]);
  lamp.light.cookie.reset();
  return with / glm::dvec3(rendered(level, camera, {lamp}, settings).scatter[0]);
}

double linear(double code) { return std::pow((code / 255 + 0.055) / 1.055, 2.4); }
/// Two texels, black then white, side by side: linear between their middles.
double ramp(double u) { return std::clamp(2 * u - 0.5, 0.0, 1.0); }

}  // namespace

TEST(TruthCookie, constantGreyScalesTheRadianceByItsLinearValue) {
  for (const auto kind : {scene::LightKind::kDirectional, scene::LightKind::kSpot, scene::LightKind::kPoint}) {
    auto level = levelWith(4, 2, std::vector<Texel>(8, {188, 100, 40}));
    addQuad(level, {-1, 1, -20}, {2, 0, 0}, {0, 0, 40});  // shadows some of it
    const glm::mat3 down{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}};
    auto lamp = light(kind, {0, 5, 0}, down);
    truth::Settings settings;
    settings.width = 16, settings.height = 9;
    settings.medium = {0.05, 0.9, 0.5};
    settings.samples = 512;
    const auto camera = cameraAt({-6, 0.5f, 0.2f}, {1, 0, 0});
    const auto with = rendered(level, camera, {lamp}, settings);
    lamp.light.cookie.reset();
    const auto without = rendered(level, camera, {lamp}, settings);
    const glm::dvec3 grey(linear(188), linear(100), linear(40));
    for (std::size_t i = 0; i < with.scatter.size(); ++i)
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(with.scatter[i][c], grey[c] * without.scatter[i][c], 2e-7 * without.scatter[i][c])
            << static_cast<int>(kind) << " pixel " << i;
  }
}

TEST(TruthCookie, spotImageSpansTheOuterCone) {
  const auto across = levelWith(2, 1, {kBlack, kWhite}), down = levelWith(1, 2, {kBlack, kWhite});
  const auto lamp = light(scene::LightKind::kSpot, {1, 2, 3});
  const double slope = std::tan(double{0.9f});
  for (const float depth : {1.0f, 7.0f})
    for (const float place : {-0.6f, -0.3f, -0.1f, 0.0f, 0.2f, 0.6f}) {
      const float offset = place * static_cast<float>(slope) * depth;
      EXPECT_NEAR(colorAt(across, lamp, {1 + offset, 2, 3 - depth}).r, ramp(0.5 + 0.5 * place), 1e-3) << place;
      EXPECT_NEAR(colorAt(down, lamp, {1, 2 + offset, 3 - depth}).r, ramp(0.5 - 0.5 * place), 1e-3) << place;
    }
}

TEST(TruthCookie, halfBlackImageDarkensHalfTheCone) {
  // A hundred columns: the border between the halves is sharp.
  std::vector<Texel> columns(100, kWhite);
  std::fill_n(columns.begin(), 50, kBlack);
  const auto level = levelWith(100, 1, columns);
  auto lamp = light(scene::LightKind::kSpot, {0, 0, 0});
  const auto camera = cameraAt({-10, 0, -4}, {1, 0, 0});  // crosses the cone from its dark to its bright side
  const auto settings = onePixel({1e-6, 1, 0}, 4096);
  const double half = rendered(level, camera, {lamp}, settings).scatter[0].r;
  lamp.light.cookie.reset();
  EXPECT_NEAR(half, rendered(level, camera, {lamp}, settings).scatter[0].r / 2, 1e-3 * half);
}

TEST(TruthCookie, sunsTileGoesOnAsTheSamplerSays) {
  const std::vector<Texel> texels{kBlack, kWhite};
  const auto sun = light(scene::LightKind::kDirectional, {0.25f, 0, 0});  // tile 2 m wide around x = 0.25
  const auto expected = [](scene::Wrap wrap, double u) {
    if (wrap == scene::Wrap::kClampToEdge) return ramp(u);
    if (wrap == scene::Wrap::kMirroredRepeat) return ramp(1 - std::abs(u - 2 * std::floor(u / 2) - 1));
    const double f = u - std::floor(u);  // triangles: the white texel is the black one's neighbour on both sides
    return f < 0.25 ? 0.5 - 2 * f : f < 0.75 ? 2 * f - 0.5 : 2.5 - 2 * f;
  };
  for (const auto wrap : {scene::Wrap::kRepeat, scene::Wrap::kClampToEdge, scene::Wrap::kMirroredRepeat})
    for (float x = -5; x < 5; x += 0.37f) {
      EXPECT_NEAR(colorAt(levelWith(2, 1, texels, wrap), sun, {x, 3, -9}).r, expected(wrap, 0.5 + (x - 0.25) / 2), 1e-3)
          << static_cast<int>(wrap) << " " << x;
      EXPECT_NEAR(colorAt(levelWith(1, 2, texels, wrap), sun, {3, x, -9}).r, expected(wrap, 0.5 - x), 1e-3)
          << static_cast<int>(wrap) << " " << x;
    }
}

TEST(TruthCookie, equirectangularImageSurroundsAPointLight) {
  const auto lamp = light(scene::LightKind::kPoint, {1, 1, 1});
  const auto top = levelWith(4, 2, {kWhite, kWhite, kWhite, kWhite, kBlack, kBlack, kBlack, kBlack});
  for (const float angle : {0.1f, 0.7f, 1.2f, 1.5707963f, 2.0f, 3.0f})  // from the top
    EXPECT_NEAR(colorAt(top, lamp, {1 + 2 * std::sin(angle), 1 + 2 * std::cos(angle), 1}).r,
                1 - ramp(angle / std::numbers::pi), 1e-3)
        << angle;
  // The middle of the image, columns 1 and 2 of 4, is before the light, at -Z; growing u turns to the right, to +X.
  const Texel r{255, 0, 0}, g{0, 255, 0}, b{0, 0, 255};
  const auto around = levelWith(4, 2, {r, g, b, kWhite, r, g, b, kWhite});
  const glm::dvec3 behindLeft(1, 0, 0), frontLeft(0, 1, 0), frontRight(0, 0, 1), behindRight(1, 1, 1);
  EXPECT_LT(glm::distance(colorAt(around, lamp, {0, 1, 2}), behindLeft), 3e-3);
  EXPECT_LT(glm::distance(colorAt(around, lamp, {0, 1, 0}), frontLeft), 3e-3);
  EXPECT_LT(glm::distance(colorAt(around, lamp, {2, 1, 0}), frontRight), 3e-3);
  EXPECT_LT(glm::distance(colorAt(around, lamp, {2, 1, 2}), behindRight), 3e-3);
  EXPECT_LT(glm::distance(colorAt(around, lamp, {1, 1, 0}), 0.5 * (frontLeft + frontRight)), 3e-3);
  EXPECT_LT(glm::distance(colorAt(around, lamp, {1, 1, 2}), 0.5 * (behindLeft + behindRight)), 3e-3) << "seamless";
}

TEST(TruthCookie, stripsFacesLieAsVulkansCubeMapsDo) {
  // Two texels a side; the upper left of each face is white, the others have the face's colour.
  std::vector<Texel> texels(24);
  for (std::uint8_t face = 0; face < 6; ++face)
    for (int i = 0; i < 4; ++i)
      texels[static_cast<std::size_t>(i / 2 * 12 + face * 2 + i % 2)] =
          i == 0 ? kWhite : Texel{0, static_cast<std::uint8_t>(100 + 20 * face), 0};
  const auto level = levelWith(12, 2, texels);
  const auto lamp = light(scene::LightKind::kPoint, {0, 0, 0});
  const glm::vec3 upperLeft[] = {{1, .5f, .5f},   {-1, .5f, -.5f}, {-.5f, 1, -.5f},
                                 {-.5f, -1, .5f}, {-.5f, .5f, 1},  {.5f, .5f, -1}};
  for (int face = 0; face < 6; ++face) {
    const glm::vec3 axis = glm::vec3(glm::greaterThan(glm::abs(upperLeft[face]), glm::vec3(0.75f))) * upperLeft[face];
    EXPECT_NEAR(colorAt(level, lamp, 3.0f * upperLeft[face]).r, 1, 1e-3) << face;
    const glm::dvec3 lowerRight = colorAt(level, lamp, 3.0f * (2.0f * axis - upperLeft[face]));
    EXPECT_NEAR(lowerRight.r, 0, 1e-3) << face;
    EXPECT_NEAR(lowerRight.g, linear(100 + 20 * face), 1e-3) << face;
  }
}

TEST(TruthCookie, turnsWithItsLight) {
  const auto level = levelWith(2, 1, {kBlack, kWhite});
  const glm::mat3 turn{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};  // right is +Y, up +Z, looks along -X
  const auto spot = light(scene::LightKind::kSpot, {0, 0, 0}, turn);
  EXPECT_NEAR(colorAt(level, spot, {-2, 1.5f, 0}).r, 1, 1e-3);
  EXPECT_NEAR(colorAt(level, spot, {-2, -1.5f, 0}).r, 0, 1e-3);
  EXPECT_NEAR(colorAt(level, spot, {-2, 0, 1}).r, 0.5, 1e-3);
}

// The integral along a whole ray, against quadrature of what the tests above have found at points.
TEST(TruthCookie, raysGatherTheImage) {
  const auto level = levelWith(2, 1, {kBlack, kWhite});
  const auto sun = light(scene::LightKind::kDirectional, {0, 0, 0}, {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}});  // along -X
  const auto camera = cameraAt({0, 0, 0.3f}, {0, 0, -1});
  const truth::Medium medium{0.1, 0.9, 0.4};
  const auto color = [](double t) {  // right is -Z
    const double u = 0.5 + (t - 0.3) / 2, f = u - std::floor(u);
    return f < 0.25 ? 0.5 - 2 * f : f < 0.75 ? 2 * f - 0.5 : 2.5 - 2 * f;
  };
  const double expected =
      0.9 * 0.1 * henyeyGreenstein(0.4, 0) * quadrature([&](double t) { return std::exp(-0.1 * t) * color(t); }, 0, 20);
  EXPECT_NEAR(rendered(level, camera, {sun}, onePixel(medium, 4096)).scatter[0].r, expected, 1e-5 * expected);
}
