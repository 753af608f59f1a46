// Rows in the order of depth against brute force. The rows are built here by sorting and counting; the words of the
// query are the shader's own text, in float against long double where they hold numbers.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "lib/cpp.hpp"

namespace {

using namespace tyndall::lib;

std::size_t cases() {
  const char* asked = std::getenv("TYNDALL_STRESS_CASES");
  return asked != nullptr ? std::strtoull(asked, nullptr, 10) : 1'000'000;
}

TEST(DepthOrder, LowBitsAreAsMany) {
  for (int n = 0; n <= 32; ++n) EXPECT_EQ(std::popcount(f32::lowBits(n)), n);
  for (int n = 0; n < 32; ++n) EXPECT_EQ(f32::lowBits(n) & 1u << n, 0u);
}

TEST(DepthOrder, PlanesSayWhichHaveABit) {
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    const auto plane = static_cast<std::uint32_t>(random());
    EXPECT_EQ(f32::planeWhere(plane, 1), plane);
    EXPECT_EQ(f32::planeWhere(plane, 6), ~plane) << "the lowest bit alone counts";
  }
}

// Which of 32 numbers are below another, by planes.
TEST(DepthOrder, PlanesCompareAsNumbersDo) {
  std::mt19937 random(2);
  for (int i = 0; i < 20'000; ++i) {
    const int bits = 1 + static_cast<int>(random() % 12);
    const std::uint32_t count = static_cast<std::uint32_t>(random()) % (1u << bits);
    std::uint32_t value[32], plane[12] = {}, expected = 0;
    for (int e = 0; e < 32; ++e) {
      value[e] = static_cast<std::uint32_t>(random()) % (1u << bits);
      expected |= (value[e] < count ? 1u : 0u) << e;
      for (int j = 0; j < bits; ++j) plane[j] |= (value[e] >> j & 1u) << e;
    }
    glm::uvec2 state(0u, ~0u);
    for (int j = bits - 1; j >= 0; --j) state = f32::planeLess(state, plane[j], count >> j);
    ASSERT_EQ(state.x, expected) << bits << " bits, count " << count;
  }
}

TEST(DepthOrder, BlocksAreAsFewAsFit) {
  for (int blockBits = 3; blockBits <= 6; ++blockBits)
    for (int columns = 1; columns <= 16384; columns += columns < 300 ? 1 : 97) {
      const int shift = f32::blockShift(columns, blockBits);
      EXPECT_LE((columns - 1) >> shift, (1 << blockBits) - 1) << columns;
      if (shift > 0) {
        EXPECT_GT((columns - 1) >> (shift - 1), (1 << blockBits) - 1) << columns;
      }
    }
}

// A ray's border lies within half a bin of its depth, and never beyond the last.
TEST(DepthOrder, BordersAreTheNearest) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<float> unit(0, 1);
  for (int i = 0; i < 100'000; ++i) {
    const float depth = i == 0 ? 0.0f : i == 1 ? 1.0f : unit(random);
    const int bits = 7 + i % 6;
    const int border = f32::depthBorder(depth, bits);
    ASSERT_GE(border, 0);
    ASSERT_LE(border, 1 << bits);
    ASSERT_LE(std::abs(double{depth} * (1 << bits) - border), 0.5 + 1e-3);
  }
}

// The integral of the transmittance over a block against its definition in long double, from nothing to the opaque.
TEST(DepthOrder, BlockIntegralHoldsForEveryOpticalDepth) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> unit(0, 1);
  double worst = 0;
  for (std::size_t i = 0; i < cases(); ++i) {
    const double sigma = i % 10 == 0 ? 0 : std::pow(10.0, -9 + 10 * unit(random)),
                 length = std::pow(10.0, -4 + 8 * unit(random));
    const long double x = static_cast<long double>(static_cast<float>(sigma)) * static_cast<float>(length);
    const float found =
        f32::blockIntegral(static_cast<float>(length), static_cast<float>(sigma) * static_cast<float>(length),
                           std::exp(-static_cast<float>(sigma) * static_cast<float>(length)),
                           1.0f / std::max(static_cast<float>(sigma), 1e-12f));
    const long double exact =
        x == 0 ? static_cast<long double>(static_cast<float>(length)) : -expm1l(-x) / static_cast<float>(sigma);
    ASSERT_TRUE(std::isfinite(found));
    worst = std::max(worst, static_cast<double>(fabsl(found - exact) / exact));
  }
  EXPECT_LT(worst, 1e-5);
}

enum class Kind { kRandom, kEqual, kSorted, kReversed, kFewValues, kAllLit, kAllShadowed, kSteps, kCount };

/// A row as the shaders keep it, of any number of columns and blocks.
struct Row {
  int columns, blockBits, binBits, shift, placeBits;
  std::vector<int> bin, before, order;   ///< of columns; columns in bins before each border; sorted columns
  std::vector<std::vector<int>> counts;  ///< of each record, of blocks
  std::vector<std::vector<std::uint32_t>> block, place;  ///< planes of each record; of each 32 columns
};

