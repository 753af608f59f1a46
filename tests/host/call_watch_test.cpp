// A plugin that takes the host with it says so, or rather is said to have.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/process.hpp"
#include "call_watch.hpp"
#include "host/host.hpp"

namespace tyndall::host {
namespace {

using namespace std::chrono_literals;

/// Loads a plugin in a process of its own.
void load(const char* name) {
  (void)Plugin::load(std::filesystem::path(TYNDALL_TEST_PLUGINS) / (std::string(name) + ".so"));
  std::_Exit(77);  // it came back
}

class CallWatch : public ::testing::Test {
 protected:
  // Each death in a new process, not in a fork, which has one thread of the several.
  void SetUp() override { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

TEST_F(CallWatch, whoEndsTheProgramIsNamedAndTheStatusIsNotSuccess) {
  EXPECT_EXIT(load("exits"), testing::ExitedWithCode(1),
              "^tyndall: plugin 'variant': its init\\(\\) ended the program; .*; it said: my data is missing\n$");
  EXPECT_EXIT(load("exits_when_loaded"), testing::ExitedWithCode(1),
              "plugin 'exits_when_loaded.so'.*ended the program");
}

TEST_F(CallWatch, whoCrashesIsNamed) {
  EXPECT_EXIT(load("aborts"), testing::KilledBySignal(SIGABRT),
              "plugin 'variant': the program crashed in its init\\(\\)");
#if !defined(__SANITIZE_ADDRESS__)  // which tells of it itself
  EXPECT_EXIT(load("endless_stack"), testing::KilledBySignal(SIGSEGV),
              "plugin 'variant': the program crashed in its init\\(\\) \\(SIGSEGV\\)");
#endif
}

TEST_F(CallWatch, whoDoesNotReturnIsNamedWhileTheProgramWaits) {
  const auto waitAndEnd = [](std::chrono::milliseconds patience, std::chrono::milliseconds end) {
    prepareProcess();
    PluginCall::patience(patience);
    std::thread([end] {
      std::this_thread::sleep_for(end);
      ::kill(::getpid(), SIGTERM);
    }).detach();
    load("loops");
  };
  EXPECT_EXIT(waitAndEnd(50ms, 1000ms), testing::KilledBySignal(SIGTERM),
              "plugin 'variant': its init\\(\\) has not returned for 0\\.");
  EXPECT_EXIT(waitAndEnd(1min, 2500ms), testing::KilledBySignal(SIGTERM),
              "^tyndall: plugin 'variant': init\\(\\) had not returned when the program was ended\n$");
}

TEST_F(CallWatch, aCallInTimeIsNotToldOfAndALateOneIsWhenItReturns) {
  testing::internal::CaptureStderr();
  PluginCall::patience(200ms);
  { const PluginCall quick("plugin 'quick'", "prepare()"); }
  {
    const PluginCall outer("plugin 'outer'", "layout()");
    const PluginCall inner("plugin 'inner'", "create()");
    std::this_thread::sleep_for(500ms);
  }
  PluginCall::patience(10s);
  const std::string told = testing::internal::GetCapturedStderr();
  EXPECT_EQ(told.find("quick"), std::string::npos) << told;
  EXPECT_NE(told.find("plugin 'outer': its layout() has not returned for"), std::string::npos) << told;
  EXPECT_NE(told.find("plugin 'inner': its create() returned after"), std::string::npos) << told;
}

TEST_F(CallWatch, moreCallsThanAreWatchedAreCallsAllTheSame) {
  std::vector<std::jthread> threads;
  for (int i = 0; i < 32; ++i)
    threads.emplace_back([] {
      for (int k = 0; k < 1000; ++k) const PluginCall call("plugin 'many'", "prepare()");
    });
}

}  // namespace
}  // namespace tyndall::host
