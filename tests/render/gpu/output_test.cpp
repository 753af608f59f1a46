// Composition, tone map, debug views, effects.
#include "stage.hpp"

namespace tyndall::render::test {
namespace {

using OutputTest = FrameTest;

// Writes the same scatter and transmittance everywhere, and looks at what it was given.
class FlatEffect : public Effect {
 public:
  explicit FlatEffect(const glm::vec4& value) : value_(value) {}
  Result<ImageRef> addPasses(const EffectInput& input) override {
    lights = input.lights;
    gpu::ImageDesc desc = input.graph.desc(input.depth);
    desc.name = "flat";
    desc.format = VK_FORMAT_R32G32B32A32_SFLOAT;
    const ImageRef scatter = input.graph.image(desc, "test");
    const VkClearColorValue color{{value_.r, value_.g, value_.b, value_.a}};
    input.graph.pass("flat", "test").use(scatter, Use::kColorWrite).run([=](PassContext& context) {
      context.beginRendering({{scatter, true, color}});
      context.endRendering();
    });
    // The casters again, as a plugin's caster pass would draw them.
    gpu::ImageDesc mapDesc;
    mapDesc.name = "own map";
    mapDesc.format = VK_FORMAT_D32_SFLOAT;
    mapDesc.width = mapDesc.height = 64;
    map_ = input.graph.image(mapDesc, "test");
    input.graph.pass("own map", "test")
        .use(map_, Use::kDepthWrite)
        .keep()
        .run([map = map_, draw = input.drawCasters,
              matrix = input.lights.empty() ? glm::mat4(1) : input.lights[0].clipFromWorld[0]](PassContext& context) {
          const PassContext::DepthAttachment depth{map, true, 1.0f};
          context.beginRendering({}, &depth);
          draw(context, matrix);
          context.endRendering();
        });
    return scatter;
  }
  DebugImage debugImage(const std::string& name) override {
    return name == "own_map" ? DebugImage{map_, {}, 0, 0, 1} : DebugImage{};
  }
  std::vector<ShadowedLight> lights;

 private:
  glm::vec4 value_;
  ImageRef map_;
};

Level floorLevel() {
  Level level;
  level.quad({0, 0, 0}, {4, 0, 0}, {0, 0, -4}, level.material(Level::grey(188)));
  level.quad({0, 1, 0}, {1, 0, 0}, {0, 0, -1}, level.material(Level::grey(80)));
  return level;
}

double srgb(double c) { return 255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055); }

// Narkowicz's fit of the ACES curve.
double filmic(double x) { return std::clamp((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0); }

TEST_F(OutputTest, PictureIsColorTimesTransmittancePlusScatter) {
  const Level level = floorLevel();
  const scene::CameraView camera = lookAt({0, 3, 4}, {0, 0, 0});
  FlatEffect effect({0.1f, 0.2f, 0.3f, 0.25f});
  Stage::Options options;
  options.effect = &effect;
  options.settings.exposure = 0.5f;
  const Shot shot = stage().render(level.scene, camera, {sun({0.1f, -1, 0.2f}, 4)}, options);
  ASSERT_EQ(effect.lights.size(), 1u);
  EXPECT_EQ(effect.lights[0].size, 512u);
  int checked = 0;
  for (std::size_t p = 0; p < shot.color.size(); ++p) {
    const glm::dvec3 c = 0.5 * (glm::dvec3(shot.color[p]) * 0.25 + glm::dvec3(0.1, 0.2, 0.3));
    ++checked;
    ASSERT_NEAR(shot.picture[p].r, srgb(filmic(c.r)), 1.01);
    ASSERT_NEAR(shot.picture[p].b, srgb(filmic(c.b)), 1.01);
    ASSERT_EQ(shot.picture[p].a, 255);
  }
  EXPECT_GT(checked, 500);
}

TEST_F(OutputTest, EveryDebugViewShowsSomething) {
  const Level level = floorLevel();
  const scene::CameraView camera = lookAt({0, 3, 4}, {0, 0, 0});
  for (const bool withEffect : {false, true}) {
    FlatEffect effect({0.1f, 0.2f, 0.3f, 0.5f});
    Stage::Options options;
    options.effect = withEffect ? &effect : nullptr;
    std::vector<DebugViewInfo> views = Renderer::debugViews();
    if (withEffect) views.push_back({"own_map", ""});
    for (const DebugViewInfo& view : views) {
      options.settings.debugView = view.name;
      const Shot shot = stage().render(level.scene, camera, {sun({0, -1, 0}, 4)}, options);
      const glm::u8vec4 middle = shot.picture[32 * 64 + 32];
      if (view.name == "normal") {
        EXPECT_NEAR(middle.r, 127.5, 0.51);
        EXPECT_EQ(middle.g, 255);
        EXPECT_NEAR(middle.b, 127.5, 0.51);
      }
      if (view.name == "base_color") {
        EXPECT_NEAR(middle.r, 188, 1);
      }
      if (view.name == "roughness" || view.name == "occlusion") {
        EXPECT_EQ(middle.r, 255);
      }
      if (view.name == "metallic") {
        EXPECT_EQ(middle.r, 0);
      }
      if (view.name == "transmittance") {
        EXPECT_NEAR(middle.r, withEffect ? 128 : 255, 1);
      }
      if (view.name == "scatter") {
        EXPECT_NEAR(middle.b, withEffect ? srgb(0.3) : 0, 1);
      }
      if (view.name == "shadow_map" || view.name == "own_map") {
        // The raised quad's depth and the floor's.
        EXPECT_LT(middle.r, 30) << view.name;
        EXPECT_GT(shot.picture[2 * 64 + 2].r, 200) << view.name;
      }
    }
  }
}

TEST_F(OutputTest, LightsBeyondTheBudgetHaveSmallerMapsAndOneLine) {
  const Level level = floorLevel();
  std::vector<scene::LightView> lights;
  for (int i = 0; i < 3; ++i) lights.push_back(pointLight({static_cast<float>(i), 3, 0}, 5));
  lights.push_back(sun({0, -1, 0}, 1));
  Stage::Options options;
  options.settings.shadowResolution = 8192;  // 256 MiB a face
  options.width = options.height = 8;
  FlatEffect effect({0, 0, 0, 1});
  options.effect = &effect;
  stage().render(level.scene, lookAt({0, 3, 4}, {0, 0, 0}), lights, options);
  ASSERT_EQ(stage().renderer().notes().size(), 1u);
  EXPECT_NE(stage().renderer().notes()[0].find("4 of 4 lights have smaller shadow maps"), std::string::npos)
      << stage().renderer().notes()[0];
  ASSERT_EQ(effect.lights.size(), 4u);
  // Nineteen faces in the memory of four of 8192: the sun's, of the strongest light, is the largest.
  for (const ShadowedLight& light : effect.lights) {
    EXPECT_GE(light.size, 2048u);
    EXPECT_LE(light.size, 4096u);
    if (light.light.light.kind == scene::LightKind::kDirectional) {
      EXPECT_EQ(light.size, 4096u);
    }
  }
}

}  // namespace
}  // namespace tyndall::render::test
