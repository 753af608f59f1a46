// Real keys and clicks change what they say they do.
#include <cmath>

#include <glm/glm.hpp>

#include "session.hpp"

namespace tyndall::editor_test {
namespace {

class InputTest : public SessionTest {
 protected:
  void SetUp() override {
    SessionTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    startTiny("640x400");
  }
};

TEST_F(InputTest, HoldingWFliesForwardAndFComesBack) {
  const Json before = state();
  EXPECT_FALSE(before["camera"]["flown"].get<bool>());
  input({"keydown", "w"});
  const Json moving = waitFor(
      [&](const Json& s) { return s["camera"]["flown"] && s["pictures"] >= before["pictures"].get<int>() + 3; }, 60);
  input({"keyup", "w"});
  ASSERT_FALSE(moving.is_null());
  double along = 0, length = 0;
  for (int i = 0; i < 3; ++i) {
    const double step = moving["camera"]["position"][i].get<double>() - before["camera"]["position"][i].get<double>();
    along += step * before["camera"]["forward"][i].get<double>();
    length += step * step;
  }
  EXPECT_GT(along, 0.05);                               // metres
  EXPECT_NEAR(along, std::sqrt(length), 0.01 * along);  // straight ahead
  input({"keydown", "f", "sleep", "1", "keyup", "f"});
  const Json back = waitFor([](const Json& s) { return !s["camera"]["flown"].get<bool>(); }, 30);
  ASSERT_FALSE(back.is_null());
  EXPECT_EQ(back["camera"]["position"], before["camera"]["position"]);
  quit();
}

TEST_F(InputTest, ARightDragTurnsByItsLengthAndMovesNowhere) {
  const Json before = state();
  const auto later = [&] {
    const int now = state()["frames"];
    waitFor([=](const Json& s) { return s["frames"] >= now + 3; }, 30);
  };
  // The way to where the button is pressed is no part of the drag.
  input({"search", "--name", "Tyndall", "mousemove", "--window", "%1", "100", "200", "mousedown", "3"});
  later();
  input({"search", "--name", "Tyndall", "mousemove", "--window", "%1", "150", "200"});
  later();
  input({"mouseup", "3"});
  later();
  const Json after = state();
  const auto yaw = [](const Json& s) {
    return std::atan2(s["camera"]["forward"][0].get<double>(), -s["camera"]["forward"][2].get<double>());
  };
  EXPECT_NEAR(yaw(after) - yaw(before), 50 * 0.004, 1e-3);  // radians: 50 pixels to the right turn right
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(after["camera"]["position"][i].get<double>(), before["camera"]["position"][i].get<double>(), 1e-4);
  quit();
}

TEST_F(InputTest, AMiddleDragGoesRoundTheLevelsMiddle) {
  const glm::dvec3 middle(0, 0.75, 0);  // of tiny_level.cpp's boxes
  const auto eye = [](const Json& s) {
    return glm::dvec3(s["camera"]["position"][0].get<double>(), s["camera"]["position"][1].get<double>(),
                      s["camera"]["position"][2].get<double>());
  };
  const auto yaw = [](const Json& s) {
    return std::atan2(s["camera"]["forward"][0].get<double>(), -s["camera"]["forward"][2].get<double>());
  };
  const Json before = state();
  move(100, 200);
  input({"mousedown", "2"});
  waitFrames(3);
  move(150, 190);
  waitFrames(2);
  input({"mouseup", "2"});
  ASSERT_TRUE(stepIs(1));
  const Json after = state();
  EXPECT_NEAR(yaw(after) - yaw(before), 50 * 0.004, 1e-3);  // radians
  EXPECT_NEAR(glm::distance(eye(after), middle), glm::distance(eye(before), middle), 1e-3);
  EXPECT_GT(glm::distance(eye(after), eye(before)), 1);
  quit();
}

TEST_F(InputTest, ClicksChangeParametersAndResetThem) {
  EXPECT_EQ(state()["settings"]["volumetrics.enabled"], "true");
  click("volumetrics.enabled");
  ASSERT_FALSE(waitFor([](const Json& s) { return s["settings"]["volumetrics.enabled"] == "false"; }, 30).is_null());
  click("reset volumetrics.enabled");
  ASSERT_FALSE(waitFor([](const Json& s) { return s["settings"]["volumetrics.enabled"] == "true"; }, 30).is_null());
  quit();
}

}  // namespace
}  // namespace tyndall::editor_test
