// A window in which nothing happens costs nothing; Esc and F1; a server that refuses or goes away.
#include <chrono>
#include <fstream>
#include <thread>

#include "clipboard_client.hpp"
#include "session.hpp"
#include "shortcuts.hpp"

namespace tyndall::editor_test {
namespace {

namespace fs = std::filesystem;

class IdleTest : public SessionTest {
 protected:
  void SetUp() override {
    SessionTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    startTiny("900x760");
  }
  /// Waits until no frame was drawn for half a second.
  void rest() {
    int before = -1;
    for (int i = 0; i < 40; ++i) {
      const int now = state()["frames"];
      if (before == now) return;
      before = now;
      std::this_thread::sleep_for(std::chrono::milliseconds(500));
    }
    ADD_FAILURE() << "the window does not come to rest";
  }
  bool disappears(const std::string& widget) {
    return !waitFor([&](const Json& s) { return !s["widgets"].contains(widget); }, 20).is_null();
  }
};

TEST_F(IdleTest, NothingIsDrawnWhileNothingHappens) {
  const auto idles = [&] {
    rest();
    const Json before = state();
    const double cpu = editorSeconds();
    std::this_thread::sleep_for(std::chrono::seconds(2));
    const Json after = state();
    EXPECT_EQ(before["frames"], after["frames"]);
    EXPECT_EQ(before["pictures"], after["pictures"]);
    EXPECT_LT(editorSeconds() - cpu, 0.04);  // of 2 s: 2 % of a core
    EXPECT_EQ(after["facts"]["picture"], "current");
  };
  idles();
  click("search");  // a field that waits for text
  idles();
  // What comes after the pause is seen at once.
  input({"type", "--delay", "5", "exposure"});
  ASSERT_TRUE(disappears("volumetrics.technique"));
  quit();
}

TEST_F(IdleTest, EscClosesWhatIsOnTop) {
  keys({"F1"});
  ASSERT_TRUE(appears("keys"));
  keys({"ctrl", "p"});
  ASSERT_TRUE(appears("capture folder"));
  click("menu View");
  ASSERT_TRUE(appears("Larger text"));
  keys({"Escape"});  // the menu
  ASSERT_TRUE(disappears("Larger text"));
  EXPECT_TRUE(state()["widgets"].contains("capture folder"));
  keys({"Escape"});  // the window opened last
  ASSERT_TRUE(disappears("capture folder"));
  EXPECT_TRUE(state()["widgets"].contains("keys"));
  keys({"Escape"});
  ASSERT_TRUE(disappears("keys"));
  keys({"ctrl", "o"});
  ASSERT_TRUE(appears("file name"));
  keys({"Escape"});
  ASSERT_TRUE(disappears("file name"));
  // Nothing is open: what is dragged is let go of, though the button stays down.
  move(100, 200);
  input({"mousedown", "3"});
  move(150, 200);
  ASSERT_FALSE(waitFor([](const Json& s) { return s["camera"]["flown"].get<bool>(); }, 20).is_null());
  rest();
  const Json turned = state();
  keys({"Escape"});
  move(250, 200);
  rest();
  EXPECT_EQ(state()["camera"], turned["camera"]);
  input({"mouseup", "3"});
  ASSERT_TRUE(stepIs(1));
  EXPECT_EQ(state()["camera"], turned["camera"]);
  quit();
}

TEST_F(IdleTest, F1NamesEveryCommandAndItsKeys) {
  keys({"F1"});
  ASSERT_TRUE(appears("keys"));
  for (const editor::Shortcut& shortcut : editor::shortcuts()) {
    if (shortcut.key != 0 && shortcut.keys) {
      EXPECT_NE(fact("keys").find(std::string(shortcut.keys) + "; "), std::string::npos) << shortcut.keys;
    }
    if (!shortcut.name || !shortcut.keys) continue;
    const std::string line = fact((std::string("help ") + shortcut.name).c_str());
    EXPECT_NE(line.find(shortcut.keys), std::string::npos) << shortcut.name;
    EXPECT_NE(line.find(shortcut.does), std::string::npos) << shortcut.name;
  }
  for (const char* key : {"Esc", "Ctrl+Y", "F10"})
    EXPECT_NE(fact("keys").find(std::string(key) + "; "), std::string::npos) << key;
  quit();
}

/// A program that asked for the clipboard gives up before it is answered.
TEST_F(IdleTest, AnErrorOfTheDisplayIsALineInTheLog) {
  openCapture();
  ASSERT_FALSE(capture().empty());  // its command is in the clipboard now
  pauseEditor(true);
  ASSERT_TRUE(askForClipboardAndGiveUp(display_));
  pauseEditor(false);
  input({"mousemove_relative", "3", "3"});
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  keys({"F1"});
  EXPECT_TRUE(appears("keys"));
  EXPECT_NE(errors().find("BadWindow"), std::string::npos) << errors();
  quit();
}

TEST_F(IdleTest, EditsOutliveTheDisplay) {
  click("volumetrics.enabled");
  ASSERT_TRUE(becomes("volumetrics.enabled", "false"));
  ASSERT_TRUE(stepIs(1));
  endDisplay();
  EXPECT_EQ(waitEditor(20), 1);
  const fs::path kept = folder_ / "recovered-1.json";
  EXPECT_NE(errors().find("the display is gone"), std::string::npos) << errors();
  EXPECT_NE(errors().find(kept.string()), std::string::npos) << errors();
  std::ifstream file(kept);
  ASSERT_TRUE(file);
  const Json settings = Json::parse(file, nullptr, false).value("settings", Json());
  ASSERT_TRUE(settings.is_object());
  EXPECT_EQ(settings["volumetrics.enabled"], false);
  EXPECT_EQ(settings["shadows.resolution"], 256);
  EXPECT_FALSE(fs::exists(folder_ / "recovered-1.glb"));  // the level is as its file
  // The next session names it.
  startDisplay();
  startTiny("900x760");
  EXPECT_NE(state()["message"].get<std::string>().find(kept.string()), std::string::npos) << state()["message"];
  quit();
}

}  // namespace
}  // namespace tyndall::editor_test
