#include "base/process.hpp"

#include <array>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <random>

#include <fcntl.h>
#include <unistd.h>

namespace tyndall {
namespace {

constexpr int kEnding[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};

/// What the handler reads: fixed memory and atomics, since it may run at any instruction of any thread.
struct Slot {
  std::atomic<bool> taken{false}, named{false};
  std::array<char, PATH_MAX> path{};
};
std::array<Slot, 32> slots;
std::array<std::atomic<void (*)()>, 4> tellers;
std::atomic<int> waiting{0}, pending{0};
std::atomic<bool> dying{false};

static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<void (*)()>::is_always_lock_free);

[[noreturn]] void die(int number) {
  // From here on no other thread makes a temporary file: see TemporaryFile.
  dying = true;
  for (const auto& tell : tellers)
    if (void (*const function)() = tell) function();
  for (const Slot& slot : slots)
    if (slot.named) ::unlink(slot.path.data());
  std::signal(number, SIG_DFL);
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, number);
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
  ::raise(number);
  ::_exit(128 + number);  // by the signal's default action nothing comes here
}

void handle(int number) {
  const int before = errno;
  if (waiting > 0) {
    pending = number;
    errno = before;
    return;
  }
  die(number);
}

std::string randomName() {
  std::random_device source;
  char name[32];
  std::snprintf(name, sizeof name, ".tyndall-%08x%08x", source(), source());
  return name;
}

}  // namespace

void prepareProcess() {
  // Standard output of nothing takes nothing: /dev/null for reading refuses every byte, as a closed one does.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0) (void)::open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY);
  for (const int number : {SIGXFSZ, SIGPIPE}) std::signal(number, SIG_IGN);
  for (const int number : kEnding) {
    struct sigaction before {};
    // What the caller has the program ignore (nohup) it goes on ignoring.
    if (::sigaction(number, nullptr, &before) != 0 || before.sa_handler != SIG_DFL) continue;
    struct sigaction action {};
    action.sa_handler = handle;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    for (const int other : kEnding) sigaddset(&action.sa_mask, other);
    ::sigaction(number, &action, nullptr);
  }
}

void beforeSignalEnds(void (*tell)()) {
  for (auto& place : tellers) {
    void (*none)() = nullptr;
    if (place == tell || place.compare_exchange_strong(none, tell)) return;
  }
}

SignalsWait::SignalsWait() { ++waiting; }

SignalsWait::~SignalsWait() {
  if (--waiting > 0) return;
  if (const int number = pending.exchange(0)) die(number);
}

TemporaryFile::TemporaryFile(const std::filesystem::path& folder) {
  path_ = (folder.empty() ? std::filesystem::path(".") : folder) / randomName();
  const std::string text = path_.string();
  if (text.size() >= PATH_MAX) return;  // no file can be made there
  while (dying) ::pause();              // the handler reads the slots
  for (std::size_t i = 0; i < slots.size(); ++i) {
    if (slots[i].taken.exchange(true)) continue;
    std::memcpy(slots[i].path.data(), text.c_str(), text.size() + 1);
    slots[i].named = true;
    slot_ = static_cast<int>(i);
    break;
  }
  // It has looked at them, perhaps before this one was named; the program ends in an instant.
  while (dying) ::pause();
}

TemporaryFile::~TemporaryFile() {
  if (!path_.empty()) ::unlink(path_.c_str());
  forget();
}

void TemporaryFile::forget() {
  path_.clear();
  if (slot_ < 0) return;
  Slot& slot = slots[static_cast<std::size_t>(slot_)];
  slot.named = false;
  slot.taken = false;
  slot_ = -1;
}

}  // namespace tyndall
