// What the hand did is what happens, whatever a picture takes: real input while each picture takes a large part of a
// second.
#include <chrono>
#include <cmath>

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

#include "session.hpp"

namespace tyndall::editor_test {
namespace {

class SlowTest : public SessionTest {
 protected:
  void SetUp() override {
    SessionTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    startTiny("700x500", {"--set", "volumetrics.technique=ray_march", "--set", "volumetrics.steps=512", "--set",
                          "medium.albedo=0.3"});
  }

  static double yaw(const Json& s) {
    return std::atan2(s["camera"]["forward"][0].get<double>(), -s["camera"]["forward"][2].get<double>());
  }
  static glm::dvec3 eye(const Json& s) {
    return {s["camera"]["position"][0].get<double>(), s["camera"]["position"][1].get<double>(),
            s["camera"]["position"][2].get<double>()};
  }
  /// The words that move the mouse to a share of the widget's width.
  std::vector<std::string> to(const std::string& widget, double share) const {
    const auto rect = state()["widgets"][widget].get<std::vector<double>>();
    return at(rect[0] + share * rect[2], rect[1] + rect[3] / 2);
  }
  static std::vector<std::string> at(double x, double y) {
    return {"mousemove", "--window", "%1", std::to_string(static_cast<int>(x)), std::to_string(static_cast<int>(y))};
  }
  /// All in one go of the tool, so that nothing waits for the window.
  void atOnce(const std::vector<std::vector<std::string>>& parts) {
    std::vector<std::string> words{"search", "--name", "Tyndall"};
    for (const auto& part : parts) words.insert(words.end(), part.begin(), part.end());
    input(words);
  }
};

TEST_F(SlowTest, ASliderEndsWhereTheHandLetGo) {
  click("search");
  input({"type", "--delay", "5", "albedo"});  // what is not in the window cannot be dragged
  waitFrames(2);
  ASSERT_FALSE(waitFor([](const Json& s) { return !s["widgets"].contains("volumetrics.technique"); }, 20).is_null());
  std::vector<std::vector<std::string>> quick{to("medium.albedo", 0.3), {"mousedown", "1"}};
  for (int i = 1; i <= 8; ++i) {  // 0.4 s
    quick.push_back(to("medium.albedo", 0.3 + 0.6 * i / 8));
    quick.push_back({"sleep", "0.05"});
  }
  quick.push_back({"mouseup", "1"});
  atOnce(quick);
  ASSERT_TRUE(stepIs(1));  // one step, and none that was left half way
  EXPECT_NEAR(std::stod(setting("medium.albedo")), 0.9, 0.05);
  quit();
}

TEST_F(SlowTest, ALookTurnsByItsLengthAtAnySpeed) {
  const double right = glm::radians(45.8366);  // 200 points of 0.004 radians
  for (const auto& [steps, pause] : {std::pair{1, "0.02"}, std::pair{20, "0.01"}, std::pair{10, "0.15"}}) {
    SCOPED_TRACE(steps);
    const double before = yaw(state());
    const int present = state()["history"]["present"];
    std::vector<std::vector<std::string>> drag{at(200, 300), {"mousedown", "3"}};
    for (int i = 1; i <= steps; ++i) {
      drag.push_back(at(200 + 200.0 * i / steps, 300));
      drag.push_back({"sleep", pause});
    }
    drag.push_back({"mouseup", "3"});
    atOnce(drag);
    ASSERT_TRUE(stepIs(present + 1));
    EXPECT_NEAR(std::remainder(yaw(state()) - before - right, glm::two_pi<double>()), 0, 1e-3);
  }
  quit();
}

TEST_F(SlowTest, QuickClicksAndTenQuickUndosAllCount) {
  std::vector<std::vector<std::string>> clicks{to("volumetrics.enabled", 0.1)};
  // The box has no effect on what is pressed next but makes the pictures quick, an even number of times.
  for (int i = 0; i < 10; ++i)
    clicks.insert(clicks.end(), {{"mousedown", "1"}, {"sleep", "0.01"}, {"mouseup", "1"}, {"sleep", "0.02"}});
  atOnce(clicks);
  ASSERT_TRUE(stepIs(10)) << state()["history"].dump();
  EXPECT_EQ(setting("volumetrics.enabled"), "true");
  std::vector<std::vector<std::string>> undos;
  for (int i = 0; i < 10; ++i) undos.push_back({"key", "--delay", "5", "ctrl+z"});
  atOnce(undos);
  EXPECT_TRUE(stepIs(0)) << state()["history"].dump();
  quit();
}

TEST_F(SlowTest, KeysCountByTheTimeTheyWereHeld) {
  const auto flown = [&](const char* seconds) {
    const Json before = state();
    const int present = before["history"]["present"];
    atOnce({{"keydown", "w", "sleep", seconds, "keyup", "w"}});
    EXPECT_TRUE(stepIs(present + 1));
    const Json after = state();
    return glm::distance(eye(before), eye(after)) / after["camera"]["speed"].get<double>();
  };
  const double brief = flown("0.1"), tap = flown("0"), longer = flown("0.6");
  EXPECT_NEAR(brief, 0.1, 0.05);  // seconds
  EXPECT_GE(tap, 1.0 / 60 * 0.99);
  EXPECT_LT(tap, 0.06);
  EXPECT_NEAR(longer, 0.6, 0.05);
  quit();
}

TEST_F(SlowTest, WhatIsTypedAfterAKeyGoesIntoTheFieldThatItOpens) {
  const std::string other = (folder_ / "The other LEVEL-2.glb").string();
  std::filesystem::copy_file(tiny(), other);
  atOnce({{"key", "ctrl+o", "type", "--delay", "1", other}});
  atOnce({{"key", "Return"}});
  EXPECT_FALSE(waitFor([&](const Json& s) { return s["level"] == other; }, 30).is_null()) << state()["message"];
  quit();
}

}  // namespace
}  // namespace tyndall::editor_test
