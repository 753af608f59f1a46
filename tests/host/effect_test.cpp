// Plugins run on the device: the template against the closed form, and every kind of pass against its arithmetic.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "frame_fixture.hpp"
#include "host/abi.hpp"

namespace tyndall::host {
namespace {

using scene::LightKind;
using testing::ElementsAre;
using testing::Pair;

const std::filesystem::path kTemplate = std::filesystem::path(TYNDALL_BIN_DIR) / "sample_plugins/fog_depth.so";
const std::filesystem::path kPasses = std::filesystem::path(TYNDALL_TEST_PLUGINS) / "passes.so";

struct Effect : FrameFixture {};

TEST_F(Effect, theTemplateIsTheClosedForm) {
  load(kTemplate);
  addLight(LightKind::kDirectional, {1.0f, 0.5f, 0.25f}, 1000.0f, 1.0f);
  ASSERT_TRUE(table_.setAssignment("fog_depth.sigma_t=0.07"));
  const double sigma = 0.07, albedo = 0.8, n = 0.25, f = 80, tangent = std::tan(1.1 / 2);
  for (const char* tile : {"8", "16"}) {
    ASSERT_TRUE(table_.setText("fog_depth.tile", tile));
    const Picture picture = frame();
    ASSERT_FALSE(picture.empty);
    double worst = 0;
    for (std::uint32_t y = 0; y < kHeight; ++y)
      for (std::uint32_t x = 0; x < kWidth; ++x) {
        const double d = depths_[y * kWidth + x], z = n * f / (d * (f - n) + n);
        const double rx = ((x + 0.5) / kWidth * 2 - 1) * tangent * kWidth / kHeight,
                     ry = ((y + 0.5) / kHeight * 2 - 1) * tangent;
        const double s = z * std::sqrt(1 + rx * rx + ry * ry), t = std::exp(-sigma * s);
        const glm::vec4 got = picture.at(x, y);
        const double light = 1000 * albedo * (1 - t) / (4 * std::numbers::pi);
        worst = std::max({worst, std::abs(got.a - t), std::abs(got.r - light) / 1000,
                          std::abs(got.g - light * 0.5) / 1000, std::abs(got.b - light * 0.25) / 1000});
      }
    EXPECT_LT(worst, 2e-6) << "tile " << tile;
  }
  EXPECT_TRUE(ran("fog"));
  EXPECT_EQ(effect_->memoryBytes(), kWidth * kHeight * 16u);
  EXPECT_EQ(effect_->bytesMoved(), kWidth * kHeight * 16u) << "the picture is written, and the depth is the engine's";
}

TEST_F(Effect, nothingToDoIsAnEmptyRef) {
  load(kTemplate);
  EXPECT_TRUE(frame().empty) << "no light at all";
  addLight(LightKind::kPoint, glm::vec3(1), 1, 1);
  EXPECT_TRUE(frame().empty) << "no sun";
  EXPECT_FALSE(effect_->failure());
  EXPECT_EQ(effect_->debugImage("fog_transmittance").image, render::ImageRef{});
}

TEST_F(Effect, everyKindOfPass) {
  load(kPasses);
  addLight(LightKind::kDirectional, glm::vec3(2, 0, 0), 1.5f, 0.25f);
  addLight(LightKind::kSpot, glm::vec3(1, 0, 0), 7.0f, 0.5f);
  addLight(LightKind::kPoint, glm::vec3(4, 0, 0), 1.0f, 1.0f);
  ASSERT_TRUE(table_.setAssignment("passes.weight=10"));
  ASSERT_TRUE(table_.setAssignment("passes.variant=one"));  // not tuned: a change of variant starts history anew
  for (int count = 1; count <= 5; ++count) {
    const Picture picture = frame();
    ASSERT_FALSE(picture.empty);
    for (std::uint32_t y = 0; y < kHeight; ++y)
      for (std::uint32_t x = 0; x < kWidth; ++x) {
        const auto frames = static_cast<float>(count);
        ASSERT_EQ(picture.at(x, y), glm::vec4(frames + 30 + 70 + 40 + 1000 * (0.25f + 0.5f + 1.0f), frames,
                                              0.25f + static_cast<float>(x) + 100.0f * static_cast<float>(y), 0.5f))
            << x << ' ' << y << " frame " << count;
      }
    EXPECT_THAT(effect_->counters(), ElementsAre(Pair("groups run", 10), Pair("twice that", 20)));
  }
  for (const char* pass : {"arguments", "count", "history", "clear", "light [light 0]", "add [light 0]",
                           "light [light 2]", "add [light 2]", "accumulate"})
    EXPECT_TRUE(ran(pass)) << pass;
  EXPECT_FALSE(ran("light [light 3]"));
  for (const auto& time : times_) EXPECT_TRUE(time.owner == "passes" || time.name == "read back") << time.name;
  EXPECT_FALSE(effect_->bytesMoved()) << "two lights take turns";
  // Two full-size RGBA32F images, one R32F, the output, 3 layers of 2 mips, three buffers.
  const std::uint64_t texels = kWidth * kHeight;
  EXPECT_EQ(effect_->memoryBytes(), texels * (16 + 16 + 4 + 16) + 3 * 4 * (4 * texels + texels) + 16 + 8 + 16);
}

TEST_F(Effect, aPerLightPassReadsItsLightsMomentShadowMap) {
  load(kPasses);
  addLight(LightKind::kDirectional, glm::vec3(1), 1, 0);
  addLight(LightKind::kPoint, glm::vec3(1), 1, 0);
  ASSERT_TRUE(table_.setAssignment("passes.moments=1"));
  gpu::Buffer shown;
  const Picture picture = frame(false, [&](render::Graph& graph) {
    const auto view = effect_->debugImage("moments");
    ASSERT_TRUE(view.image);
    EXPECT_EQ(view.channel, 2u);
    shown = copyOut(graph, view.image);
  });
  ASSERT_FALSE(picture.empty);
  // Two lights of weight 1, the format twice, halfway between mips 1 (100) and 2 (200), and the second light's own 1.
  EXPECT_EQ(picture.at(0, 0).r, 1 + 2 * (1 + 10 * TY_FORMAT_RGBA32_FLOAT + 150) + 1);
  EXPECT_EQ(reinterpret_cast<const glm::vec4*>(shown.mapped())->b, 0);
  const std::uint64_t bytes = effect_->memoryBytes();
  ASSERT_TRUE(table_.setAssignment("passes.moments=0"));
  frame();
  EXPECT_EQ(bytes, effect_->memoryBytes()) << "the engine's map is not the plugin's memory";
}

TEST_F(Effect, aPerLightPassReadsItsLightsCookie) {
  load(kPasses);
  offerCookies();
  addLight(LightKind::kDirectional, glm::vec3(1), 1, 0);
  addLight(LightKind::kSpot, glm::vec3(1), 1, 0);
  addLight(LightKind::kPoint, glm::vec3(1), 1, 0);
  const auto cookie = [](std::uint32_t layer, std::uint32_t faces, std::uint32_t repeats, float x) {
    return [=](render::ShadowedLight light) {
      light.cookieLayer = layer, light.cookieFaces = faces, light.cookieRepeats = repeats;
      light.cookieFromWorld[3][0] = x;
      return light;
    };
  };
  cookieRefs_ = {cookie(0, 0, 0, 0), cookie(2, 1, 3, 0.5f), cookie(1, 6, 0, 0.25f)};
  ASSERT_TRUE(table_.setAssignment("passes.cookies=1"));
  const Picture picture = frame();
  ASSERT_FALSE(picture.empty) << effect_->failure()->message;
  // Weights of three lights; faces and repeats as layout() and prepare() saw them; a white texel twice; layer 2 and the
  // last of layers 1 to 6, each between mips 1 and 2, and at the border halfway between the first and the last column.
  const float told = 11 + 3 + 0.5f + 66 + 0.25f;
  EXPECT_EQ(picture.at(0, 0).r, 1 + 3 + told + 2 + (215 + 700) + (615 + 1100));
  EXPECT_EQ(frame().at(0, 0).g, 2);
  cookieRefs_[0] = cookie(0, 1, 3, 0);
  EXPECT_EQ(frame().at(0, 0).g, 1) << "a light that gets a cookie is a new layout";
}

TEST_F(Effect, aRendererWithoutCookiesSaysSo) {
  load(kPasses);
  addLight(LightKind::kDirectional, glm::vec3(1), 1, 0);
  ASSERT_TRUE(table_.setAssignment("passes.cookies=1"));
  EXPECT_TRUE(frame().empty);
  ASSERT_TRUE(effect_->failure());
  EXPECT_THAT(effect_->failure()->message, testing::HasSubstr("this renderer does not offer"));
}

TEST_F(Effect, aChangeOfTheMomentsFormatIsANewLayout) {
  load(kPasses);
  addLight(LightKind::kDirectional, glm::vec3(1), 1, 0);
  EXPECT_EQ(frame().at(0, 0).g, 1);
  EXPECT_EQ(frame().at(0, 0).g, 2);
  offerMoments_ = false;
  EXPECT_EQ(frame().at(0, 0).g, 1) << "history starts anew with a new layout";
}

TEST_F(Effect, valuesReachTheNextFrameWithoutANewLayout) {
  load(kPasses);
  addLight(LightKind::kDirectional, glm::vec3(1), 1, 0);
  EXPECT_EQ(frame().at(0, 0).r, 1 + 1);
  ASSERT_TRUE(table_.setAssignment("passes.weight=5"));
  EXPECT_EQ(frame().at(0, 0).r, 2 + 5) << "history went on: no new layout";
  addLight(LightKind::kDirectional, glm::vec3(1), 1, 0);
  EXPECT_EQ(frame().at(0, 0).r, 1 + 10) << "another light: a new layout with history at zero";
}

TEST_F(Effect, debugViews) {
  load(kPasses);
  std::vector<std::string> names;
  for (const auto& view : effect_->debugViews()) names.push_back(view.name);
  EXPECT_THAT(names, ElementsAre("sum", "part", "map of light 7", "chain")) << "before any frame";
  addLight(LightKind::kDirectional, glm::vec3(1), 3, 0);
  gpu::Buffer sum;
  frame(false, [&](render::Graph& graph) {
    const auto image = effect_->debugImage("sum");
    ASSERT_TRUE(image.image);
    EXPECT_EQ(image.channel, 0u);
    sum = copyOut(graph, image.image);
    const auto part = effect_->debugImage("part");
    EXPECT_EQ(part.view.baseMip, 1u);
    EXPECT_EQ(part.view.baseLayer, 1u);
    EXPECT_FALSE(part.view.array);
    EXPECT_FALSE(effect_->debugImage("map of light 7").image) << "there is one light";
    EXPECT_FALSE(effect_->debugImage("unknown").image);
  });
  EXPECT_EQ(reinterpret_cast<const float*>(sum.mapped())[0], 1 + 3);
}

TEST_F(Effect, whatOnlyADebugViewShowsRunsAndCountsOnlyWhileItIsShown) {
  load(kPasses);
  addLight(LightKind::kDirectional, glm::vec3(1), 1, 0);
  const auto chained = [this] {
    return std::count_if(times_.begin(), times_.end(),
                         [](const render::PassTime& t) { return t.name.starts_with("chain"); });
  };
  frame();
  EXPECT_EQ(chained(), 0);
  const std::uint64_t without = effect_->memoryBytes();
  gpu::Buffer mip;
  frame(false, [&](render::Graph& graph) {
    const auto view = effect_->debugImage("chain");
    ASSERT_TRUE(view.image);
    mip = copyOut(graph, view.image, view.view.baseMip);
  });
  EXPECT_EQ(chained(), 4);
  EXPECT_EQ(effect_->memoryBytes() - without, 4u * (32 * 16 + 16 * 8 + 8 * 4 + 4 * 2));
  // Each pass sampled one mip and stored the next of the same image: an 8 x 8 block of x + 100 y, summed.
  for (std::uint32_t y = 0; y < 2; ++y)
    for (std::uint32_t x = 0; x < 4; ++x)
      EXPECT_EQ(reinterpret_cast<const float*>(mip.mapped())[4 * y + x],
                64 * (8 * static_cast<float>(x) + 3.5f) + 6400 * (8 * static_cast<float>(y) + 3.5f))
          << x << ' ' << y;
  frame();
  EXPECT_EQ(chained(), 0);
  EXPECT_EQ(effect_->memoryBytes(), without);
}

TEST_F(Effect, skippedRunsRecordNothing) {
  load(kPasses);
  addLight(LightKind::kDirectional, glm::vec3(2, 0, 0), 1, 0);
  addLight(LightKind::kSpot, glm::vec3(5, 0, 0), 1, 0);
  ASSERT_TRUE(table_.setAssignment("passes.variant=one"));
  EXPECT_EQ(frame().at(1, 1), glm::vec4(1 + 2 + 5, 1, 100.25f + 1, 0.5f));
  ASSERT_TRUE(table_.setAssignment("passes.skip=1"));
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(frame().at(1, 1), glm::vec4(1 + 2 + 5, 1, 100.25f + 1, 0.5f)) << "history as it was";
    EXPECT_FALSE(ran("history"));
    EXPECT_TRUE(ran("accumulate"));
  }
  ASSERT_TRUE(table_.setAssignment("passes.skip=2"));
  EXPECT_EQ(frame().at(1, 1), glm::vec4(2 + 2, 2, 100.25f + 1, 0.5f)) << "one light alone, and history goes on";
  EXPECT_TRUE(ran("light [light 0]") && ran("add [light 0]"));
  EXPECT_FALSE(ran("light [light 1]") || ran("add [light 1]"));
  ASSERT_TRUE(table_.setAssignment("passes.skip=0"));
  EXPECT_EQ(frame().at(1, 1).r, 3 + 2 + 5) << "skipping lasts one frame";
}

TEST_F(Effect, skippedCastersDrawNothing) {
  load(kPasses);
  addLight(LightKind::kDirectional, glm::vec3(1), 1, 0);
  int draws = 0;
  drawCasters_ = [&](render::PassContext&, const glm::mat4&) { ++draws; };
  ASSERT_TRUE(table_.setText("passes.break", "casters"));
  ASSERT_TRUE(table_.setAssignment("passes.variant=one"));
  frame();
  EXPECT_EQ(draws, 1);
  ASSERT_TRUE(table_.setAssignment("passes.skip=4"));
  EXPECT_FALSE(frame().empty);
  EXPECT_EQ(draws, 1);
}

// Which lights a timed pass runs for changes with every frame: no two times can be compared.
TEST_F(Effect, framesThatSkipATimedPassNowAndThenTuneNothing) {
  load(kPasses);
  addLight(LightKind::kDirectional, glm::vec3(1), 1, 0);
  addLight(LightKind::kSpot, glm::vec3(1), 1, 0);
  fakeTimes_ = [this](std::vector<render::PassTime>& times) {
    for (auto& time : times)
      if (time.name == "light [light 0]") time.milliseconds = effect_->resolved().at(0).second == "two" ? 1.0 : 2.0;
  };
  for (int i = 0; i < 24; ++i) {
    ASSERT_TRUE(table_.setAssignment(i % 2 == 0 ? "passes.skip=2" : "passes.skip=0"));
    frame();
  }
  EXPECT_THAT(effect_->resolved(), ElementsAre(Pair("passes.variant", "one"))) << "the first, still to be timed";
}

TEST_F(Effect, tunesBySpeedAndRemembers) {
  load(kPasses);
  addLight(LightKind::kDirectional, glm::vec3(1), 1, 0);
  fakeTimes_ = [this](std::vector<render::PassTime>& times) {
    for (auto& time : times)
      if (time.name == "light [light 0]") time.milliseconds = effect_->resolved().at(0).second == "two" ? 1.0 : 2.0;
  };
  EXPECT_TRUE(effect_->resolved().empty());
  frame();
  EXPECT_THAT(effect_->resolved(), ElementsAre(Pair("passes.variant", "one")));
  for (int i = 0; i < 4; ++i) frame();
  EXPECT_THAT(effect_->resolved(), ElementsAre(Pair("passes.variant", "two")));
  for (int i = 0; i < 8; ++i) frame();
  EXPECT_THAT(effect_->resolved(), ElementsAre(Pair("passes.variant", "two")));
  const float counted = frame().at(0, 0).g;
  EXPECT_EQ(frame().at(0, 0).g, counted + 1) << "settled: the layout stays";
  makeEffect();
  frame();
  EXPECT_THAT(effect_->resolved(), ElementsAre(Pair("passes.variant", "two"))) << "remembered on disk";
  ASSERT_TRUE(table_.setAssignment("passes.variant=one"));
  fakeTimes_ = {};
  frame();
  EXPECT_TRUE(effect_->resolved().empty()) << "asked for, not tuned";
}

TEST_F(Effect, reloadedPluginGoesOn) {
  load(kPasses);
  addLight(LightKind::kDirectional, glm::vec3(1), 1, 0);
  ASSERT_TRUE(table_.setAssignment("passes.weight=5"));
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(frame().at(3, 3).r, 1 + 5);
    effect_.reset();
    plugin_.reset();
    table_.remove("passes");
    load(kPasses);
  }
  EXPECT_EQ(frame().at(3, 3).r, 1 + 5) << "with its value";
}

}  // namespace
}  // namespace tyndall::host
