// Images of lights as layers: what resampling keeps, and where directions land.
#include "cookie_layers.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "cookies.hpp"

namespace tyndall::render {
namespace {

Plane noise(std::uint32_t width, std::uint32_t height) {
  Plane plane{width, height, {}};
  std::uint32_t state = 7;
  for (std::size_t i = 0; i < std::size_t{width} * height; ++i) {
    state = state * 1664525u + 1013904223u;
    plane.texels.emplace_back(static_cast<float>(state >> 8) / 16777216.0f, static_cast<float>(i % 5) / 4, 1);
  }
  return plane;
}
glm::dvec3 mean(const Plane& plane) {
  glm::dvec3 sum(0);
  for (const glm::vec3& texel : plane.texels) sum += glm::dvec3(texel);
  return sum / static_cast<double>(plane.texels.size());
}

TEST(CookieLayers, DecodesSrgb) {
  const Plane plane = linearPlane({"", 2, 1, {0, 10, 255, 1, 188, 128, 64, 2}});
  EXPECT_EQ(plane.texels[0].x, 0);
  EXPECT_NEAR(plane.texels[0].y, 10 / 255.0 / 12.92, 1e-7);
  EXPECT_EQ(plane.texels[0].z, 1);
  EXPECT_NEAR(plane.texels[1].y, 0.21586, 1e-5);
}

TEST(CookieLayers, ShrinkingKeepsTheMean) {
  const Plane plane = noise(37, 50);
  for (const glm::uvec2 size : {glm::uvec2(18, 25), {5, 3}, {1, 1}, {37, 7}}) {
    const Plane small = resized(plane, size.x, size.y, scene::Wrap::kRepeat, scene::Wrap::kRepeat);
    ASSERT_EQ(small.texels.size(), std::size_t{size.x} * size.y);
    EXPECT_LT(glm::distance(mean(small), mean(plane)), 1e-5) << size.x;
  }
}

TEST(CookieLayers, TheSameSizeIsTheSameImage) {
  const Plane plane = noise(9, 4);
  EXPECT_EQ(resized(plane, 9, 4, scene::Wrap::kRepeat, scene::Wrap::kClampToEdge).texels, plane.texels);
}

TEST(CookieLayers, GrowingInterpolatesAcrossTheWrap) {
  const Plane two{2, 1, {glm::vec3(0), glm::vec3(1)}};
  const Plane clamped = resized(two, 4, 1, scene::Wrap::kClampToEdge, scene::Wrap::kClampToEdge);
  const Plane repeated = resized(two, 4, 1, scene::Wrap::kRepeat, scene::Wrap::kClampToEdge);
  for (int i = 0; i < 4; ++i) {
    EXPECT_FLOAT_EQ(clamped.texels[i].x, (std::array{0.0f, 0.25f, 0.75f, 1.0f})[i]);
    EXPECT_FLOAT_EQ(repeated.texels[i].x, (std::array{0.25f, 0.25f, 0.75f, 0.75f})[i]);
  }
}

TEST(CookieLayers, MirroredOnceIsTheImageAndItsMirrorImage) {
  const Plane plane{2, 1, {glm::vec3(1), glm::vec3(2)}};
  const Plane both = mirroredOnce(plane, {true, true});
  ASSERT_EQ(both.width, 4u);
  ASSERT_EQ(both.height, 2u);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(both.texels[i].x, (std::array{1, 2, 2, 1, 1, 2, 2, 1})[i]);
}

TEST(CookieLayers, FacesSeeTheirPartOfTheSphere) {
  // The image's colour is its direction's height and azimuth; each face's texels must have theirs.
  Plane sphere{512, 256, {}};
  for (std::uint32_t y = 0; y < 256; ++y)
    for (std::uint32_t x = 0; x < 512; ++x) {
      const double inclination = (y + 0.5) / 256 * M_PI, azimuth = ((x + 0.5) / 512 - 0.5) * 2 * M_PI;
      sphere.texels.emplace_back(std::sin(inclination) * std::sin(azimuth), std::cos(inclination),
                                 -std::sin(inclination) * std::cos(azimuth));
    }
  const std::vector<Plane> faces = facesFromEquirectangular(sphere, 32);
  ASSERT_EQ(faces.size(), 6u);
  const glm::vec3 axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (std::uint32_t face = 0; face < 6; ++face) {
    EXPECT_EQ(cubeDirection(face, 0, 0), axes[face]);
    for (std::uint32_t i = 0; i < 32 * 32; ++i) {
      const float u = (static_cast<float>(i % 32) + 0.5f) / 16 - 1, v = (static_cast<float>(i / 32) + 0.5f) / 16 - 1;
      EXPECT_LT(glm::distance(faces[face].texels[i], glm::normalize(cubeDirection(face, u, v))), 0.01f)
          << face << " texel " << i;
    }
  }
}

TEST(CookieLayers, EachFaceOfAStripIsItsOwn) {
  Plane strip{12, 2, {}};
  for (int i = 0; i < 24; ++i) strip.texels.emplace_back(static_cast<float>(i % 12 / 2));
  const std::vector<Plane> faces = facesFromStrip(strip, 5);
  for (std::size_t face = 0; face < 6; ++face)
    for (const glm::vec3& texel : faces[face].texels) EXPECT_FLOAT_EQ(texel.x, static_cast<float>(face));
}

TEST(CookieFromWorld, BringsTheImagesCornersToOne) {
  scene::LightView light;
  light.position = {1, 2, 3};
  light.worldFromLight = {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};  // right is +Y, up +Z, looks along -X
  light.direction = {-1, 0, 0};
  light.light.cookie = scene::Cookie{0, {4, 6}};
  const auto place = [&](const CookiePlace& at, const glm::vec3& p) {
    const glm::vec4 h = cookieFromWorld(light, at) * glm::vec4(p, 1);
    return glm::vec3(h) / h.w;
  };
  EXPECT_LT(glm::distance(glm::vec2(place({}, {-5, 2 + 2, 3 - 3})), glm::vec2(1, -1)), 1e-6f);
  EXPECT_FLOAT_EQ(place({}, {-5, 2, 3}).z, 6);
  // With its mirror image the tile is 8 m by 12 m; the image is its left upper quarter.
  const CookiePlace mirrored{0, 1, {true, true}, {true, true}};
  EXPECT_LT(glm::distance(glm::vec2(place(mirrored, {0, 2 - 2, 3 + 3})), glm::vec2(-1, 1)), 1e-6f);
  EXPECT_LT(glm::distance(glm::vec2(place(mirrored, {0, 2 + 2, 3 - 3})), glm::vec2(0, 0)), 1e-6f);

  light.light.kind = scene::LightKind::kSpot;
  light.light.outerConeAngle = 0.5f;
  const float half = 4 * std::tan(0.5f);
  EXPECT_LT(glm::distance(glm::vec2(place({}, {1 - 4, 2 + half, 3 - half})), glm::vec2(1, -1)), 1e-6f);
  EXPECT_FLOAT_EQ((cookieFromWorld(light, {}) * glm::vec4(1 - 4, 9, 9, 1)).w, 4);
  light.light.outerConeAngle = 1.5707964f;
  EXPECT_TRUE(std::isfinite(place({}, {0, 5, 5}).x)) << "half a sphere";
  EXPECT_GT(place({}, {0, 5, 5}).x, 0);

  light.light.kind = scene::LightKind::kPoint;
  EXPECT_LT(glm::distance(place({0, 6, {}, {}}, {1 - 4, 2 + 5, 3 - 6}), glm::vec3(5, -6, -4)), 1e-6f);
}

}  // namespace
}  // namespace tyndall::render
