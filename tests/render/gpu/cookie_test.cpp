// Surfaces lit through images: the colour is where the projection says, in every pass that lights.
#include <array>

#include "stage.hpp"

namespace tyndall::render::test {
namespace {

using Texel = std::array<std::uint8_t, 3>;
constexpr Texel kBlack{0, 0, 0}, kWhite{255, 255, 255}, kRed{255, 0, 0}, kGreen{0, 255, 0}, kBlue{0, 0, 255};

scene::Image imageOf(std::uint32_t width, std::uint32_t height, const std::vector<Texel>& texels) {
  scene::Image image{"cookie", width, height, {}};
  for (const Texel& t : texels) image.rgba.insert(image.rgba.end(), {t[0], t[1], t[2], 9});
  return image;
}
/// Red upper left, green upper right, blue lower left, white lower right; each quarter of `n` x `n` texels.
scene::Image quarters(std::uint32_t n) {
  std::vector<Texel> texels;
  for (std::uint32_t y = 0; y < 2 * n; ++y)
    for (std::uint32_t x = 0; x < 2 * n; ++x)
      texels.push_back(y < n ? (x < n ? kRed : kGreen) : (x < n ? kBlue : kWhite));
  return imageOf(2 * n, 2 * n, texels);
}

// Looks down: right is +X, up is -Z.
const glm::mat3 kDown{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}};

scene::LightView shiningDown(scene::LightView light) {
  light.worldFromLight = kDown;
  light.light.cookie = scene::Cookie{0, {2, 1}};
  return light;
}

class CookieTest : public FrameTest {
 protected:
  scene::CameraView camera_ = lookAt({0, 6, 3}, {0, 0, 0}, 1.0f);
  scene::AlphaMode alpha_ = scene::AlphaMode::kOpaque;
  scene::Wrap wrap_ = scene::Wrap::kRepeat;
  Stage::Options options_ = [] {
    Stage::Options o;
    o.width = o.height = 128;
    return o;
  }();

