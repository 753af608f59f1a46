// Changed settings that are built beside the frames: what is drawn meanwhile, what wins, what happens to what cannot be
// made.
#include <chrono>
#include <thread>

#include <gmock/gmock.h>

#include "frame_fixture.hpp"
#include "host/abi.hpp"

namespace tyndall::host {
namespace {

using testing::HasSubstr;
using Background = PluginEffect::Background;

struct BackgroundUpdate : FrameFixture {
  void SetUp() override {
    FrameFixture::SetUp();
    load(std::filesystem::path(TYNDALL_TEST_PLUGINS) / "passes.so");
    addLight(scene::LightKind::kDirectional, glm::vec3(1), 1, 0);
    set("passes.variant=one");
    effect_->buildInBackground(true);
    EXPECT_EQ(frame().at(0, 0), glm::vec4(1 + 1, 1, 0.25f, 0.5f)) << "the first layout is made at once";
    EXPECT_EQ(effect_->background(), Background::kIdle);
  }
  void set(const std::string& assignment) { ASSERT_TRUE(table_.setAssignment(assignment)); }
  /// Frames until nothing is being built; each is given to `check` before the last.
  Picture settle(const std::function<void(const Picture&)>& check = {}) {
    const auto start = std::chrono::steady_clock::now();
    for (;;) {
      const Picture picture = frame();
      if (effect_->background() == Background::kIdle) return picture;
      if (check) check(picture);
      if (std::chrono::steady_clock::now() - start > std::chrono::seconds(60)) {
        ADD_FAILURE() << "it does not end";
        return picture;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }
};

// What per_light_moments.comp reads of a light's map (see effect_test.cpp), with the light's weight of 1.
constexpr float kMoments = 1 + 10 * TY_FORMAT_RGBA32_FLOAT + 150;

TEST_F(BackgroundUpdate, framesGoOnWithTheOldValuesUntilTheNewOnesAreThere) {
  set("passes.moments=1");
  float frames = 1;
  const Picture last = settle([&](const Picture& picture) {
    ASSERT_FALSE(picture.empty);
    ++frames;
    EXPECT_EQ(picture.at(0, 0), glm::vec4(frames + 1, frames, 0.25f, 0.5f)) << "the old layout with its history";
  });
  EXPECT_GT(frames, 1);
  EXPECT_EQ(last.at(0, 0).r, 1 + kMoments);
  EXPECT_EQ(last.at(0, 0).g, 1) << "a new layout";
  EXPECT_EQ(frame().at(0, 0).g, 2) << "which stays";
}

TEST_F(BackgroundUpdate, otherValuesReachTheOldLayoutMeanwhile) {
  set("passes.moments=1");
  frame();
  ASSERT_NE(effect_->background(), Background::kIdle);
  set("passes.weight=5");
  EXPECT_EQ(frame().at(0, 0).r, 3 + 5);
}

TEST_F(BackgroundUpdate, theNewestChangeWins) {
  for (const char* assignment :
       {"passes.moments=1", "passes.moments=0", "passes.variant=two", "passes.moments=1", "passes.variant=one"}) {
    set(assignment);
    frame();
  }
  const Picture last = settle([&](const Picture& picture) {
    EXPECT_EQ(picture.at(0, 0).r, picture.at(0, 0).g + 1) << "none of those in between is drawn";
  });
  EXPECT_EQ(last.at(0, 0).r, 1 + kMoments);
}

TEST_F(BackgroundUpdate, goingBackIsNoChange) {
  set("passes.moments=1");
  frame();
  set("passes.moments=0");
  const Picture picture = frame();
  EXPECT_EQ(effect_->background(), Background::kIdle);
  EXPECT_EQ(picture.at(0, 0).g, 3) << "the old layout goes on";
}

TEST_F(BackgroundUpdate, whatCannotBeMadeLeavesTheOldOne) {
  float frames = 1;
  for (const auto& [how, says] : {std::pair("shader", "missing.comp"),
                                  {"binding", "declares binding 7"},
                                  {"pass", "groups[2] is 0"},
                                  {"huge", "image 'layers'"},
                                  {"null", "layout"}}) {
    set(std::string("passes.break=") + how);
    testing::internal::CaptureStderr();
    const Picture last = settle([&](const Picture& picture) {
      EXPECT_FALSE(picture.empty);
      ++frames;
    });
    EXPECT_EQ(last.at(0, 0).g, ++frames) << how;
    ASSERT_TRUE(effect_->failure()) << how;
    EXPECT_THAT(effect_->failure()->message, HasSubstr(says));
    EXPECT_EQ(frame().at(0, 0).g, ++frames);
    const std::string log = testing::internal::GetCapturedStderr();
    EXPECT_THAT(log, HasSubstr("the settings before go on"));
    set("passes.break=nothing");
    EXPECT_EQ(settle().at(0, 0).g, ++frames);
    EXPECT_FALSE(effect_->failure());
  }
}

TEST_F(BackgroundUpdate, otherLightsAreFollowedAtOnce) {
  set("passes.moments=1");
  frame();
  ASSERT_NE(effect_->background(), Background::kIdle);
  addLight(scene::LightKind::kDirectional, glm::vec3(1), 1, 0);
  const Picture picture = frame();
  if (effect_->background() != Background::kIdle) {
    EXPECT_EQ(picture.at(0, 0).r, 1 + 2) << "with the old values";
  }
  EXPECT_EQ(settle().at(0, 0).r, 1 + 2 * kMoments + 1);
}

// Rebuilt for the new lights, the old layout no longer needs the pipelines that the new one was to take over from it.
TEST_F(BackgroundUpdate, whatIsToBeTakenOverOutlivesTheOldLayout) {
  set("passes.odd=1");
  set("passes.moments=1");  // which is to be built
  addLight(scene::LightKind::kDirectional, glm::vec3(1), 1, 0);
  EXPECT_EQ(
      settle([](const Picture& picture) { EXPECT_EQ(picture.at(0, 0).r, picture.at(0, 0).g + 2) << "the old values"; })
          .at(0, 0)
          .r,
      1 + 2 * kMoments + 1);
}

TEST_F(BackgroundUpdate, aFrameThatHasNoRoomBringsTheOldOneBack) {
  set("passes.moments=1");
  dropFirstOfNewLayout_ = true;
  const Picture last = settle();
  EXPECT_FALSE(dropFirstOfNewLayout_) << "it was dropped";
  EXPECT_FALSE(last.empty);
  EXPECT_EQ(last.at(0, 0).r, last.at(0, 0).g + 1) << "the old values";
  ASSERT_TRUE(effect_->failure());
  EXPECT_THAT(effect_->failure()->message, HasSubstr("no room"));
  set("passes.moments=0");
  frame();
  EXPECT_FALSE(effect_->failure());
}

TEST_F(BackgroundUpdate, variantsAreTimedOneAfterTheOther) {
  fakeTimes_ = [this](std::vector<render::PassTime>& times) {
    for (auto& time : times)
      if (time.name == "light [light 0]") time.milliseconds = effect_->resolved().at(0).second == "two" ? 1.0 : 2.0;
  };
  set("passes.variant=auto");
  for (int i = 0; i < 300 && (effect_->remembered().empty() || effect_->remembered()[0].second.empty()); ++i) {
    EXPECT_FALSE(frame().empty);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  EXPECT_THAT(effect_->remembered(), testing::ElementsAre(testing::Pair("passes.variant", "two")));
}

}  // namespace
}  // namespace tyndall::host
