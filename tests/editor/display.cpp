#include "display.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace tyndall::editor_test {
namespace fs = std::filesystem;
namespace {

using Clock = std::chrono::steady_clock;

void sleepMs(int ms) { std::this_thread::sleep_for(std::chrono::milliseconds(ms)); }

std::string readText(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

bool haveProgram(const std::string& name) {
  const char* list = std::getenv("PATH");
  std::string rest = list ? list : "";
  while (!rest.empty()) {
    const std::string folder = rest.substr(0, rest.find(':'));
    rest = folder.size() < rest.size() ? rest.substr(folder.size() + 1) : "";
    if (access((folder + "/" + name).c_str(), X_OK) == 0) return true;
  }
  return false;
}

void Process::start(const std::vector<std::string>& words, const std::string& display, const fs::path& errors,
                    int keep) {
  std::vector<std::string> copies = words;
  std::vector<char*> pointers;
  for (std::string& word : copies) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  pid_ = fork();
  if (pid_ != 0) return;
  if (display.empty())
    unsetenv("DISPLAY");
  else
    setenv("DISPLAY", display.c_str(), 1);
  unsetenv("WAYLAND_DISPLAY");
  const int err = open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  dup2(open("/dev/null", O_RDWR | O_CLOEXEC), 1);
  dup2(err, 2);
  if (keep >= 0) fcntl(keep, F_SETFD, 0);
  execvp(pointers[0], pointers.data());
  _exit(127);
}

bool Process::running() {
  if (pid_ <= 0) return false;
  siginfo_t info{};
  return waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == 0;
}

int Process::wait(double seconds) {
  if (pid_ <= 0) return -1;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  while (running() && Clock::now() < end) sleepMs(20);
  const bool late = running();
  if (late) kill(pid_, SIGKILL);
  int status = 0;
  waitpid(pid_, &status, 0);
  pid_ = -1;
  if (late) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
}

Process::~Process() {
  if (pid_ > 0) kill(pid_, SIGTERM), wait(5);
}

void EditorTest::SetUp() {
  if (!haveProgram("Xvfb")) GTEST_SKIP() << "Xvfb is not installed";
  std::string name = (fs::temp_directory_path() / "tyndall-editor-XXXXXX").string();
  ASSERT_NE(mkdtemp(name.data()), nullptr);
  folder_ = name;
  startDisplay();
}

void EditorTest::startDisplay() {
  // The server chooses a free display and tells its number through the pipe.
  int ends[2];
  ASSERT_EQ(pipe2(ends, O_CLOEXEC), 0);
  server_.start({"Xvfb", "-displayfd", std::to_string(ends[1]), "-screen", "0", "1400x900x24", "-fbdir",
                 folder_.string(), "-nolisten", "tcp"},
                "", folder_ / "xvfb.err", ends[1]);
  close(ends[1]);
  std::string number;
  pollfd ready{ends[0], POLLIN, 0};
  for (char c = 0; poll(&ready, 1, 60000) > 0 && read(ends[0], &c, 1) == 1 && c != '\n';) number += c;
  close(ends[0]);
  ASSERT_FALSE(number.empty()) << "Xvfb did not start: " << readText(folder_ / "xvfb.err");
  display_ = ":" + number;
}

void EditorTest::TearDown() {
  editor_.wait(0);
  std::error_code ignored;
  if (!folder_.empty()) fs::remove_all(folder_, ignored);
}

void EditorTest::startEditor(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), std::string(TYNDALL_BIN_DIR) + "/tyndall-editor");
  // What is remembered between runs is the user's own: a test leaves it alone.
  arguments.insert(arguments.end(), {"--print-state", (folder_ / "state.json").string(), "--settings",
                                     (folder_ / "settings.json").string()});
  std::error_code ignored;
  fs::remove(folder_ / "state.json", ignored);  // an earlier session's says nothing of this one
  editor_.start(arguments, display_, folder_ / "editor.err");
}

