// Surfaces lit through moment shadow maps: like percentage-closer filtering away from a shadow's edge, with the edge of
// the maps' Gaussian, and with no more light leaking than the bias allows.
#include "moment_reader.hpp"

namespace tyndall::render::test {
namespace {

constexpr std::uint32_t kMapSize = 256, kPicture = 128;

/// A floor and a square plate over it.
struct Scene {
  Level level;
  float height, half;
  Scene(float plateHeight, float plateHalf, bool blended = false) : height(plateHeight), half(plateHalf) {
    scene::Material floor = Level::grey(188);
    if (blended) floor.alphaMode = scene::AlphaMode::kBlend;
    const std::int32_t grey = level.material(Level::grey(188));
    // Blended surfaces cast no shadow and hide nothing: an opaque floor a little lower keeps the view closed and the
    // depth range the same.
    if (blended) level.quad({0, -0.01f, 0}, {8, 0, 0}, {0, 0, -8}, grey);
    level.quad({0, 0, 0}, {8, 0, 0}, {0, 0, -8}, level.material(floor));
    if (half > 0) level.quad({0, height, 0}, {half, 0, 0}, {0, 0, -half}, grey);
  }
};

struct MomentShadow : FrameTest {
  scene::CameraView camera = lookAt({0, 4, 9}, {0, 0, 0});

  Shot shoot(const Scene& scene, const std::vector<scene::LightView>& lights, ShadowMode mode, std::uint32_t precision,
             Effect* effect = nullptr) {
    Stage::Options options;
    options.width = options.height = kPicture;
    options.settings.skyStrength = 0;  // lamps alone
    options.settings.shadowMode = mode;
    options.settings.shadowPrecision = precision;
    options.settings.shadowResolution = kMapSize;
    options.effect = effect;
    return stage().render(scene.level.scene, camera, lights, options);
  }

