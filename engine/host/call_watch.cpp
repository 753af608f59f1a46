#include "call_watch.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <unistd.h>

#include "base/log.hpp"
#include "base/process.hpp"

namespace tyndall::host {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// Fixed memory and atomics, since signal handlers read it.
struct Slot {
  std::atomic<bool> taken{false}, active{false};
  std::atomic<Clock::rep> start{0};
  std::array<char, 160> who{};
  std::array<char, 48> what{};
  std::array<char, 1024> said{};  ///< by the plugin, and not told yet
  Clock::duration tellAt{0};      ///< guarded by the watch's mutex

  Clock::duration lasted() const { return Clock::now() - Clock::time_point(Clock::duration(start)); }
};
std::array<Slot, 8> slots;  // one call a thread, and few threads have plugins
thread_local Slot* current = nullptr;
std::atomic<milliseconds::rep> limit{10000};

template <std::size_t N>
void copyText(std::array<char, N>& to, const char* from) {
  const std::size_t length = std::min(std::strlen(from), N - 1);
  std::memcpy(to.data(), from, length);
  to[length] = '\0';
}

/// "tyndall: <who>: <before><what><after>; it said: ..." to standard error, by nothing that a signal handler may not
/// call.
void tellPlainly(const Slot& slot, const char* before, const char* after) {
  std::array<char, 1600> line{};
  std::size_t length = 0;
  const bool said = slot.said[0] != '\0';
  for (const char* part : {"tyndall: ", slot.who.data(), ": ", before, slot.what.data(), after,
                           said ? "; it said: " : "", slot.said.data(), "\n"}) {
    const std::size_t more = std::min(std::strlen(part), line.size() - length);
    std::memcpy(line.data() + length, part, more);
    length += more;
  }
  (void)!::write(STDERR_FILENO, line.data(), length);
}

/// Of those that have lasted for so long that somebody may have ended the program because of them.
void tellOfWaiting() {
  for (const Slot& slot : slots)
    if (slot.active && slot.lasted() > std::chrono::seconds(2))
      tellPlainly(slot, "", " had not returned when the program was ended");
}

void tellOfExit() {
  if (current == nullptr) return;
  std::fflush(nullptr);
  tellPlainly(*current, "its ", " ended the program; a plugin's function returns");
  ::_exit(1);
}

void tellOfCrash(int number) {
  if (current != nullptr)
    tellPlainly(*current, "the program crashed in its ",
                number == SIGABRT  ? " (SIGABRT)"
                : number == SIGFPE ? " (SIGFPE)"
                : number == SIGILL ? " (SIGILL)"
                : number == SIGBUS ? " (SIGBUS)"
                                   : " (SIGSEGV)");
  // The instruction runs again and is then the death that it would have been.
  std::signal(number, SIG_DFL);
  if (number == SIGABRT) ::raise(number);
}

class Watch {
 public:
  Watch() {
    beforeSignalEnds(tellOfWaiting);
    std::atexit(tellOfExit);
    for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
      struct sigaction before {};
      // A sanitizer's or debugger's handler knows more than this one.
      if (::sigaction(number, nullptr, &before) != 0 || before.sa_handler != SIG_DFL) continue;
      struct sigaction action {};
      action.sa_handler = tellOfCrash;
      action.sa_flags = SA_ONSTACK;
      ::sigaction(number, &action, nullptr);
    }
    try {
      thread_ = std::thread([this] { watch(); });
    } catch (const std::system_error&) {  // no thread to be had: nobody tells of a call before it is over
    }
  }
  ~Watch() {
    if (process_ != ::getpid()) {  // a fork, which has no such thread
      if (thread_.joinable()) thread_.detach();
      return;
    }
    {
      const std::lock_guard lock(mutex_);
      ending_ = true;
    }
    wake_.notify_one();
    if (thread_.joinable()) thread_.join();
  }

