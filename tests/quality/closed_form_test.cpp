// Scattering where the answer can be written down: nothing in the sun's way, and one plate in it.
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "pictures.hpp"
#include "scene/gltf.hpp"
#include "scene/write_glb.hpp"

namespace tyndall::quality {
namespace {

constexpr double kSigma = 0.03, kAlbedo = 0.9, kG = 0.5, kLux = 8;

/// Radiance of a fully lit ray of length s that meets the sun's direction of travel at `cosine` (of view and
/// towards-sun).
double lit(double s, double cosine) {
  const double d = 1 + kG * kG - 2 * kG * cosine;
  return kLux * kAlbedo * (1 - kG * kG) / (4 * std::numbers::pi * std::pow(d, 1.5)) * -std::expm1(-kSigma * s);
}

/// View direction of a pixel centre of the level's camera at 320x180, looking down -z.
glm::dvec3 ray(int x, int y) {
  const double up = std::tan(0.45), right = up * 320 / 180;
  return glm::normalize(glm::dvec3((-1 + (x + 0.5) / 160) * right, (1 - (y + 0.5) / 90) * up, -1));
}

const glm::vec3 kTravel{0.3f, -0.8f, -0.4f};
class ClosedForm : public QualityTest {
 protected:
  /// Every technique that is registered, at its defaults; the march with enough steps, in both spacings.
  std::vector<Arguments> each() const {
    std::vector<Arguments> all;
    for (const std::string& id : techniques()) {
      const std::string choice = "volumetrics.technique=" + id;
      if (id != "ray_march") {
        all.push_back({choice});
        continue;
      }
      all.push_back({choice, "volumetrics.steps=1024"});
      all.push_back({choice, "volumetrics.steps=1024", "volumetrics.march_spacing=distance"});
    }
    return all;
  }
};

TEST_F(ClosedForm, AnEmptyLevelIsFullyLit) {
  const std::string level = writeLevel("ground", {plate(-100, 100, -100, 100, 0)}, kTravel);
  const image::FloatImage depth = distance(level);
  image::FloatImage expected{320, 180, 4, std::vector<float>(320 * 180 * 4)};
  const glm::dvec3 towards = -glm::normalize(glm::dvec3(kTravel));
  for (int y = 0; y < 180; ++y)
    for (int x = 0; x < 320; ++x) {
      const double s = depth.at(x, y, 0);
      for (int c = 0; c < 3; ++c) expected.at(x, y, c) = static_cast<float>(lit(s, glm::dot(ray(x, y), towards)));
      expected.at(x, y, 3) = static_cast<float>(std::exp(-kSigma * s));
    }
  for (const Arguments& settings : each()) {
    const image::FloatImage picture = scatter(level, settings);
    // A prefiltered ray ends at the inclination of the very ground that ends it, where the bounds of the moments are
    // widest and a shadow texel decides on which side the ground lies: 0.024 (moments4) and 0.019 (moments6) were
    // measured.
    EXPECT_LT(nRmse(picture, expected), settings[0].ends_with("march") ? 0.002 : 0.03) << settings[0];
    for (std::size_t i = 3; i < picture.values.size(); i += 4) ASSERT_NEAR(picture.values[i], expected.values[i], 1e-4);
  }
}

// A large plate above: the shadow has one edge, so six and four moments and the march all know it exactly but for the
// resolution of their maps. Truth by ray tracing.
TEST_F(ClosedForm, OnePlateShadowsAlikeInEveryTechnique) {
  const std::string level = writeLevel("plate", {plate(-30, 30, -40, 20, 0), plate(-4, 4, -12, -2, 5)}, kTravel);
  const image::FloatImage reference = truth(level, 2048);
  for (const Arguments& settings : each()) {
    Arguments all = settings;
    all.push_back("shadows.resolution=2048");
    const double error = nRmse(scatter(level, all), reference);
    RecordProperty(settings[0], std::to_string(error));
    std::printf("one plate, %s: nRMSE %.4f\n", settings[0].c_str(), error);
    EXPECT_LT(error, settings[0].ends_with("march") ? 0.01 : 0.06) << settings[0];
  }
}

// The plate told to cast no shadow, by its node or by its material, beside ground that may: the air is lit all over, in
// the engine's maps, the plugin's and the truth.
TEST_F(ClosedForm, WhatIsToldToCastNoShadowCastsNone) {
  const std::string level = writeLevel("plate", {plate(-30, 30, -40, 20, 0), plate(-4, 4, -12, -2, 5)}, kTravel);
  const image::FloatImage shadowed = truth(level, 256);
  for (const bool byNode : {true, false}) {
    auto import = scene::loadGltf(folder_ / level);
    ASSERT_TRUE(import);
    scene::Scene& s = import->scene;
    scene::Primitive& above = s.meshes[0].primitives[1];
    if (byNode) {
      scene::Node own;
      own.mesh = static_cast<std::int32_t>(s.meshes.size());
      own.castsShadow = false;
      s.nodes.push_back(own);
      s.meshes.push_back({"plate", {above}});
      s.meshes[0].primitives.pop_back();
    } else {
      above.material = static_cast<std::int32_t>(s.materials.size());
      s.materials.push_back(s.materials[0]);
      s.materials.back().castsShadow = false;
    }
    ASSERT_TRUE(scene::writeGlb(s, folder_ / "open.glb"));
    // Of the distances that each of the two sees: they differ in pixels at the plate's edges.
    const auto litUpTo = [](const image::FloatImage& depth) {
      image::FloatImage picture{320, 180, 4, std::vector<float>(320 * 180 * 4)};
      const glm::dvec3 towards = -glm::normalize(glm::dvec3(kTravel));
      for (int y = 0; y < 180; ++y)
        for (int x = 0; x < 320; ++x)
          for (int c = 0; c < 3; ++c)
            picture.at(x, y, c) = static_cast<float>(lit(depth.at(x, y, 0), glm::dot(ray(x, y), towards)));
      return picture;
    };
    const cli::Outcome traced =
        tyndall({"truth", "open.glb", "--size", "320x180", "--samples", "256", "--out", "t.exr", "--depth", "td.exr"});
    ASSERT_EQ(traced.status, 0) << traced.err;
    EXPECT_LT(nRmse(read("t.exr"), litUpTo(read("td.exr"))), 1e-3) << byNode;
    const image::FloatImage expected = litUpTo(distance("open.glb"));
    EXPECT_GT(nRmse(shadowed, expected), 0.05) << "the plate does shadow when it may";
    for (const char* technique : {"ray_march", "exact"})
      EXPECT_LT(nRmse(scatter("open.glb", {std::string("volumetrics.technique=") + technique}), expected), 0.002)
          << technique << byNode;
  }
}

// A parameter that is read changes the picture; the medium behaves as physics says.
TEST_F(ClosedForm, TheMediumActsAsItShould) {
  const std::string level = writeLevel("ground", {plate(-100, 100, -100, 100, 0)}, kTravel);
  const auto mean = [](const image::FloatImage& picture, int channel) {
    double sum = 0;
    for (std::size_t i = static_cast<std::size_t>(channel); i < picture.values.size(); i += 4) sum += picture.values[i];
    return sum / (320 * 180);
  };
  const image::FloatImage base = scatter(level, {});
  const image::FloatImage half = scatter(level, {"medium.albedo=0.45"});
  EXPECT_NEAR(mean(half, 0) / mean(base, 0), 0.5, 1e-4);
  const image::FloatImage none = scatter(level, {"medium.sigma_t=0"});
  EXPECT_EQ(mean(none, 0), 0);
  EXPECT_EQ(mean(none, 3), 1);
}

// A camera without a far plane sees all of a level kilometres long, as one whose far plane lies behind it does, and
// any near plane is a picture.
TEST_F(ClosedForm, WithoutAFarPlaneTheLevelIsSeenToItsEnd) {
  const std::vector<scene::Primitive> things{plate(-3000, 3000, -7000, 20, 0), plate(-400, 500, -5000, -2000, 900)};
  const auto pictures = [&](const std::string& name, float znear, std::optional<float> zfar) {
    const std::string level = writeLevel(name, things, kTravel, {"eye", 0.9f, znear, zfar});
    const cli::Outcome outcome = tyndall({"render", level, "--size", "64x36", "--scatter", name + "s.exr", "--depth",
                                          name + "d.exr", "--set", "medium.sigma_t=0.0003"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(tyndall({"truth", level, "--size", "64x36", "--samples", "64", "--out", name + "t.exr", "--set",
                       "medium.sigma_t=0.0003"})
                  .status,
              0);
    return std::array{read(name + "s.exr"), read(name + "d.exr"), read(name + "t.exr")};
  };
  const auto finite = pictures("finite", 0.1f, 20000.0f), open = pictures("open", 0.1f, {});
  int level = 0, beyond = 0;
  for (std::size_t i = 0; i < finite[1].values.size(); ++i) {
    if (finite[1].values[i] >= 19000) continue;  // sky: its air ends elsewhere
    ++level;
    beyond += finite[1].values[i] > 1100 ? 1 : 0;
    EXPECT_NEAR(open[1].values[i], finite[1].values[i], 1e-4 * finite[1].values[i]);
    for (const std::size_t picture : {0u, 2u})
      for (std::size_t c = 0; c < 4; ++c)
        EXPECT_NEAR(open[picture].values[4 * i + c], finite[picture].values[4 * i + c], picture == 0 ? 0.02 : 1e-4);
  }
  EXPECT_GT(level, 1000);
  EXPECT_GT(beyond, 100);
  for (const float near : {999.999f, 1000.0f, 2000.0f, 1e6f}) {
    const auto far = pictures("near", near, {});
    for (const float t : far[1].values) EXPECT_GT(t, near) << "the near plane cuts";
    for (const float radiance : far[0].values) ASSERT_TRUE(std::isfinite(radiance));
  }
}

}  // namespace
}  // namespace tyndall::quality
