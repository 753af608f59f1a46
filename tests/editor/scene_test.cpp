// The level's tree and the handles in the picture, by mouse: what is said of the edit, what is seen of it, and that it
// can be undone.
#include <cmath>

#include "session.hpp"
#include "tiny_level.hpp"

namespace tyndall::editor_test {
namespace {

namespace fs = std::filesystem;

constexpr double kNothing = 0.002, kAimLength = 76;  // points: editor/gizmo.cpp

double angleBetween(const std::vector<double>& a, const std::vector<double>& b) {
  double dot = 0, crossSquared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    dot += a[i] * b[i];
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    crossSquared += std::pow(a[j] * b[k] - a[k] * b[j], 2);
  }
  return std::atan2(std::sqrt(crossSquared), dot);
}

class SceneTest : public SessionTest {
 protected:
  void SetUp() override {
    SessionTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    startTiny("900x760");
    if (HasFatalFailure()) return;
    click("tab level");
    ASSERT_TRUE(appears("camera 0"));
  }
  void select(const std::string& entry) {
    ASSERT_TRUE(appears(entry));
    click(entry);
    waitFrames(2);
  }
  void undo(int present) {
    keys({"ctrl", "z"});
    ASSERT_TRUE(stepIs(present));
  }
};

TEST_F(SceneTest, CamerasAreLookedThrough) {
  const image::ByteImage front = lookAtPicture();
  EXPECT_EQ(state()["camera"]["index"], 0);
  click("camera 1");
  ASSERT_FALSE(waitFor([](const Json& s) { return s["camera"]["index"] == 1; }, 20).is_null());
  ASSERT_TRUE(stepIs(1));
  EXPECT_NEAR(state()["camera"]["position"][0].get<double>(), 6, 1e-5);
  EXPECT_GT(changedShare(front, lookAtPicture()), 0.1);
  undo(0);
  EXPECT_EQ(state()["camera"]["index"], 0);
  EXPECT_LT(changedShare(front, lookAtPicture()), kNothing);
  quit();
}

TEST_F(SceneTest, MaterialsAreEditedLiveAndCaptured) {
  click("section Cameras"), click("section Lights"), click("section Materials");
  select("material " + std::to_string(kBoxMaterial));
  ASSERT_TRUE(appears("material colour"));
  EXPECT_FALSE(state()["widgets"].contains("material alpha"));  // nothing reads it of an opaque one
  const image::ByteImage before = lookAtPicture();
  const auto colour = numbers("material.base_color");
  ASSERT_EQ(colour.size(), 4u);
  drag("material colour", 0.05, 0.3);  // the field of red
  ASSERT_TRUE(stepIs(1));
  EXPECT_EQ(state()["history"]["label"], "material");
  EXPECT_GT(numbers("material.base_color")[0], colour[0] + 0.05);
  EXPECT_EQ(numbers("material.base_color")[1], colour[1]);
  const double changed = changedShare(before, lookAtPicture());
  EXPECT_GT(changed, 0.005);  // the box
  EXPECT_LT(changed, 0.3);    // and nothing but the box
  select("material " + std::to_string(kGlassMaterial));
  ASSERT_TRUE(appears("material alpha"));
  const image::ByteImage clear = lookAtPicture();
  drag("material alpha", 0.3, 0.6);
  ASSERT_TRUE(stepIs(2));
  EXPECT_GT(changedShare(clear, lookAtPicture()), 0.002);
  // The capture has the level as it is now.
  openCapture();
  const std::string command = capture();
  const fs::path captured = folder_ / "tiny-001.png", again = folder_ / "again.png";
  ASSERT_TRUE(fs::exists(folder_ / "tiny-001.glb")) << state()["message"];
  ASSERT_EQ(rerun(command, captured, again), 0);
  EXPECT_TRUE(pixelsOf(captured) == pixelsOf(again));
  keys({"ctrl", "p"});
  undo(1);
  undo(0);
  EXPECT_EQ(fact("level.edits"), "0");
  EXPECT_LT(changedShare(before, lookAtPicture()), kNothing);
  quit();
}

TEST_F(SceneTest, NodesAreMovedAndTurnedByTheirHandles) {
  click("section Cameras"), click("section Lights"), click("section Nodes");
  select("node " + std::to_string(kBoxNode));
  ASSERT_TRUE(appears("handle x"));
  const image::ByteImage before = lookAtPicture();
  const auto place = numbers("node.translation");
  ASSERT_EQ(place.size(), 3u);
  // An arrow is 48 points long: as far along it moves the node by as many metres as it spans.
  const auto metres = [&] {
    const Json s = state();
    const double height = s["widgets"]["viewport"][3].get<double>();
    return 2 * 6.0 * std::tan(0.45) / height;  // of a point, six metres before the camera
  }();
  pull("handle x", 40, 0);
  ASSERT_TRUE(stepIs(1));
  EXPECT_EQ(state()["history"]["label"], "place");
  const auto moved = numbers("node.translation");
  EXPECT_NEAR(moved[0] - place[0], 40 * metres, 0.05 * 40 * metres);
  EXPECT_NEAR(moved[1], place[1], 1e-5);
  EXPECT_NEAR(moved[2], place[2], 1e-5);
  EXPECT_GT(changedShare(before, lookAtPicture()), 0.01);
  undo(0);
  EXPECT_EQ(numbers("node.translation"), place);
  ASSERT_TRUE(appears("turn y"));
  pull("turn y", 15, 0);
  ASSERT_TRUE(stepIs(1));
  const auto turn = numbers("node.rotation");
  ASSERT_EQ(turn.size(), 4u);
  EXPECT_NEAR(turn[0], 0, 1e-5);
  EXPECT_NEAR(turn[2], 0, 1e-5);
  EXPECT_GT(std::abs(turn[1]), 0.05);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(numbers("node.translation")[i], place[i], 1e-4);  // about its middle
  EXPECT_GT(changedShare(before, lookAtPicture()), 0.002);
  undo(0);
  EXPECT_LT(changedShare(before, lookAtPicture()), kNothing);
  quit();
}

TEST_F(SceneTest, AClickInThePictureSelectsTheMeshUnderIt) {
  const auto clickOn = [this](double right, double down) {  // shares of the picture
    const auto view = state()["widgets"]["viewport"].get<std::vector<double>>();
    clickAt(view[0] + right * view[2], view[1] + down * view[3]);
    waitFrames(3);
  };
  EXPECT_EQ(fact("level.selected"), "nothing");
  clickOn(0.5, 0.68);  // the box's front
  EXPECT_EQ(fact("level.selected"), "node " + std::to_string(kBoxNode));
  ASSERT_TRUE(appears("node scale"));
  const image::ByteImage before = lookAtPicture();
  drag("node scale", 0.1, 0.4);  // its x
  ASSERT_TRUE(stepIs(1));
  const auto scale = numbers("node.scale");
  ASSERT_EQ(scale.size(), 3u);
  EXPECT_GT(scale[0], 1.1);
  EXPECT_EQ(scale[1], 1);
  EXPECT_EQ(scale[2], 1);
  EXPECT_GT(changedShare(before, lookAtPicture()), 0.005);
  undo(0);
  EXPECT_LT(changedShare(before, lookAtPicture()), kNothing);
  clickOn(0.5, 0.1);  // the sky
  EXPECT_EQ(fact("level.selected"), "nothing");
  quit();
}

TEST_F(SceneTest, LightsAreAimedAndConesOpened) {
  click("section Cameras");
  const std::string lamp = "light at " + std::to_string(kSpotNode), sun = "light at " + std::to_string(kSunNode);
  select(lamp);
  ASSERT_TRUE(appears("aim") && appears("cone") && appears("handle y"));
  const image::ByteImage before = lookAtPicture();
  const auto direction = numbers("light.direction"), place = numbers("light.translation");
  const double cone = std::stod(fact("light.outer_cone"));
  ASSERT_EQ(direction.size(), 3u);
  // It lies across the view's right: a pull upwards turns it by as many radians as the pull has lengths of the handle.
  pull("aim", 0, -38);
  ASSERT_TRUE(stepIs(1));
  EXPECT_NEAR(angleBetween(direction, numbers("light.direction")), 38 / kAimLength, 0.01);
  EXPECT_EQ(numbers("light.translation"), place);
  EXPECT_GT(changedShare(before, lookAtPicture()), 0.02);
  undo(0);
  EXPECT_EQ(numbers("light.direction"), direction);
  // Outwards from the lamp's own axis.
  const Json now = state();
  const double outwards = now["widgets"]["cone"][0].get<double>() > now["widgets"]["aim"][0].get<double>() ? 1 : -1;
  pull("cone", 12 * outwards, 0);
  ASSERT_TRUE(stepIs(1));
  EXPECT_GT(std::stod(fact("light.outer_cone")), cone + 2);
  EXPECT_EQ(numbers("light.direction"), direction);
  EXPECT_GT(changedShare(before, lookAtPicture()), 0.005);
  undo(0);
  EXPECT_LT(changedShare(before, lookAtPicture()), kNothing);

  select(sun);
  ASSERT_TRUE(appears("aim"));
  EXPECT_FALSE(state()["widgets"].contains("handle x"));  // it is nowhere
  const image::ByteImage day = lookAtPicture();
  const auto from = numbers("light.direction");
  pull("aim", 30, 10);
  ASSERT_TRUE(stepIs(1));
  EXPECT_GT(angleBetween(from, numbers("light.direction")), 0.1);
  EXPECT_GT(changedShare(day, lookAtPicture()), 0.05);
  undo(0);
  EXPECT_LT(changedShare(day, lookAtPicture()), kNothing);
  quit();
}

}  // namespace
}  // namespace tyndall::editor_test