  void begin(Slot& slot) {
    const std::lock_guard lock(mutex_);
    slot.tellAt = milliseconds(limit);
    slot.active = true;
    if (std::exchange(idle_, false)) wake_.notify_one();
  }
  void end(Slot& slot) {
    std::optional<Clock::duration> late;
    {
      const std::lock_guard lock(mutex_);
      slot.active = false;
      if (slot.tellAt > milliseconds(limit)) late = slot.lasted();
    }
    if (late) log::warning(text(slot) + " returned after " + seconds(*late));
    slot.taken = false;
  }
  void patience(milliseconds duration) {
    const std::lock_guard lock(mutex_);
    limit = duration.count();
    wake_.notify_one();
  }
  /// An own stack for the handler of a crash that is a stack without end.
  void giveStack() {
    stack_t now{};
    if (::sigaltstack(nullptr, &now) != 0 || (now.ss_flags & SS_DISABLE) == 0) return;
    constexpr std::size_t kBytes = 65536;
    const std::lock_guard lock(mutex_);
    stack_t own{};
    own.ss_sp = stacks_.emplace_back(std::make_unique<std::byte[]>(kBytes)).get();
    own.ss_size = kBytes;
    (void)::sigaltstack(&own, nullptr);
  }

 private:
  static std::string text(const Slot& slot) { return std::string(slot.who.data()) + ": its " + slot.what.data(); }
  static std::string seconds(Clock::duration time) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.1f s", std::chrono::duration<double>(time).count());
    return digits;
  }

  /// Sleeps while no plugin is called, and else until the first call has lasted too long.
  void watch() {
    std::unique_lock lock(mutex_);
    while (!ending_) {
      std::optional<Clock::duration> next;
      for (Slot& slot : slots) {
        if (!slot.active) continue;
        const Clock::duration lasted = slot.lasted();
        if (lasted >= slot.tellAt) {
          log::warning(text(slot) + " has not returned for " + seconds(lasted) + "; the program waits for it");
          while (slot.tellAt <= lasted) slot.tellAt = std::max<Clock::duration>(2 * slot.tellAt, milliseconds(1));
        }
        next = std::min(next.value_or(Clock::duration::max()), slot.tellAt - lasted);
      }
      idle_ = !next;
      if (next)
        wake_.wait_for(lock, *next);
      else
        wake_.wait(lock);
    }
  }

  std::mutex mutex_;
  std::condition_variable wake_;
  bool idle_ = false, ending_ = false;
  std::vector<std::unique_ptr<std::byte[]>> stacks_;
  const pid_t process_ = ::getpid();
  std::thread thread_;
};

Watch& watch() {
  static Watch instance;
  return instance;
}

}  // namespace

PluginCall::PluginCall(const std::string& who, const char* what) {
  outer_ = current;
  for (Slot& slot : slots) {
    if (slot.taken.exchange(true)) continue;
    copyText(slot.who, who.c_str());
    copyText(slot.what, what);
    slot.said[0] = '\0';
    slot.start = Clock::now().time_since_epoch().count();
    slot_ = current = &slot;
    thread_local const bool stack = (watch().giveStack(), true);
    (void)stack;
    watch().begin(slot);
    return;
  }
}

void PluginCall::heard(const std::string& line) {
  if (current == nullptr) return;
  const std::size_t length = std::strlen(current->said.data());
  const std::string more = (length > 0 ? "; " : "") + line;
  const std::size_t taken = std::min(more.size(), current->said.size() - 1 - length);
  std::memcpy(current->said.data() + length, more.data(), taken);
  current->said[length + taken] = '\0';
}

PluginCall::~PluginCall() {
  current = static_cast<Slot*>(outer_);
  if (slot_ != nullptr) watch().end(*static_cast<Slot*>(slot_));
}

void PluginCall::patience(milliseconds duration) { watch().patience(duration); }

}  // namespace tyndall::host