double EditorTest::editorSeconds() const {
  // The fields after the name, which is in brackets: the 14th and 15th of the line are user and system time.
  const std::string line = readText("/proc/" + std::to_string(editor_.id()) + "/stat");
  std::istringstream fields(line.substr(std::min(line.rfind(')') + 1, line.size())));
  std::string skipped;
  for (int i = 3; i < 14; ++i) fields >> skipped;
  double user = 0, system = 0;
  fields >> user >> system;
  return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

void EditorTest::pauseEditor(bool paused) { kill(editor_.id(), paused ? SIGSTOP : SIGCONT); }

std::string EditorTest::errors() const { return readText(folder_ / "editor.err"); }

nlohmann::json EditorTest::state() const {
  return nlohmann::json::parse(readText(folder_ / "state.json"), nullptr, false);
}

nlohmann::json EditorTest::waitFor(const std::function<bool(const nlohmann::json&)>& condition, double seconds) {
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  for (; Clock::now() < end && editor_.running(); sleepMs(50)) {
    const nlohmann::json now = state();
    if (now.is_object() && condition(now)) return now;
  }
  return nullptr;
}

void EditorTest::input(const std::vector<std::string>& words) {
  std::vector<std::string> call{"xdotool"};
  call.insert(call.end(), words.begin(), words.end());
  Process tool;
  tool.start(call, display_, folder_ / "xdotool.err");
  ASSERT_EQ(tool.wait(60), 0) << call[1] << ": " << readText(folder_ / "xdotool.err");
}

// There is no window manager: the focus is set by hand.
void EditorTest::focus() { input({"search", "--sync", "--name", "Tyndall", "windowfocus", "--sync"}); }

void EditorTest::waitFrames(int count) {
  using std::chrono::milliseconds;
  const int now = state().value("frames", 0);
  int seen = now;
  auto since = Clock::now();
  const auto settled = [&](const auto& s) {
    const int frames = s["frames"];
    if (frames != seen) seen = frames, since = Clock::now();
    const auto still = Clock::now() - since;
    // Frames of the input before count as well, so the window must come to rest, unless it never does. Input that
    // changes nothing draws nothing.
    return (frames > now ? still > milliseconds(120) : still > milliseconds(400)) || frames >= now + count + 6;
  };
  waitFor(settled, 20);
}

void EditorTest::move(double x, double y) {
  input({"search", "--name", "Tyndall", "mousemove", "--window", "%1", std::to_string(static_cast<int>(x)),
         std::to_string(static_cast<int>(y))});
  waitFrames(2);
}

void EditorTest::pull(const std::string& widget, double right, double down) {
  const nlohmann::json now = state();
  ASSERT_TRUE(now["widgets"].contains(widget)) << widget << " is not in the window";
  const auto rect = now["widgets"][widget].get<std::vector<double>>();
  // From a whole point, so that the way is just as far as asked for.
  const double x = std::round(rect[0] + rect[2] / 2), y = std::round(rect[1] + rect[3] / 2);
  move(x, y);
  input({"mousedown", "1"});
  waitFrames(2);
  for (int i = 1; i <= 3; ++i) move(x + std::round(right * i / 3), y + std::round(down * i / 3));
  input({"mouseup", "1"});
  waitFrames(3);
}

void EditorTest::drag(const std::string& widget, double from, double to) {
  const nlohmann::json now = state();
  ASSERT_TRUE(now["widgets"].contains(widget)) << widget << " is not in the window";
  const auto rect = now["widgets"][widget].get<std::vector<double>>();
  const auto move = [&](double share) {
    const int x = static_cast<int>(rect[0] + share * rect[2]), y = static_cast<int>(rect[1] + rect[3] / 2);
    input({"search", "--name", "Tyndall", "mousemove", "--window", "%1", std::to_string(x), std::to_string(y)});
    waitFrames(2);
  };
  move(from);
  input({"mousedown", "1"});
  waitFrames(2);
  for (int i = 1; i <= 4; ++i) move(from + (to - from) * i / 4);
  input({"mouseup", "1"});
  waitFrames(3);
}

void EditorTest::keys(const std::vector<std::string>& names) {
  for (const std::string& name : names) input({"keydown", name});
  waitFrames(2);
  for (auto name = names.rbegin(); name != names.rend(); ++name) input({"keyup", *name});
  waitFrames(2);
}

void EditorTest::clickAt(double x, double y) {
  move(x, y);
  input({"mousedown", "1"});
  waitFrames(2);
  input({"mouseup", "1"});
  waitFrames(2);
}

void EditorTest::click(const std::string& widget) {
  const nlohmann::json now = state();
  ASSERT_TRUE(now["widgets"].contains(widget)) << widget << " is not in the window";
  const auto rect = now["widgets"][widget].get<std::vector<double>>();
  clickAt(rect[0] + std::min(rect[2], rect[3]) / 2, rect[1] + rect[3] / 2);
}

}  // namespace tyndall::editor_test
