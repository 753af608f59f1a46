// Work shared out by rows over threads.
#pragma once

#include <cstdint>
#include <functional>

namespace tyndall::truth {

/// Calls `row(y)` once for each y in [0, height) from `threads` threads (0: one per core), the next free row at a time.
/// `progress`, if any, is called from the calling thread with the share done, at the end with 1; when it returns false,
/// no further row is begun. True if all rows were done.
bool forEachRow(std::uint32_t height, unsigned threads, const std::function<bool(double)>& progress,
                const std::function<void(std::uint32_t)>& row);

}  // namespace tyndall::truth
