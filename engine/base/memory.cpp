#include "base/memory.hpp"

#include <fstream>

#include <malloc.h>
#include <unistd.h>

namespace tyndall {

std::uint64_t residentBytes() {
  std::uint64_t all = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

std::uint64_t allocatedBytes() {
  const struct mallinfo2 heaps = ::mallinfo2();
  return heaps.uordblks + heaps.hblkhd;
}

void returnFreeMemory() { ::malloc_trim(0); }

}  // namespace tyndall