  glm::vec3 worldAt(const Shot& shot, std::uint32_t x, std::uint32_t y) const {
    const View view = makeView(camera, kPicture, kPicture);
    const glm::vec2 ndc = (glm::vec2(x, y) + 0.5f) / (0.5f * kPicture) - 1.0f;
    const glm::vec3 ray = glm::normalize(glm::vec3(
        view.worldFromView * glm::vec4(ndc.x * view.viewFromClip[0][0], ndc.y * view.viewFromClip[1][1], -1, 0)));
    return view.eye + ray * shot.distance[y * kPicture + x];
  }
};

/// Texels from a map's texel place to the border of the plate's image, negative inside; the plate is seen as a convex
/// quadrangle because all of it lies before the light.
double fromEdge(const ShadowedLight& light, const Scene& scene, const glm::vec3& world) {
  const std::uint32_t face = light.faceCount == 6 ? 3 : 0;  // -Y
  const auto texel = [&](const glm::vec3& p) {
    const glm::dvec4 clip = glm::dmat4(light.clipFromWorld[face]) * glm::dvec4(p, 1);
    return (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * static_cast<double>(light.size);
  };
  const glm::dvec2 p = texel(world);
  glm::dvec2 corners[4];
  const float h = scene.half;
  int i = 0;
  for (const glm::vec2 s : {glm::vec2(-h, -h), glm::vec2(h, -h), glm::vec2(h, h), glm::vec2(-h, h)})
    corners[i++] = texel({s.x, scene.height, s.y});
  const glm::dvec2 center = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
  double inside = -1e30, outside = 1e30;
  for (int k = 0; k < 4; ++k) {
    const glm::dvec2 a = corners[k], edge = corners[(k + 1) % 4] - a;
    glm::dvec2 normal = glm::normalize(glm::dvec2(edge.y, -edge.x));
    if (glm::dot(normal, center - a) > 0) normal = -normal;
    inside = std::max(inside, glm::dot(normal, p - a));
    const double along = std::clamp(glm::dot(p - a, edge) / glm::dot(edge, edge), 0.0, 1.0);
    outside = std::min(outside, glm::distance(p, a + along * edge));
  }
  return inside < 0 ? inside : outside;
}

std::vector<scene::LightView> lightKinds() {
  return {sun({0.2f, -1, 0.1f}, 10), spotLight({0.4f, 6, 0.3f}, {0, 0, 0}, 300, 0.7f),
          pointLight({0.4f, 6, 0.3f}, 300)};
}

/// What the sun, spot or point light alone gives to each pixel of the floor.
struct Direct {
  Shot open, roofed;
  double at(std::size_t pixel) const { return double{open.color[pixel].g} - roofed.color[pixel].g; }
  double share(const Shot& shot, std::size_t pixel) const {
    return (double{shot.color[pixel].g} - roofed.color[pixel].g) / at(pixel);
  }
};

TEST_F(MomentShadow, EqualsPcfAwayFromTheEdge) {
  for (const bool blended : {false, true}) {
    const Scene roofed(5.5f, 7.9f, blended), plate(2, 1.6f, blended);
    Scene unshadowed(2, 0, true);  // without its opaque floor nothing casts a shadow, not even on itself
    unshadowed.level.scene.nodes.erase(unshadowed.level.scene.nodes.begin());
    for (const scene::LightView& light : lightKinds()) {
      const auto kind = static_cast<int>(light.light.kind);
      MomentReader reader(stage().device());
      const Direct direct{shoot(unshadowed, {light}, ShadowMode::kPcf, 64),
                          shoot(roofed, {light}, ShadowMode::kPcf, 64)};
      const Shot pcf = shoot(plate, {light}, ShadowMode::kPcf, 64, &reader);
      const ShadowedLight shadow = reader.take().at(0).shadow;
      for (const std::uint32_t precision : {64u, 128u}) {
        const Shot moments = shoot(plate, {light}, ShadowMode::kMoments, precision);
        int lit = 0, dark = 0, between = 0;
        double apart = 0;
        for (std::uint32_t y = 0; y < kPicture; ++y)
          for (std::uint32_t x = 0; x < kPicture; ++x) {
            const std::size_t pixel = y * kPicture + x;
            const float distance = direct.roofed.distance[pixel];
            const glm::vec3 world = worldAt(pcf, x, y);
            if (distance > 20 || pcf.distance[pixel] != distance || direct.at(pixel) < 0.05 ||
                std::abs(world.y) > 0.02f ||
                std::max(std::abs(world.x), std::abs(world.z)) > 7)  // the floor's own edge is one too
              continue;
            const double edge = fromEdge(shadow, plate, world);
            // The Gaussian ends after 4 texels; a pixel covers up to 4 of the map, which mips and the offset of the
            // receiver stretch the filter by.
            const double reach = 16;
            const double share = direct.share(moments, pixel);
            if (edge > reach) {
              ++lit;
              ASSERT_NEAR(share, 1, 0.01) << "kind " << kind << ", " << precision << " bits, pixel " << x << ' ' << y;
            } else if (edge < -reach) {
              ++dark;
              // The plate is so far above the floor that the bias leaks less than the 2 percent that over-darkening
              // takes.
              ASSERT_NEAR(share, 0, 0.002) << "kind " << kind << ", " << precision << " bits, pixel " << x << ' ' << y;
            } else if (share > 0.1 && share < 0.9) {
              ++between;
            }
            if (std::abs(edge) > reach) {
              // Where light grazes, percentage-closer filtering at 256 texels shadows itself a little; moments do not.
              const double other = direct.share(pcf, pixel);
              apart += std::abs(share - other);
              ASSERT_LT(std::abs(share - other), 0.04);
            }
          }
        EXPECT_LT(apart / (lit + dark), 2e-3) << "mean difference to pcf; kind " << kind;
        EXPECT_GT(lit, 1000) << "kind " << kind;
        EXPECT_GT(dark, 50) << "kind " << kind;
        EXPECT_GT(between, 50) << "a soft edge; kind " << kind;
      }
    }
  }
}

TEST_F(MomentShadow, TheEdgeIsAsSoftAsTheGaussian) {
  // From under the plate straight down on the edge of its shadow, so near that a pixel is a small part of a texel.
  const Scene open(3, 0), roofed(4, 7.9f), plate(3, 2);
  const scene::LightView light = sun({0, -1, 0}, 10);
  camera = lookAt({2, 2, 0}, {2, 0, 0}, 0.5f);
  MomentReader reader(stage().device());
  const Direct direct{shoot(open, {light}, ShadowMode::kPcf, 64), shoot(roofed, {light}, ShadowMode::kPcf, 64)};
  const Shot pcf = shoot(plate, {light}, ShadowMode::kPcf, 64, &reader);
  const ShadowedLight shadow = reader.take().at(0).shadow;
  // Texels from where the share is `low` to where it is `high`, along the row in the middle of the picture.
  const auto width = [&](const Shot& shot, double low, double high) {
    double places[2] = {NAN, NAN};
    double lastShare = 0, lastEdge = 0;
    for (std::uint32_t x = 0; x < kPicture; ++x) {
      const std::size_t pixel = kPicture / 2 * kPicture + x;
      const double share = direct.share(shot, pixel), edge = fromEdge(shadow, plate, worldAt(shot, x, kPicture / 2));
      for (int i = 0; i < 2; ++i) {
        const double wanted = i ? high : low;
        if (x > 0 && lastShare < wanted && share >= wanted)
          places[i] = lastEdge + (edge - lastEdge) * (wanted - lastShare) / (share - lastShare);
      }
      lastShare = share;
      lastEdge = edge;
    }
    return places[1] - places[0];
  };
  const double sharp = width(pcf, 0.16, 0.84);
  for (const std::uint32_t precision : {64u, 128u}) {
    // One standard deviation to each side; 1.5 texels of the Gaussian and 0.4 of the bilinear filter make 1.55.
    const double soft = width(shoot(plate, {light}, ShadowMode::kMoments, precision), 0.16, 0.84);
    EXPECT_NEAR(soft / 2, 1.55, 0.15) << precision << " bits";
    EXPECT_GT(soft, 1.25 * sharp);
  }
}

TEST_F(MomentShadow, LeaksNoMoreLightThanTheBiasAllows) {
  // A low plate in the middle of a deep depth range, where the bias tells most: a mast reaches ten metres up and down.
  Scene open(0.15f, 0), plate(0.15f, 1), roofed(9, 7.9f);
  for (Scene* scene : {&open, &plate, &roofed}) scene->level.quad({-7.5f, 0, -7.5f}, {0, 10, 0}, {0.05f, 0, 0}, 0);
  const scene::LightView light = sun({0, -1, 0}, 10);
  camera = lookAt({0, 0.05f, 3}, {0, 0, 0}, 0.5f);  // under the plate
  MomentReader reader(stage().device());
  const Direct direct{shoot(open, {light}, ShadowMode::kPcf, 64), shoot(roofed, {light}, ShadowMode::kPcf, 64)};
  const Shot pcf = shoot(plate, {light}, ShadowMode::kPcf, 64, &reader);
  const MomentReader::Light map = reader.take().at(0);
  double leaks[2]{};
  for (const std::uint32_t precision : {64u, 128u}) {
    const Shot moments = shoot(plate, {light}, ShadowMode::kMoments, precision);
    // One depth z, biased by alpha towards moments 0, t, 0, t: variance v = alpha (t + z^2) at most. Of a distribution
    // with that variance at most v / (v + x^2) lies a distance x or more beyond its mean (Cantelli), over-darkening
    // takes 2 percent off.
    const double alpha = precision == 64 ? 6e-5 : 1e-6, target = precision == 64 ? 0.628 : 0.375;
    int dark = 0;
    double gaps = 0;
    for (std::uint32_t y = 0; y < kPicture; ++y)
      for (std::uint32_t x = 0; x < kPicture; ++x) {
        const std::size_t pixel = y * kPicture + x;
        if (pcf.distance[pixel] != direct.open.distance[pixel] || direct.open.distance[pixel] > 20) continue;
        const glm::vec3 world = worldAt(pcf, x, y);
        if (std::abs(world.y) > 0.01f || fromEdge(map.shadow, plate, world) > -12) continue;
        const auto depthOf = [&](float height) {
          return 2 * (glm::dmat4(map.shadow.clipFromWorld[0]) * glm::dvec4(world.x, height, world.z, 1)).z - 1;
        };
        // The receiver is moved towards the light by half a texel.
        const float texel = 2 / glm::length(glm::vec3(map.shadow.clipFromWorld[0][0])) / kMapSize;
        const double z = depthOf(0.15f), gap = depthOf(0.5f * texel) - z, v = alpha * (target + z * z);
        const double bound = std::max(0.0, 1 - (1 - v / (v + gap * gap)) / 0.98);
        const double share = direct.share(moments, pixel);
        ++dark;
        gaps = std::max(gaps, gap);
        ASSERT_LT(share, bound + 0.01) << precision << " bits, gap " << gap;
        leaks[precision / 128] = std::max(leaks[precision / 128], share);
      }
    EXPECT_GT(dark, 200) << precision;
    EXPECT_LT(gaps, 0.02) << "a contact shadow";
  }
  std::printf("light that leaks: %.4f at 64 bits, %.4f at 128\n", leaks[0], leaks[1]);
  EXPECT_GT(leaks[0], 0.03) << "16 bits do leak here: the test looks where it should";
  EXPECT_LT(leaks[1], 0.005);
}

TEST_F(MomentShadow, NoAcneOnTiltedSurfaces) {
  const Scene open(2, 0);
  for (const float slope : {1.0f, 0.3f, 0.1f}) {
    const scene::LightView light = sun({1, -slope, 0.3f}, 10);
    const Shot pcf = shoot(open, {light}, ShadowMode::kPcf, 64);
    for (const std::uint32_t precision : {64u, 128u}) {
      const Shot moments = shoot(open, {light}, ShadowMode::kMoments, precision);
      int lit = 0;
      for (std::size_t p = 0; p < moments.color.size(); ++p) {
        if (moments.distance[p] > 50) continue;
        ++lit;
        ASSERT_GT(moments.color[p].r, 0.98 * pcf.color[p].r) << "slope " << slope << ", pixel " << p;
      }
      EXPECT_GT(lit, 4000);
    }
  }
}

}  // namespace
}  // namespace tyndall::render::test
