#include "session.hpp"

#include <chrono>
#include <cstdlib>
#include <sstream>
#include <thread>

#include "tiny_level.hpp"

namespace tyndall::editor_test {

namespace fs = std::filesystem;

void SessionTest::start(const std::string& level, const std::string& size, const std::vector<std::string>& more) {
  ASSERT_TRUE(haveProgram("xdotool"));
  std::vector<std::string> call{level, "--size", size};
  for (const char* small :
       {"volumetrics.columns=64", "volumetrics.slices=64", "shadows.resolution=256", "volumetrics.prefix_scheme=row"})
    call.insert(call.end(), {"--set", small});
  call.insert(call.end(), more.begin(), more.end());
  startEditor(call);
  ASSERT_FALSE(
      waitFor([](const Json& s) { return s["frames"] >= 3 && s["facts"].value("picture", "") == "current"; }).is_null())
      << errors();
  focus();
}

void SessionTest::startTiny(const std::string& size, const std::vector<std::string>& more) {
  writeTinyLevel(tiny());
  std::vector<std::string> call{"--set", "volumetrics.technique=none"};
  call.insert(call.end(), more.begin(), more.end());
  start(tiny().string(), size, call);
}

void SessionTest::quit() {
  keys({"ctrl", "q"});
  EXPECT_EQ(waitEditor(60), 0) << errors();
}

std::vector<double> SessionTest::numbers(const char* name) const {
  std::istringstream stream(fact(name));
  std::vector<double> list;
  for (double value; stream >> value;) list.push_back(value);
  return list;
}

bool SessionTest::becomes(const char* id, const std::string& value) {
  return !waitFor([&](const Json& s) { return s["settings"][id] == value; }, 20).is_null();
}
bool SessionTest::factBecomes(const char* name, const std::string& value) {
  return !waitFor([&](const Json& s) { return s["facts"].value(name, "") == value; }, 20).is_null();
}
bool SessionTest::appears(const std::string& widget) {
  return !waitFor([&](const Json& s) { return s["widgets"].contains(widget); }, 20).is_null();
}
bool SessionTest::stepIs(int present) {
  return !waitFor([&](const Json& s) { return s["history"]["present"] == present; }, 20).is_null();
}

image::ByteImage SessionTest::look() {
  const auto viewport = state()["widgets"]["viewport"].get<std::vector<double>>();
  move(3, viewport[1] + viewport[3] + 8);  // onto the status line
  EXPECT_FALSE(waitFor([](const Json& s) { return s["facts"].value("picture", "") == "current"; }, 60).is_null());
  // A frame that was handed over reaches the screen by the window system's own thread.
  image::ByteImage last, now = readScreen(folder_ / "Xvfb_screen0");
  for (int i = 0; i < 20; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    last = std::move(now), now = readScreen(folder_ / "Xvfb_screen0");
    const Area area = Area::of(viewport);
    if (changedShare(part(last, area), part(now, area)) == 0) break;
  }
  return now;
}

image::ByteImage SessionTest::lookAtPicture() {
  const image::ByteImage screen = look();
  return part(screen, Area::of(state()["widgets"]["viewport"].get<std::vector<double>>()));
}

void SessionTest::choose(const char* key, const fs::path& file) {
  keys({"ctrl", key});
  ASSERT_TRUE(appears("file name"));
  input({"type", "--delay", "25", file.string()});
  waitFrames(3);
  keys({"Return"});
}

void SessionTest::openCapture() {
  keys({"ctrl", "p"});
  ASSERT_TRUE(appears("capture folder"));
  click("capture folder");
  input({"type", "--delay", "25", folder_.string()});
  waitFrames(3);
}

std::string SessionTest::capture() {
  const std::string before = fact("capture.command");
  click("capture");
  const Json done = waitFor([&](const Json& s) { return s["facts"].value("capture.command", before) != before; }, 60);
  return done.is_null() ? "" : done["facts"]["capture.command"].get<std::string>();
}

int SessionTest::rerun(std::string command, const fs::path& captured, const fs::path& again) {
  const std::size_t at = command.find(captured.string());
  if (command.rfind("tyndall ", 0) != 0 || at == std::string::npos) return -1;
  command.replace(at, captured.string().size(), again.string());
  return std::system(
      (std::string(TYNDALL_BIN_DIR) + "/" + command + " > " + (folder_ / "again.log").string() + " 2>&1").c_str());
}

std::string SessionTest::pixelsOf(const fs::path& png) const {
  auto bytes = image::readPng(png);
  return bytes ? std::string(bytes->values.begin(), bytes->values.end()) : "unreadable: " + bytes.error().message;
}

}  // namespace tyndall::editor_test
