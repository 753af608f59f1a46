// Random numbers with fixed seeds, the same on every machine.
#pragma once

#include <cmath>
#include <cstdint>

namespace tyndall::stability {

/// SplitMix64 (Steele, Lea, Flood 2014, "Fast splittable pseudorandom number generators").
struct Random {
  std::uint64_t state;
  /// In [0, 1).
  double next() {
    std::uint64_t z = state += 0x9e3779b97f4a7c15ull;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }
  double between(double low, double high) { return low + (high - low) * next(); }
  /// Even in the logarithm; 0 < low < high.
  double decades(double low, double high) { return low * std::pow(high / low, next()); }
  /// In [0, count).
  int below(int count) { return static_cast<int>(next() * count); }
};

}  // namespace tyndall::stability
