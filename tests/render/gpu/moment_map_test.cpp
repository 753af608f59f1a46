// Moment shadow maps against the Gaussian of the depth map they are made of, computed here in doubles.
#include "moment_reader.hpp"

namespace tyndall::render::test {
namespace {

struct MomentMap : FrameTest {
  Level level;
  scene::CameraView camera = lookAt({0, 4, 6}, {0, 0, 0});
  MomentMap() {
    const std::int32_t grey = level.material(Level::grey(188));
    level.quad({0, 0, 0}, {8, 0, 0}, {0, 0, -8}, grey);
    level.quad({0.3f, 1, 0.2f}, {1, 0, 0}, {0, 0.4f, -1}, grey);
    level.quad({-2, 2, 1}, {0.2f, 0, 0.1f}, {0, 0, -0.5f}, grey);
    level.quad({5, 3, 0}, {0, 3, 0}, {0, 0, 3}, grey);
  }

  std::vector<MomentReader::Light> read(const std::vector<scene::LightView>& lights, std::uint32_t precision,
                                        std::uint32_t size) {
    MomentReader reader(stage().device());
    Stage::Options options;
    options.settings.shadowPrecision = precision;
    options.settings.shadowResolution = size;
    options.effect = &reader;
    passes = stage().render(level.scene, camera, lights, options).passes;
    return reader.take();
  }
  std::vector<PassTime> passes;
};

/// Distance along the face's axis of what is stored as `depth`, and so its place between near (-1) and far (1) plane.
double signedDepth(const ShadowedLight& light, std::uint32_t face, double depth) {
  if (light.light.light.kind == scene::LightKind::kDirectional) return 2 * depth - 1;
  const glm::dmat4 worldFromClip = glm::inverse(glm::dmat4(light.clipFromWorld[face]));
  const auto distance = [&](double d) {
    const glm::dvec4 p = worldFromClip * glm::dvec4(0, 0, d, 1);
    return glm::distance(glm::dvec3(p) / p.w, glm::dvec3(light.light.position));
  };
  return 2 * (distance(depth) - distance(0)) / (distance(1) - distance(0)) - 1;
}

/// Peters et al. 2017, equation 3.
glm::dvec4 quantised(const glm::dvec4& b) {
  return {1.5 * b.x - 2 * b.z + 0.5, 4 * (b.y - b.w), std::sqrt(3) / 2 * b.x - 2 * std::sqrt(3) / 9 * b.z + 0.5,
          0.5 * (b.y + b.w)};
}

/// Mean of z to z^4 around texel (x, y) of a square map.
glm::dvec4 expectedAt(const std::vector<double>& z, int size, int x, int y) {
  glm::dvec4 sum(0);
  double total = 0;
  for (int j = -4; j <= 4; ++j)
    for (int i = -4; i <= 4; ++i) {
      const double weight = std::exp(-(i * i + j * j) / (2 * 1.5 * 1.5));
      const int column = std::clamp(x + i, 0, size - 1), row = std::clamp(y + j, 0, size - 1);
      const double v = z[static_cast<std::size_t>(row * size + column)];
      sum += weight * glm::dvec4(v, v * v, v * v * v, v * v * v * v);
      total += weight;
    }
  return sum / total;
}

TEST_F(MomentMap, HoldsTheGaussianOfTheLinearDepthsPowers) {
  const std::vector<scene::LightView> lights{sun({0.3f, -1, 0.2f}, 3), spotLight({2, 5, 2}, {0, 0, 0}, 30, 0.7f),
                                             pointLight({0, 2.5f, 0}, 20)};
  for (const std::uint32_t precision : {64u, 128u}) {
    for (const MomentReader::Light& light : read(lights, precision, 52)) {  // no multiple of a workgroup
      const auto kind = static_cast<int>(light.shadow.light.light.kind);
      ASSERT_EQ(light.moments[0].size(), light.shadow.light.light.kind == scene::LightKind::kPoint ? 6u : 1u);
      // 16 bits are rounded twice, the second time after an average. Depths of a perspective map are floats near 1, of
      // which little is left when they are made linear.
      const bool perspective = light.shadow.light.light.kind != scene::LightKind::kDirectional;
      const double tolerance = (precision == 64 ? 1.2 / 65535 : 2e-6) + (perspective ? 3e-5 : 0);
      double worst = 0, spread = 0;
      for (std::uint32_t face = 0; face < light.shadow.faceCount; ++face) {
        std::vector<double> z;
        for (const float depth : light.depth[face]) z.push_back(signedDepth(light.shadow, face, depth));
        for (int y = 0; y < 52; ++y)
          for (int x = 0; x < 52; ++x) {
            const glm::dvec4 b = expectedAt(z, 52, x, y);
            const glm::dvec4 difference =
                light.moments[0][face][static_cast<std::size_t>(y * 52 + x)] - (precision == 64 ? quantised(b) : b);
            for (int c = 0; c < 4; ++c) worst = std::max(worst, std::abs(difference[c]));
            spread = std::max(spread, b.y - b.x * b.x);
          }
      }
      EXPECT_LT(worst, tolerance) << "kind " << kind << ", " << precision << " bits";
      EXPECT_GT(spread, 0.05) << "something to blur; kind " << kind;
    }
  }
}

TEST_F(MomentMap, MipsAreMeansDownToOneTexel) {
  for (const std::uint32_t precision : {64u, 128u}) {
    const auto lights = read({sun({0.3f, -1, 0.2f}, 3), pointLight({0, 2.5f, 0}, 20)}, precision, 64);
    for (const MomentReader::Light& light : lights) {
      ASSERT_EQ(light.desc.mips, 7u);
      double worst = 0;
      for (std::size_t mip = 1; mip < light.moments.size(); ++mip)
        for (std::size_t face = 0; face < light.moments[mip].size(); ++face) {
          const std::size_t side = 64u >> mip;
          const auto& fine = light.moments[mip - 1][face];
          for (std::size_t y = 0; y < side; ++y)
            for (std::size_t x = 0; x < side; ++x) {
              const std::size_t at = 2 * y * 2 * side + 2 * x;
              const glm::dvec4 mean = 0.25 * (fine[at] + fine[at + 1] + fine[at + 2 * side] + fine[at + 2 * side + 1]);
              for (int c = 0; c < 4; ++c)
                worst = std::max(worst, std::abs(light.moments[mip][face][y * side + x][c] - mean[c]));
            }
        }
      EXPECT_LT(worst, precision == 64 ? 0.51 / 65535 : 1e-6);
    }
  }
}

std::size_t momentPasses(const std::vector<PassTime>& passes) {
  return static_cast<std::size_t>(
      std::count_if(passes.begin(), passes.end(), [](const PassTime& p) { return p.name.starts_with("moments "); }));
}

TEST_F(MomentMap, NothingIsSpentWhenNobodyReadsIt) {
  const std::vector<scene::LightView> lights{sun({0.3f, -1, 0.2f}, 3), pointLight({0, 2.5f, 0}, 20)};
  const auto shot = [&](ShadowMode mode, std::uint32_t precision) {
    Stage::Options options;
    options.settings.shadowMode = mode;
    options.settings.shadowPrecision = precision;
    return stage().render(level.scene, camera, lights, options);
  };
  const Shot narrow = shot(ShadowMode::kPcf, 64), wide = shot(ShadowMode::kPcf, 128);
  EXPECT_EQ(momentPasses(narrow.passes), 0u);
  EXPECT_EQ(momentPasses(wide.passes), 0u);
  // Depth maps of seven faces and of twelve directions of the sky, targets of the view's size; moments of these faces
  // alone would take twice to four times as much.
  EXPECT_EQ(narrow.statistics.transientBytesUnshared, wide.statistics.transientBytesUnshared);
  const std::uint64_t depths = 7ull * 512 * 512 * 4, sky = 12ull * 512 * 512 * 4;
  EXPECT_GT(narrow.statistics.transientBytesUnshared, depths + sky);
  EXPECT_LT(narrow.statistics.transientBytesUnshared, depths + sky + (2ull << 20));
  const Shot used = shot(ShadowMode::kMoments, 64);
  EXPECT_EQ(momentPasses(used.passes), 6u) << "two directions and mips for each light";
  EXPECT_GT(used.statistics.transientBytesUnshared, narrow.statistics.transientBytesUnshared + 4 * depths);
  // The effect reads the moments of one light of two: the other's are not made.
  struct OneLight : MomentReader {
    using MomentReader::MomentReader;
    Result<ImageRef> addPasses(const EffectInput& input) override {
      const std::vector<ShadowedLight> first{input.lights[0]};
      return MomentReader::addPasses({input.graph, input.view, input.depth, first, input.reset, input.drawCasters});
    }
  } one(stage().device());
  Stage::Options options;
  options.effect = &one;
  EXPECT_EQ(momentPasses(stage().render(level.scene, camera, lights, options).passes), 3u);
}

}  // namespace
}  // namespace tyndall::render::test
