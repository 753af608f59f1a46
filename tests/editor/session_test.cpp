// Longer sessions at the window (label sweep): presets saved and compared, captures made again, lights in another
// level.
#include <fstream>

#include "session.hpp"

namespace tyndall::editor_test {
namespace {

namespace fs = std::filesystem;

/// The first light in the list; "" while there is none.
std::string lightOf(const nlohmann::json& state) {
  for (const auto& [name, place] : state["widgets"].items())
    if (name.starts_with("light at ")) return name;
  return "";
}

TEST_F(SessionTest, EditsAreUndoneAndCapturesAreMadeAgain) {
  start("hall", "960x640", {"--screenshot", (folder_ / "window.png").string()});
  EXPECT_EQ(state()["history"]["steps"], 1);
  // Another technique, from the list.
  const std::string technique = setting("volumetrics.technique");
  ASSERT_NE(technique, "ray_march");
  click("volumetrics.technique");
  click("volumetrics.technique=ray_march");
  ASSERT_TRUE(becomes("volumetrics.technique", "ray_march"));
  EXPECT_EQ(state()["history"]["steps"], 2);
  // One drag is one step, whatever it passed.
  const std::string exposure = setting("view.exposure");
  click("search");
  input({"type", "--delay", "120", "exposure"});
  waitFrames(3);
  ASSERT_FALSE(state()["widgets"].contains("volumetrics.technique"));  // the search leaves what matches
  drag("view.exposure", 0.2, 0.75);
  const std::string dragged = setting("view.exposure");
  EXPECT_NE(dragged, exposure);
  EXPECT_EQ(state()["history"]["steps"], 3);
  keys({"ctrl", "z"});
  EXPECT_TRUE(becomes("view.exposure", exposure));
  EXPECT_EQ(setting("volumetrics.technique"), "ray_march");
  keys({"ctrl", "z"});
  EXPECT_TRUE(becomes("volumetrics.technique", technique));
  EXPECT_EQ(state()["history"]["present"], 0);
  keys({"ctrl", "shift", "z"});
  EXPECT_TRUE(becomes("volumetrics.technique", "ray_march"));
  keys({"ctrl", "y"});
  EXPECT_TRUE(becomes("view.exposure", dragged));
  // A preset is one step, and what it does not name stays.
  std::ofstream(folder_ / "p.json")
      << R"({"volumetrics.technique": "ray_march", "volumetrics.steps": 9, "shadows.resolution": 256})";
  choose("l", folder_ / "p.json");
  ASSERT_TRUE(becomes("volumetrics.steps", "9")) << state()["message"];
  EXPECT_EQ(setting("view.exposure"), dragged);
  EXPECT_EQ(state()["history"]["steps"], 4);
  choose("d", folder_ / "p.json");
  ASSERT_FALSE(waitFor([](const Json& s) { return s["facts"].value("compare.count", "") == "0"; }, 20).is_null());
  keys({"ctrl", "z"});
  ASSERT_TRUE(becomes("volumetrics.steps", "64"));
  ASSERT_FALSE(waitFor([](const Json& s) { return s["facts"].value("compare.count", "") == "2"; }, 20).is_null())
      << state()["facts"];
  choose("s", folder_ / "saved");
  ASSERT_FALSE(
      waitFor([&](const Json& s) { return s["message"].get<std::string>().starts_with("saved "); }, 20).is_null());
  EXPECT_TRUE(fs::exists(folder_ / "saved.json"));
  // Look elsewhere, then capture; the command gives the same bytes.
  input({"search", "--name", "Tyndall", "mousemove", "--window", "%1", "200", "300", "mousedown", "3"});
  waitFrames(3);
  input({"search", "--name", "Tyndall", "mousemove", "--window", "%1", "263", "289"});
  waitFrames(3);
  input({"mouseup", "3"});
  ASSERT_FALSE(
      waitFor([](const Json& s) { return s["camera"]["flown"] && s["history"]["present"] == 3; }, 20).is_null())
      << state()["history"];
  keys({"ctrl", "p"});
  click("capture folder");
  input({"type", "--delay", "60", folder_.string()});
  waitFrames(3);
  const std::string command = capture();
  EXPECT_NE(command.find("--pose "), std::string::npos) << state()["message"];
  EXPECT_NE(command.find("volumetrics.technique=ray_march"), std::string::npos) << command;
  const fs::path captured = folder_ / "hall-001.png", again = folder_ / "again.png";
  ASSERT_TRUE(fs::exists(captured)) << state()["message"];
  EXPECT_TRUE(fs::exists(folder_ / "hall-001.json"));
  ASSERT_EQ(rerun(command, captured, again), 0);
  const std::string bytes = pixelsOf(captured);
  EXPECT_GT(bytes.size(), 10000u);
  EXPECT_TRUE(bytes == pixelsOf(again));
  // It is what the window shows.
  const auto top = static_cast<std::uint32_t>(state()["widgets"]["viewport"][1].get<double>());
  quit();
  auto window = image::readPng(folder_ / "window.png");
  auto picture = image::readPng(captured);
  ASSERT_TRUE(window && picture);
  std::size_t apart = 0, seen = 0;
  for (std::uint32_t y = picture->height * 3 / 4; y < picture->height; ++y)  // below the capture's own window
    for (std::uint32_t x = 0; x < picture->width; ++x, ++seen) {
      const std::uint8_t* here = &picture->values[(std::size_t{y} * picture->width + x) * 3];
      const std::uint8_t* there = &window->values[(std::size_t{y + top} * window->width + x) * 3];
      apart += here[0] != there[0] || here[1] != there[1] || here[2] != there[2];
    }
  EXPECT_LT(apart, seen / 100);
}

TEST_F(SessionTest, LevelsAreOpenedAndRemembered) {
  std::ofstream(folder_ / "settings.json") << "{ broken";
  start("hall", "960x640", {"--screenshot", (folder_ / "window.png").string()});
  EXPECT_NE(state()["message"].get<std::string>().find("settings.json"), std::string::npos) << state()["message"];
  EXPECT_TRUE(fs::exists(folder_ / "settings.json.broken"));
  choose("o", folder_ / "nothing.glb");  // refused in the window, which stays
  waitFrames(3);
  EXPECT_TRUE(state()["widgets"].contains("file name"));
  keys({"Escape"});
  ASSERT_FALSE(waitFor([](const Json& s) { return !s["widgets"].contains("file name"); }, 20).is_null());
  std::ofstream(folder_ / "bad.glb") << "no level";
  choose("o", folder_ / "bad.glb");
  ASSERT_FALSE(
      waitFor([](const Json& s) { return s["message"].get<std::string>().find("bad.glb") != std::string::npos; }, 20)
          .is_null());
  EXPECT_EQ(state()["level"], "hall");
  const fs::path vault = fs::path(TYNDALL_BIN_DIR) / "levels" / "vault.glb";
  choose("o", vault);
  const Json opened = waitFor([&](const Json& s) { return s["level"] == vault.string(); }, 60);
  ASSERT_FALSE(opened.is_null()) << state()["message"];
  EXPECT_EQ(opened["history"]["steps"], 1);
  // The lights hang high: look up.
  input({"search", "--name", "Tyndall", "mousemove", "--window", "%1", "200", "450", "mousedown", "3"});
  waitFrames(3);
  input({"search", "--name", "Tyndall", "mousemove", "--window", "%1", "200", "270"});
  waitFrames(3);
  input({"mouseup", "3"});
  ASSERT_FALSE(waitFor([](const Json& s) { return s["history"]["present"] == 1; }, 20).is_null());
  // A light is edited, undone, and in a capture, whose command finds it in a file of its own.
  click("tab level");
  ASSERT_FALSE(waitFor([](const Json& s) { return lightOf(s) != ""; }, 20).is_null());
  click(lightOf(state()));
  const Json chosen = waitFor(
      [](const Json& s) { return s["facts"].contains("light.intensity") && s["widgets"].contains("handle y"); }, 20);
  ASSERT_FALSE(chosen.is_null()) << state()["facts"];
  const Json handle = chosen["widgets"]["handle y"], viewport = chosen["widgets"]["viewport"];
  ASSERT_GT(handle[1], 60) << handle;
  ASSERT_LT(handle[1], viewport[3]) << handle;
  ASSERT_LT(handle[0], viewport[2]) << handle;
  const auto mouse = [&](double up) {
    input({"search", "--name", "Tyndall", "mousemove", "--window", "%1",
           std::to_string(static_cast<int>(handle[0].get<double>() + 4)),
           std::to_string(static_cast<int>(handle[1].get<double>() + 4 - up))});
    waitFrames(3);
  };
  const auto place = [](const Json& s) { return s["facts"].value("light.translation", ""); };
  mouse(0), input({"mousedown", "1"}), waitFrames(3), mouse(10), mouse(24), input({"mouseup", "1"});
  const Json moved =
      waitFor([&](const Json& s) { return place(s) != place(chosen) && s["history"]["present"] == 2; }, 20);
  ASSERT_FALSE(moved.is_null()) << state()["facts"] << state()["history"];
  keys({"ctrl", "z"});
  ASSERT_FALSE(waitFor([&](const Json& s) { return place(s) == place(chosen); }, 20).is_null());
  keys({"ctrl", "y"});
  ASSERT_FALSE(waitFor([&](const Json& s) { return place(s) == place(moved); }, 20).is_null());
  keys({"ctrl", "p"});
  click("capture folder");
  input({"type", "--delay", "60", folder_.string()});
  waitFrames(3);
  const std::string command = capture();
  const fs::path captured = folder_ / "vault-001.png", again = folder_ / "again.png",
                 untouched = folder_ / "untouched.png";
  ASSERT_TRUE(fs::exists(folder_ / "vault-001.glb")) << state()["message"];
  ASSERT_EQ(rerun(command, captured, again), 0);
  EXPECT_TRUE(pixelsOf(captured) == pixelsOf(again));
  std::string before = command;  // with the level as it was
  before.replace(before.find((folder_ / "vault-001.glb").string()), (folder_ / "vault-001.glb").string().size(),
                 vault.string());
  ASSERT_EQ(rerun(before, captured, untouched), 0);
  EXPECT_FALSE(pixelsOf(captured) == pixelsOf(untouched));
  quit();
  std::ifstream kept(folder_ / "settings.json");
  const Json settings = Json::parse(kept, nullptr, false);
  EXPECT_EQ(settings["recent_levels"], Json({vault.string(), "hall"}));
}

}  // namespace
}  // namespace tyndall::editor_test