Row build(Kind kind, int columns, int blockBits, int binBits, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> depth(static_cast<std::size_t>(columns));
  const double middle = unit(random);
  for (int i = 0; i < columns; ++i) {
    double d = unit(random);
    if (kind == Kind::kEqual) d = middle;
    if (kind == Kind::kFewValues) d = std::floor(4 * d) / 4;
    if (kind == Kind::kAllLit) d = 1;
    if (kind == Kind::kAllShadowed) d = 0;
    if (kind == Kind::kSteps) d = i < columns / 2 ? 1.0 : middle;
    depth[static_cast<std::size_t>(i)] = d;
  }
  if (kind == Kind::kSorted) std::sort(depth.begin(), depth.end());
  if (kind == Kind::kReversed) std::sort(depth.rbegin(), depth.rend());
  Row row{columns, blockBits, binBits, f64::blockShift(columns, blockBits), 0, {}, {}, {}, {}, {}, {}};
  row.placeBits = std::max(row.shift, 1);
  for (const double d : depth) row.bin.push_back(f64::waveletBin(d, binBits));
  for (int b = 0; b <= 1 << binBits; ++b)
    row.before.push_back(
        static_cast<int>(std::count_if(row.bin.begin(), row.bin.end(), [b](int own) { return own < b; })));
  row.order.resize(static_cast<std::size_t>(columns));
  std::iota(row.order.begin(), row.order.end(), 0);
  std::shuffle(row.order.begin(), row.order.end(), random);  // ties in any order
  std::stable_sort(row.order.begin(), row.order.end(), [&](int a, int b) {
    return row.bin[static_cast<std::size_t>(a)] < row.bin[static_cast<std::size_t>(b)];
  });
  std::vector<int> counts(std::size_t{1} << blockBits);
  row.place.assign(static_cast<std::size_t>((columns + 31) / 32),
                   std::vector<std::uint32_t>(static_cast<std::size_t>(row.placeBits)));
  for (int i = 0; i < columns; ++i) {
    if (i % 32 == 0) {
      row.counts.push_back(counts);
      row.block.emplace_back(static_cast<std::size_t>(blockBits));
    }
    const int column = row.order[static_cast<std::size_t>(i)], own = column >> row.shift;
    for (int j = 0; j < blockBits; ++j)
      row.block.back()[static_cast<std::size_t>(j)] |= static_cast<std::uint32_t>(own >> j & 1) << (i % 32);
    const int rank = counts[static_cast<std::size_t>(own)]++;
    for (int j = 0; j < row.placeBits; ++j)
      row.place[static_cast<std::size_t>(column / 32)][static_cast<std::size_t>(j)] |=
          static_cast<std::uint32_t>(rank >> j & 1) << (column % 32);
  }
  return row;
}

// Counts of blocks and the very columns that hide a ray: those whose bin lies before the ray's border, whatever the
// row.
TEST(DepthOrder, FindsTheColumnsThatHideARay) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int r = 0; r < 600; ++r) {
    const int blockBits = 3 + r % 4;
    const int columns = r % 7 == 0 ? 1 + r % 40 : r % 11 == 0 ? 4096 : 64 + static_cast<int>(unit(random) * 1000);
    const Row row = build(static_cast<Kind>(r % static_cast<int>(Kind::kCount)), columns, blockBits, 9, random);
    for (int q = 0; q < 8; ++q) {
      const int border = q == 0 ? 0 : q == 1 ? 1 << 9 : f64::depthBorder(unit(random), 9);
      const int found = row.before[static_cast<std::size_t>(border)];
      const int record = std::min(found / 32, (columns - 1) / 32);
      const std::uint32_t own = f32::lowBits(found - 32 * record);
      for (int block = 0; block <= (columns - 1) >> row.shift; ++block) {
        std::uint32_t m = own;
        for (int j = 0; j < blockBits; ++j)
          m &= f32::planeWhere(row.block[static_cast<std::size_t>(record)][static_cast<std::size_t>(j)],
                               static_cast<std::uint32_t>(block >> j));
        const int count =
            std::popcount(m) + row.counts[static_cast<std::size_t>(record)][static_cast<std::size_t>(block)];
        int expected = 0;
        const int first = block << row.shift, last = std::min((block + 1) << row.shift, columns);
        for (int c = first; c < last; ++c) expected += row.bin[static_cast<std::size_t>(c)] < border ? 1 : 0;
        ASSERT_EQ(count, expected) << columns << " columns, block " << block;
        for (int c = first; c < last; ++c) {
          glm::uvec2 state(0u, ~0u);
          for (int j = row.placeBits - 1; j >= 0; --j)
            state = f32::planeLess(state, row.place[static_cast<std::size_t>(c / 32)][static_cast<std::size_t>(j)],
                                   static_cast<std::uint32_t>(count >> j));
          const bool all = count >> row.placeBits > 0;
          ASSERT_EQ(all || (state.x >> (c % 32) & 1u) != 0, row.bin[static_cast<std::size_t>(c)] < border)
              << columns << " columns, column " << c;
        }
      }
    }
  }
}

}  // namespace