  Shot shoot(const scene::Image& image, const scene::LightView& light, std::vector<scene::LightView> others = {}) {
    Level level;
    scene::Material m = Level::grey(188);
    m.alphaMode = alpha_;
    level.quad({0, 0, 0}, {8, 0, 0}, {0, 0, -8}, level.material(m));
    level.scene.images = {image, imageOf(2, 1, {kBlack, kBlack})};
    scene::Sampler sampler;
    sampler.wrapU = sampler.wrapV = wrap_;
    level.scene.textures = {{0, sampler}, {1, {}}};
    level.scene.lights = {light.light};
    for (const scene::LightView& other : others) level.scene.lights.push_back(other.light);
    others.insert(others.begin(), light);
    return stage().render(level.scene, camera_, others, options_);
  }
  /// What the image leaves of the light's direct share at each place of the floor.
  std::vector<glm::vec3> colors(const scene::Image& image, const scene::LightView& light,
                                const std::vector<glm::vec3>& places) {
    const auto plain = [&](const Texel& t) {
      return imageOf(image.width, image.height, std::vector<Texel>(image.rgba.size() / 4, t));
    };
    const Shot dark = shoot(plain(kBlack), light), full = shoot(plain(kWhite), light), shot = shoot(image, light);
    std::vector<glm::vec3> out;
    for (const glm::vec3& p : places) {
      const glm::vec3 low = radianceAt(camera_, dark, p), high = radianceAt(camera_, full, p);
      EXPECT_GT(high.r, low.r + 1e-3f);
      out.push_back((radianceAt(camera_, shot, p) - low) / (high - low));
    }
    return out;
  }
  void expectColors(const scene::Image& image, const scene::LightView& light,
                    const std::vector<std::pair<glm::vec3, glm::vec3>>& wanted, float tolerance = 0.01f) {
    std::vector<glm::vec3> places;
    for (const auto& w : wanted) places.push_back(w.first);
    const std::vector<glm::vec3> got = colors(image, light, places);
    for (std::size_t i = 0; i < wanted.size(); ++i)
      EXPECT_LT(glm::distance(got[i], wanted[i].second), tolerance)
          << places[i].x << ", " << places[i].z << ": " << got[i].r << " " << got[i].g << " " << got[i].b;
  }
};

const glm::vec3 r(1, 0, 0), g(0, 1, 0), b(0, 0, 1), w(1, 1, 1);

TEST_F(CookieTest, SpotsImageSpansItsCone) {
  const scene::LightView spot = shiningDown(spotLight({0, 3, 0}, {0, 0, 0}, 100, 0.6f));
  const float half = 3 * std::tan(0.6f);
  // Up in the image is away from the camera.
  const std::vector<std::pair<glm::vec3, glm::vec3>> wanted = {{{-0.5f * half, 0, -0.5f * half}, r},
                                                               {{0.5f * half, 0, -0.5f * half}, g},
                                                               {{-0.5f * half, 0, 0.5f * half}, b},
                                                               {{0.5f * half, 0, 0.5f * half}, w}};
  expectColors(quarters(8), spot, wanted);
  options_.settings.shadowMode = ShadowMode::kMoments;
  expectColors(quarters(8), spot, wanted);
  options_.settings.shadowMode = ShadowMode::kPcf;
  alpha_ = scene::AlphaMode::kBlend;
  expectColors(quarters(8), spot, wanted);
  alpha_ = scene::AlphaMode::kOpaque;
  // A steep ramp by eight columns: bilinear between the texels' middles, at 0.5625 of the cone's half.
  std::vector<Texel> columns(8, kBlack);
  columns[6] = columns[7] = kWhite;
  expectColors(
      imageOf(8, 1, columns), spot,
      {{{0.375f * half, 0, 0}, glm::vec3(0)}, {{0.5f * half, 0, 0}, glm::vec3(0.5f)}, {{0.625f * half, 0, 0}, w}},
      0.1f);
}

TEST_F(CookieTest, SunsTileRepeatsAsTheSamplerSays) {
  // 2 m by 1 m around (1, 0, 0.5).
  scene::LightView light = shiningDown(sun({0, -1, 0}, 10));
  light.position = {1, 7, 0.5f};
  const auto at = [](float tileX, float tileZ, float x, float z) {  // in units of tiles from the middle
    return glm::vec3(1 + 2 * (tileX + x), 0, 0.5f + tileZ + z);
  };
  for (const auto wrap : {scene::Wrap::kRepeat, scene::Wrap::kMirroredRepeat, scene::Wrap::kClampToEdge}) {
    wrap_ = wrap;
    SCOPED_TRACE(static_cast<int>(wrap));
    const bool mirrored = wrap == scene::Wrap::kMirroredRepeat, clamped = wrap == scene::Wrap::kClampToEdge;
    std::vector<std::pair<glm::vec3, glm::vec3>> wanted = {{at(0, 0, -0.25f, -0.25f), r},
                                                           {at(0, 0, 0.25f, -0.25f), g},
                                                           {at(0, 0, -0.25f, 0.25f), b},
                                                           {at(0, 0, 0.25f, 0.25f), w},
                                                           {at(-1, 0, -0.25f, -0.25f), mirrored ? g : r},
                                                           {at(-1, 0, 0.25f, -0.25f), mirrored || clamped ? r : g},
                                                           {at(0, -1, -0.25f, 0.25f), mirrored || clamped ? r : b},
                                                           {at(0, -1, 0.25f, -0.25f), mirrored ? w : g},
                                                           {at(-1, -1, -0.25f, -0.25f), mirrored ? w : r}};
    expectColors(quarters(4), light, wanted, 0.03f);
  }
}

TEST_F(CookieTest, PointLightsImageSurroundsIt) {
  // One metre above the floor; right is +X, up +Y, the image's middle at -Z.
  scene::LightView light = shiningDown(pointLight({0, 1, 0}, 30));
  light.worldFromLight = glm::mat3(1);
  std::vector<Texel> around;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 32; ++x) around.push_back(x < 8 ? kRed : x < 16 ? kGreen : x < 24 ? kBlue : kWhite);
  const std::vector<std::pair<glm::vec3, glm::vec3>> equirect = {
      {{-1, 0, 1}, r}, {{-1, 0, -1}, g}, {{1, 0, -1}, b}, {{1, 0, 1}, w}, {{2, 0, -2}, b}};
  expectColors(imageOf(32, 16, around), light, equirect, 0.02f);
  alpha_ = scene::AlphaMode::kBlend;
  expectColors(imageOf(32, 16, around), light, equirect, 0.02f);
  alpha_ = scene::AlphaMode::kOpaque;

  // Six faces of 8 x 8; the floor is seen by -Y, whose s is x and t is -z, and by the lower halves of the others.
  std::vector<Texel> strip;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 48; ++x) {
      const int face = x / 8;
      const bool left = x % 8 < 4, top = y < 4;
      strip.push_back(face == 3   ? (top ? (left ? kRed : kGreen) : (left ? kBlue : kWhite))
                      : top       ? kBlack
                      : face == 0 ? (left ? kRed : kGreen)
                      : face == 1 ? (left ? kBlue : kWhite)
                      : face == 4 ? (left ? kGreen : kRed)
                                  : (left ? kWhite : kBlue));
    }
  const std::vector<std::pair<glm::vec3, glm::vec3>> faces = {{{-0.5f, 0, 0.5f}, r},  {{0.5f, 0, 0.5f}, g},
                                                              {{-0.5f, 0, -0.5f}, b}, {{0.5f, 0, -0.5f}, w},
                                                              {{2, 0, 1}, r},         {{2, 0, -1}, g},    // +X: s is -z
                                                              {{-2, 0, -1}, b},       {{-2, 0, 1}, w},    // -X: s is z
                                                              {{-1, 0, 2}, g},        {{1, 0, 2}, r},     // +Z: s is x
                                                              {{1, 0, -2}, w},        {{-1, 0, -2}, b}};  // -Z: s is -x
  expectColors(imageOf(48, 8, strip), light, faces, 0.03f);

  // Maps of this size have no room for a cube's six faces: the light is an unshadowed one.
  options_.settings.shadowResolution = 16384;
  expectColors(imageOf(48, 8, strip), light, faces, 0.03f);
  EXPECT_EQ(stage().renderer().notes().size(), 1u);
}

