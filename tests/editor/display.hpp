// A virtual display of the test's own, and the editor running on it.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/types.h>
#include <nlohmann/json.hpp>

namespace tyndall::editor_test {

/// A program started by the test; stderr goes to a file.
class Process {
 public:
  Process() = default;
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  /// `words[0]` is the program, looked up in PATH. `display` "" = none. `keep` stays open in the child.
  void start(const std::vector<std::string>& words, const std::string& display, const std::filesystem::path& errors,
             int keep = -1);
  /// Exit status; 1000 + signal when a signal ended it; -1 when it did not end within `seconds` (it is then killed).
  int wait(double seconds);
  bool running();
  pid_t id() const { return pid_; }

 private:
  pid_t pid_ = -1;
};

bool haveProgram(const std::string& name);

/// A folder and an X server of its own, whose screen is the file Xvfb_screen0 in the folder (see screen.hpp). Skips
/// where Xvfb is not installed.
class EditorTest : public ::testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  /// Starts bin/tyndall-editor with `arguments` and --print-state.
  void startEditor(std::vector<std::string> arguments);
  int waitEditor(double seconds = 120) { return editor_.wait(seconds); }
  /// Processor time that the editor has used, seconds.
  double editorSeconds() const;
  /// The editor does nothing until it may go on: a window that is busy.
  void pauseEditor(bool paused);
  /// A server of the test's own; its end is that of the editor's connection to it.
  void startDisplay();
  void endDisplay() { server_.wait(0); }
  std::string errors() const;
  /// The state file's newest content; null before the first.
  nlohmann::json state() const;
  /// Waits until the state fulfils `condition`; the state, or null when it did not in time.
  nlohmann::json waitFor(const std::function<bool(const nlohmann::json&)>& condition, double seconds = 90);
  /// Runs xdotool on the test's display.
  void input(const std::vector<std::string>& words);
  /// Moves the mouse into the widget and clicks, each long enough to be seen by a slow frame.
  void click(const std::string& widget);
  void clickAt(double x, double y);
  void move(double x, double y);
  void focus();
  /// Presses the mouse at one share of the widget's width, moves in several steps, and lets go at another.
  void drag(const std::string& widget, double from, double to);
  /// Presses the mouse in the middle of the widget and lets go so many points away.
  void pull(const std::string& widget, double right, double down);
  /// Holds the keys together, long enough for a slow frame.
  void keys(const std::vector<std::string>& names);
  /// Until what was input before is seen: the window has come to rest, or drawn more than so many frames.
  void waitFrames(int count);

  std::filesystem::path folder_;
  std::string display_;

 private:
  Process server_, editor_;
};

}  // namespace tyndall::editor_test
