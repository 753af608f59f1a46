// Who was called last: a plugin that never returns, ends the program or crashes takes the host with it, but not without
// a word.
#pragma once

#include <chrono>
#include <string>

namespace tyndall::host {

/// Lives as long as one call into a plugin, on the thread that makes it. Meanwhile, on standard error:
/// - a call that does not return is told of, again each time it has lasted twice as long (a thread of its own watches);
/// - one that calls exit() is, and the program's status becomes 1, since what it was asked for is not done;
/// - one that crashes is, before the program dies of the signal;
/// - one that is waited for when SIGINT or another signal ends the program is.
class PluginCall {
 public:
  /// `who`: "plugin 'volumetrics'"; `what`: "prepare()". Longer texts are cut.
  PluginCall(const std::string& who, const char* what);
  ~PluginCall();
  PluginCall(const PluginCall&) = delete;
  PluginCall& operator=(const PluginCall&) = delete;

  /// A line of the plugin's that waits for the end of the call that this thread is in: should that never come, the
  /// line is told with the rest.
  static void heard(const std::string& line);
  /// How long a call may last before it is told of. 10 s from the start: no layout() of ours takes a tenth of one.
  static void patience(std::chrono::milliseconds limit);

 private:
  void* slot_ = nullptr;   ///< null when more calls than are watched are under way
  void* outer_ = nullptr;  ///< the call that this thread was in before
};

}  // namespace tyndall::host
