// A plugin that goes wrong while it runs: one line, off, and back when its settings change.
#include <gmock/gmock.h>

#include "frame_fixture.hpp"

namespace tyndall::host {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

struct Refusal : FrameFixture {
  void SetUp() override {
    FrameFixture::SetUp();
    load(std::filesystem::path(TYNDALL_TEST_PLUGINS) / "passes.so");
    addLight(scene::LightKind::kDirectional, glm::vec3(1), 1, 0);
  }
  /// Ten frames with passes.break = `how`; what went to stderr.
  std::string logOf(const char* how) {
    EXPECT_TRUE(table_.setText("passes.break", how));
    testing::internal::CaptureStderr();
    for (int i = 0; i < 10; ++i) EXPECT_TRUE(frame().empty) << how;
    return testing::internal::GetCapturedStderr();
  }
};

std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST_F(Refusal, isOneLineAndTheEffectIsOff) {
  const std::pair<const char*, const char*> cases[] = {
      {"shader", "missing.comp"},
      {"binding", "declares binding 7 as a storage buffer, which the pass's table lacks"},
      {"pass", "groups[2] is 0"},
      {"huge", "image 'layers'"},
      {"casters", "draws shadow casters"}};
  for (const auto& [how, says] : cases) {
    const std::string log = logOf(how);
    EXPECT_THAT(log, HasSubstr(says));
    EXPECT_EQ(lines(log), 1u) << log;
    ASSERT_TRUE(effect_->failure());
    EXPECT_THAT(effect_->failure()->message,
                AllOf(StartsWith("plugin 'passes': "), HasSubstr(says), Not(HasSubstr("\n"))));
    EXPECT_EQ(effect_->memoryBytes(), 0u);
    ASSERT_TRUE(table_.setText("passes.break", "nothing"));
    EXPECT_FALSE(frame().empty) << "back after " << how;
    EXPECT_FALSE(effect_->failure());
  }
}

TEST_F(Refusal, momentShadowMapsThatNobodyMakes) {
  offerMoments_ = false;
  ASSERT_TRUE(table_.setAssignment("passes.moments=1"));
  const std::string log = logOf("nothing");
  EXPECT_THAT(log, HasSubstr("pass 'light': binding 2 takes a moment shadow map, which this renderer does not make"));
  EXPECT_EQ(lines(log), 1u) << log;
  offerMoments_ = true;
  EXPECT_FALSE(frame().empty);
}

TEST_F(Refusal, noLayout) {
  const std::string log = logOf("null");
  EXPECT_THAT(log, HasSubstr("plugin 'passes': it gave no layout: no layout today; it is off until"));
  EXPECT_EQ(lines(log), 1u) << log;
}

TEST_F(Refusal, prepareFalseIsAFrameWithoutAndALine) {
  EXPECT_FALSE(frame().empty);
  const std::string log = logOf("prepare");
  EXPECT_THAT(log, HasSubstr("plugin 'passes': prepare() failed; frames are drawn without it"));
  EXPECT_EQ(lines(log), 1u) << log;
  ASSERT_TRUE(effect_->failure());
  EXPECT_THAT(effect_->failure()->message, HasSubstr("prepare()"));
  ASSERT_TRUE(table_.setText("passes.break", "nothing"));
  EXPECT_FALSE(frame().empty) << "the next that succeeds goes on";
  EXPECT_FALSE(effect_->failure());
}

TEST_F(Refusal, castersRunWhenTheyAreOffered) {
  int drawn = 0;
  drawCasters_ = [&](render::PassContext&, const glm::mat4& clipFromWorld) {
    ++drawn;
    for (int i = 0; i < 16; ++i)
      EXPECT_EQ(clipFromWorld[i / 4][i % 4], static_cast<float>(i)) << "column-major, as prepare wrote it";
  };
  ASSERT_TRUE(table_.setText("passes.break", "casters"));
  for (int i = 1; i <= 3; ++i) {
    EXPECT_FALSE(frame().empty);
    EXPECT_EQ(drawn, i);
  }
  EXPECT_TRUE(ran("casters"));
  EXPECT_FALSE(effect_->failure());
}

}  // namespace
}  // namespace tyndall::host
