// The free list against a map of every byte.
#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "gpu/range_allocator.hpp"

namespace tyndall::gpu {
namespace {

struct Taken {
  std::uint64_t offset, size;
};

bool fitsAnywhere(const std::vector<bool>& used, std::uint64_t size, std::uint64_t alignment) {
  for (std::uint64_t start = 0; start + size <= used.size(); start += alignment)
    if (std::none_of(used.begin() + static_cast<std::ptrdiff_t>(start),
                     used.begin() + static_cast<std::ptrdiff_t>(start + size), [](bool b) { return b; }))
      return true;
  return false;
}

TEST(RangeAllocator, AgreesWithAMapOfEveryByte) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    constexpr std::uint64_t kSize = 997;  // a prime: nothing ends by luck on an alignment
    RangeAllocator ranges(kSize);
    std::vector<bool> used(kSize, false);
    std::vector<Taken> taken;
    int refused = 0;
    for (int step = 0; step < 2000; ++step) {
      if (taken.empty() || random() % 5 < 3) {
        const std::uint64_t size = 1 + random() % 90, alignment = 1ull << random() % 6;
        const auto offset = ranges.allocate(size, alignment);
        ASSERT_EQ(offset.has_value(), fitsAnywhere(used, size, alignment))
            << "size " << size << " alignment " << alignment;
        if (!offset) {
          ++refused;
          continue;
        }
        ASSERT_EQ(*offset % alignment, 0u);
        ASSERT_LE(*offset + size, kSize);
        for (std::uint64_t i = *offset; i < *offset + size; ++i) {
          ASSERT_FALSE(used[i]) << "byte " << i << " was given twice";
          used[i] = true;
        }
        taken.push_back({*offset, size});
      } else {
        const std::size_t which = random() % taken.size();
        const Taken gone = taken[which];
        taken[which] = taken.back();
        taken.pop_back();
        ranges.free(gone.offset, gone.size);
        for (std::uint64_t i = gone.offset; i < gone.offset + gone.size; ++i) used[i] = false;
      }
      ASSERT_EQ(ranges.freeBytes(), static_cast<std::uint64_t>(std::count(used.begin(), used.end(), false)));
    }
    EXPECT_GT(refused, 0) << "the block never filled, so refusal was not tested";
    for (const Taken& t : taken) ranges.free(t.offset, t.size);
    EXPECT_TRUE(ranges.unused());
    EXPECT_EQ(ranges.allocate(kSize, 1), 0u) << "the free ranges did not merge into one";
  }
}

TEST(RangeAllocator, TakesTheSmallestRangeThatFits) {
  RangeAllocator ranges(100);
  ASSERT_EQ(ranges.allocate(100, 1), 0u);
  ranges.free(10, 30);
  ranges.free(60, 12);
  EXPECT_EQ(ranges.allocate(12, 1), 60u);
  EXPECT_FALSE(ranges.allocate(31, 1).has_value());
}

TEST(RangeAllocatorDeathTest, FreeingTwiceIsABug) {
  RangeAllocator ranges(100);
  ASSERT_EQ(ranges.allocate(10, 1), 0u);
  ranges.free(0, 10);
  EXPECT_DEATH(ranges.free(0, 10), "already free");
  EXPECT_DEATH(ranges.free(95, 10), "range at 95");
}

}  // namespace
}  // namespace tyndall::gpu
