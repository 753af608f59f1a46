// What this process holds of the machine's memory.
#pragma once

#include <cstdint>

namespace tyndall {

/// Bytes in RAM, heaps, code and mapped files together.
std::uint64_t residentBytes();
/// Bytes of the C library's heaps that somebody holds.
std::uint64_t allocatedBytes();
/// Gives the system what the C library keeps of memory that was freed: hundreds of MiB after a driver has compiled on
/// the CPU. Takes milliseconds.
void returnFreeMemory();

}  // namespace tyndall
