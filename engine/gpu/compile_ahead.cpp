#include "gpu/compile_ahead.hpp"

#include <chrono>
#include <thread>

#include <sys/resource.h>

namespace tyndall::gpu {
namespace {

constexpr int kNice = 5;
constexpr std::chrono::milliseconds kCacheWrite{20};

}  // namespace

void giveWayToFrames() {
  // A Linux thread has a niceness of its own. Without it frames are slower meanwhile, nothing else.
  (void)::setpriority(PRIO_PROCESS, 0, kNice);
}

void awaitDriverCache() { std::this_thread::sleep_for(kCacheWrite); }

}  // namespace tyndall::gpu
