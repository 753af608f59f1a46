#include "rows.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace tyndall::truth {

bool forEachRow(std::uint32_t height, unsigned threads, const std::function<bool(double)>& progress,
                const std::function<void(std::uint32_t)>& row) {
  if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
  threads = std::min(threads, height);
  std::atomic<std::uint32_t> next{0};
  std::atomic<bool> cancelled{false};
  std::mutex mutex;
  std::condition_variable changed;
  std::uint32_t done = 0;  // guarded by mutex

  const auto work = [&] {
    for (std::uint32_t y; !cancelled && (y = next++) < height;) {
      row(y);
      const std::lock_guard lock(mutex);
      ++done;
      changed.notify_one();
    }
  };
  std::vector<std::jthread> workers;
  try {
    for (unsigned i = 0; i < threads; ++i) workers.emplace_back(work);
  } catch (const std::system_error&) {
    // The system gives no more of them: fewer do it, or this one alone, which then reports at the end only.
    if (workers.empty()) work();
  }

  constexpr auto kReportEvery = std::chrono::milliseconds(100);
  std::unique_lock lock(mutex);
  while (!cancelled && done < height) {
    changed.wait_for(lock, kReportEvery, [&] { return done == height; });
    const double share = static_cast<double>(done) / height;
    lock.unlock();
    if (progress && !progress(share)) cancelled = true;
    lock.lock();
  }
  lock.unlock();
  workers.clear();  // joins
  return done == height;
}

}  // namespace tyndall::truth
