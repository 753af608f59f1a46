// What the tests of the research panels share.
#pragma once

#include <cmath>
#include <sstream>

#include "display.hpp"
#include "image/image_io.hpp"
#include "image/metrics.hpp"

namespace tyndall::editor_test {

using Json = nlohmann::json;

inline const std::vector<std::string> kSettings = {
    "--set", "volumetrics.columns=64",      "--set", "volumetrics.slices=64",       "--set", "shadows.resolution=256",
    "--set", "volumetrics.technique=exact", "--set", "volumetrics.row_order=column"};

inline std::vector<double> numbers(const std::string& text) {
  std::istringstream stream(text);
  std::vector<double> list;
  for (double value; stream >> value;) list.push_back(value);
  return list;
}

inline std::string fact(const Json& state, const std::string& name) {
  return state.contains("facts") && state["facts"].contains(name) ? state["facts"][name].get<std::string>() : "";
}

class ResearchTest : public EditorTest {
 protected:
  void SetUp() override {
    EditorTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    ASSERT_TRUE(haveProgram("xdotool"));
    std::vector<std::string> arguments = {"hall", "--size", "600x240"};
    arguments.insert(arguments.end(), kSettings.begin(), kSettings.end());
    startEditor(arguments);
    const Json started = waitFor([](const Json& s) { return s["frames"] >= 3; });
    ASSERT_FALSE(started.is_null()) << errors();
    focus();
    viewport_ = started["widgets"]["viewport"].get<std::vector<double>>();
    size_ = std::to_string(static_cast<int>(viewport_[2])) + "x" + std::to_string(static_cast<int>(viewport_[3]));
  }
  void quit() {
    input({"keydown", "ctrl", "keydown", "q", "sleep", "1", "keyup", "q", "keyup", "ctrl"});
    EXPECT_EQ(waitEditor(60), 0) << errors();
  }
  /// The program `tyndall` on the view that the window shows.
  void commandLine(const std::string& command, const std::vector<std::string>& options) {
    std::vector<std::string> words = {std::string(TYNDALL_BIN_DIR) + "/tyndall", command, "hall", "--size", size_};
    words.insert(words.end(), kSettings.begin(), kSettings.end());
    words.insert(words.end(), options.begin(), options.end());
    Process program;
    program.start(words, "", folder_ / "tyndall.err");
    ASSERT_EQ(program.wait(120), 0);
  }
  image::FloatImage exr(const std::string& name) const {
    auto picture = image::readExr(folder_ / name);
    EXPECT_TRUE(picture) << picture.error().message;
    return picture ? picture.take() : image::FloatImage{};
  }
  void moveTo(double x, double y) {
    input({"search", "--name", "Tyndall", "mousemove", "--window", "%1", std::to_string(static_cast<int>(x)),
           std::to_string(static_cast<int>(y))});
    const int now = state()["frames"];
    waitFor([=](const Json& s) { return s["frames"] >= now + 3; }, 30);
  }
  Json waitForFact(const std::string& name, const std::string& value, double seconds = 90) {
    return waitFor([&](const Json& s) { return fact(s, name) == value; }, seconds);
  }

  std::vector<double> viewport_;
  std::string size_;
};

}  // namespace tyndall::editor_test