TEST_F(CookieTest, LightsWithoutOneAreAsBefore) {
  scene::LightView plain = spotLight({1, 3, 0}, {0, 0, 0}, 100, 0.6f);
  const scene::LightView other = shiningDown(spotLight({-2, 3, 0}, {-2, 0, 0}, 50, 0.4f));
  scene::LightView dark = other;
  dark.light.cookie->texture = 1;
  const scene::Image image = quarters(4);
  const Shot alone = shoot(image, plain), beside = shoot(image, plain, {dark});
  for (std::size_t i = 0; i < alone.color.size(); ++i) ASSERT_EQ(alone.color[i], beside.color[i]) << i;
  // White lets all light through; gone again, nothing is left of it.
  scene::LightView bare = other;
  bare.light.cookie.reset();
  const Shot white = shoot(imageOf(2, 2, std::vector<Texel>(4, kWhite)), other), without = shoot(image, bare);
  for (std::size_t i = 0; i < white.color.size(); ++i) ASSERT_EQ(white.color[i], without.color[i]) << i;
}

/// Takes down what effects are told, and reads each light's cookie in a pass of its own.
struct Listener : Effect {
  std::vector<ShadowedLight> lights;
  std::vector<gpu::ImageDesc> images;
  Result<ImageRef> addPasses(const EffectInput& input) override {
    lights = input.lights;
    images.clear();
    for (const ShadowedLight& light : lights) {
      images.push_back(input.graph.desc(light.cookie));
      const gpu::ViewDesc layers{0, 0, light.cookieLayer, std::max(1u, light.cookieFaces), true};
      input.graph.pass("listen").use(light.cookie, Use::kSampledCompute).keep().run([=](PassContext& context) {
        EXPECT_NE(context.view(light.cookie, layers), VkImageView{VK_NULL_HANDLE});
      });
    }
    return ImageRef{};
  }
  DebugImage debugImage(const std::string&) override { return {}; }
};

TEST_F(CookieTest, EffectsAreGivenThem) {
  Listener listener;
  options_.effect = &listener;
  const scene::LightView spot = shiningDown(spotLight({0, 3, 0}, {0, 0, 0}, 100, 0.6f));
  scene::LightView point = shiningDown(pointLight({0, 1, 0}, 30)), bare = spot;
  point.light.cookie->texture = 1;  // 2:1
  bare.light.cookie.reset();
  shoot(quarters(8), spot, {bare, point, sun({0, -1, 0}, 1)});
  ASSERT_EQ(listener.lights.size(), 4u);
  EXPECT_EQ(listener.lights[0].cookieFaces, 1u);
  EXPECT_EQ(listener.lights[1].cookieFaces, 0u);
  EXPECT_EQ(listener.lights[2].cookieFaces, 6u);
  EXPECT_EQ(listener.lights[3].cookieFaces, 0u);
  EXPECT_EQ(listener.images[0].layers, 7u) << "one of the spot light, six of the point light";
  EXPECT_EQ(listener.images[0].width, 16u);
  EXPECT_EQ(listener.images[0].mips, 5u);
  EXPECT_EQ(listener.lights[0].cookie, listener.lights[2].cookie);
  EXPECT_EQ(listener.images[1].width, 1u);
  EXPECT_EQ(listener.lights[1].cookie, listener.lights[3].cookie);
  EXPECT_TRUE(listener.lights[0].cookieLayer < listener.lights[2].cookieLayer ||
              listener.lights[0].cookieLayer >= listener.lights[2].cookieLayer + 6);
  const glm::vec4 p = listener.lights[0].cookieFromWorld * glm::vec4(3 * std::tan(0.6f), 0, 0, 1);
  EXPECT_NEAR(p.x / p.w, 1, 1e-6);

  shoot(imageOf(2000, 1, std::vector<Texel>(2000, kWhite)), spot);
  EXPECT_EQ(listener.images[0].width, 1024u) << "the most a layer has";
}

TEST_F(CookieTest, FarAwayAFineImageIsItsMeanInLinearLight) {
  std::vector<Texel> fine;
  for (int i = 0; i < 512 * 512; ++i) fine.push_back((i + i / 512) % 2 ? kWhite : kBlack);
  const scene::LightView spot = shiningDown(spotLight({0, 3, 0}, {0, 0, 0}, 100, 0.6f));
  std::vector<glm::vec3> places;
  for (int i = -8; i <= 8; ++i) places.push_back({0.15f * static_cast<float>(i), 0, 0.07f * static_cast<float>(i)});
  for (const glm::vec3& c : colors(imageOf(512, 512, fine), spot, places)) EXPECT_NEAR(c.r, 0.5f, 0.01f);
  // The coded mean would be 0.21. Grazing views have long footprints.
  camera_ = lookAt({0, 0.4f, 6}, {0, 0, 0}, 0.5f);
  for (const glm::vec3& c : colors(imageOf(512, 512, fine), spot, places)) EXPECT_NEAR(c.r, 0.5f, 0.01f);
}

}  // namespace
}  // namespace tyndall::render::test
