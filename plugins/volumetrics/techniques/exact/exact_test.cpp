// The wavelet matrix against brute force: the share of the weight of a row's first s columns whose depth lies before
// the ray's, over random rows of every kind. The matrix is built here, by sorting and filtering; the steps of the query
// are the shader's own text.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "lib/cpp.hpp"

namespace {

using namespace tyndall::lib;

enum class Kind { kRandom, kEqual, kSorted, kReversed, kFewValues, kAllLit, kAllShadowed, kOneColumn, kSteps, kCount };

struct Row {
  std::vector<double> depth, weight;
};

Row makeRow(Kind kind, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const auto columns = kind == Kind::kOneColumn ? std::size_t{1} : 2 + static_cast<std::size_t>(unit(random) * 98);
  Row row;
  const double falloff = std::pow(10.0, -4 + 4.5 * unit(random)), middle = unit(random);
  for (std::size_t i = 0; i < columns; ++i) {
    row.weight.push_back(std::exp(-falloff * static_cast<double>(i)));
    double d = unit(random);
    if (kind == Kind::kEqual) d = middle;
    if (kind == Kind::kFewValues) d = std::floor(4 * d) / 4;
    if (kind == Kind::kAllLit) d = 1;
    if (kind == Kind::kAllShadowed) d = 0;
    if (kind == Kind::kSteps) d = i < columns / 2 ? 1.0 : middle;
    row.depth.push_back(d);
  }
  if (kind == Kind::kSorted) std::sort(row.depth.begin(), row.depth.end());
  if (kind == Kind::kReversed) std::sort(row.depth.rbegin(), row.depth.rend());
  return row;
}

/// What a texel stores, per level and position.
struct Matrix {
  int bits = 0, binBits = 0;
  std::vector<std::vector<int>> zeros;
  std::vector<std::vector<double>> share;
  std::vector<int> ranks;  ///< per bin: depths in bins before it
};

Matrix build(const Row& row, int binBits) {
  Matrix matrix;
  matrix.binBits = binBits;
  while ((1u << matrix.bits) < row.depth.size()) ++matrix.bits;
  const int elements = 1 << matrix.bits;
  const auto bin = [&](int column) {
    return column < static_cast<int>(row.depth.size()) ? f64::waveletBin(row.depth[column], binBits) : 1 << binBits;
  };
  std::vector<int> sorted(elements), rank(elements);
  std::iota(sorted.begin(), sorted.end(), 0);
  std::stable_sort(sorted.begin(), sorted.end(), [&](int a, int b) { return bin(a) < bin(b); });
  for (int i = 0; i < elements; ++i) rank[sorted[i]] = i;
  for (int b = 0; b <= 1 << binBits; ++b)
    matrix.ranks.push_back(
        static_cast<int>(std::count_if(sorted.begin(), sorted.end(), [&](int column) { return bin(column) < b; })));
  for (int level = 0; level < matrix.bits; ++level) {
    std::vector<int> zeros;
    std::vector<double> share;
    for (int node = 0; node < 1 << level; ++node) {
      int count = 0;
      double ofZeros = 0, ofAll = 0;
      for (int column = 0; column < elements; ++column) {
        if (rank[column] >> (matrix.bits - level) != node) continue;
        const double weight = column < static_cast<int>(row.weight.size()) ? row.weight[column] : 1;
        const bool one = f64::waveletOne(rank[column], level, matrix.bits);
        count += one ? 0 : 1;
        ofZeros += one ? 0 : weight;
        ofAll += weight;
        zeros.push_back(count);
        share.push_back(f64::waveletShare(ofZeros, ofAll));
      }
    }
    matrix.zeros.push_back(zeros);
    matrix.share.push_back(share);
  }
  return matrix;
}

/// Share of the weight of the first `elements` columns that is blocked, after `levels` levels; shares rounded to `bits`
/// bits.
template <class Real2, class Step, class End>
double query(const Matrix& matrix, int elements, double depth, int levels, int storedBits, Step step, End end) {
  const int bins = 1 << matrix.binBits;
  const double at = depth * bins;
  const int bin = std::clamp(static_cast<int>(at), 0, bins - 1);
  const double rank = matrix.ranks[bin] + std::clamp(at - bin, 0.0, 1.0) * (matrix.ranks[bin + 1] - matrix.ranks[bin]);
  const int whole = std::min(static_cast<int>(rank), (1 << matrix.bits) - 1);
  Real2 found(0, 1);
  int left = elements, level = 0;
  const double scale = std::exp2(storedBits) - 1;
  for (; level < levels && left > 0; ++level) {
    const std::size_t texel = static_cast<std::size_t>(f64::waveletNode(whole, level, matrix.bits) + left - 1);
    const bool one = f64::waveletOne(whole, level, matrix.bits);
    double share = matrix.share[level][texel];
    if (storedBits > 0) share = std::round(share * scale) / scale;
    found = step(found, share, one);
    left = one ? left - matrix.zeros[level][texel] : matrix.zeros[level][texel];
  }
  return left > 0 ? end(found, rank, whole, level, matrix.bits) : found.x;
}

double queryDouble(const Matrix& matrix, int elements, double depth, int levels) {
  return query<f64::Real2>(
      matrix, elements, depth, levels, 0, [](f64::Real2 f, double s, bool one) { return f64::waveletStep(f, s, one); },
      [](f64::Real2 f, double r, int w, int l, int b) { return f64::waveletEnd(f, r, w, l, b); });
}
double queryStored(const Matrix& matrix, int elements, double depth, int levels) {
  return query<f32::Real2>(
      matrix, elements, depth, levels, 16,
      [](f32::Real2 f, double s, bool one) { return f32::waveletStep(f, static_cast<float>(s), one); },
      [](f32::Real2 f, double r, int w, int l, int b) {
        return static_cast<double>(f32::waveletEnd(f, static_cast<float>(r), w, l, b));
      });
}

/// Brute force: share of the weight of the first `elements` columns whose depth is below `depth`.
double blockedBefore(const Row& row, int elements, double depth) {
  double blocked = 0, all = 0;
  for (int i = 0; i < elements; ++i) {
    all += row.weight[i];
    blocked += row.depth[i] < depth ? row.weight[i] : 0;
  }
  return blocked / all;
}

TEST(WaveletMatrix, IsTheBruteForceSumButForTheBinOfTheDepth) {
  std::mt19937_64 random(20261126);
  std::uniform_real_distribution<double> unit(0, 1);
  constexpr int kBinBits = 8;
  constexpr double kBin = 1.0 / (1 << kBinBits);
  double worst = 0, worstStored = 0;
  int cases = 0;
  for (int r = 0; cases < 1'000'000; ++r) {
    const Row row = makeRow(static_cast<Kind>(r % static_cast<int>(Kind::kCount)), random);
    const Matrix matrix = build(row, kBinBits);
    for (int q = 0; q < 400; ++q, ++cases) {
      const int elements = 1 + static_cast<int>(unit(random) * static_cast<double>(row.depth.size()));
      // Every third query lies on the border of a bin, where the answer has no quantisation at all.
      const double depth = q % 3 == 0 ? std::floor(unit(random) * (1 << kBinBits)) * kBin : unit(random);
      const double low = std::floor(depth / kBin) * kBin;
      const double least = blockedBefore(row, elements, low),
                   most = q % 3 == 0 ? least : blockedBefore(row, elements, low + kBin);
      const double found = queryDouble(matrix, elements, depth, matrix.bits);
      const double stored = queryStored(matrix, elements, depth, matrix.bits);
      const auto outside = [&](double value) { return std::max(least - value, value - most); };
      worst = std::max(worst, outside(found));
      worstStored = std::max(worstStored, outside(stored));
      ASSERT_LE(outside(found), 1e-12) << "row " << r << ", " << elements << " of " << row.depth.size() << ", depth "
                                       << depth;
      // 16-bit shares: each level adds half a step at most, of what is still undecided.
      ASSERT_LE(outside(stored), (matrix.bits + 1) * 0.5 / 65535 + 1e-6) << "row " << r;
    }
  }
  std::printf("%d cases: outside the bin's bounds by %.2e in double, %.2e with 16-bit shares\n", cases, worst,
              worstStored);
}

// Fewer levels leave a node of ranks undecided: the answer lies between those of its first and its last depth.
TEST(WaveletMatrix, FewerLevelsStayWithinTheNodeTheyEndIn) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> error(8, 0);
  for (int r = 0; r < 2000; ++r) {
    Row row = makeRow(Kind::kRandom, random);
    const Matrix matrix = build(row, 12);
    std::vector<double> sorted = row.depth;
    std::sort(sorted.begin(), sorted.end());
    for (int q = 0; q < 50; ++q) {
      const int elements = 1 + static_cast<int>(unit(random) * static_cast<double>(row.depth.size()));
      const double depth = unit(random), exact = blockedBefore(row, elements, depth);
      const double at = depth * 4096;
      const int bin = static_cast<int>(at);
      const int rank = static_cast<int>(matrix.ranks[bin] + (at - bin) * (matrix.ranks[bin + 1] - matrix.ranks[bin]));
      for (int levels = 0; levels < matrix.bits; ++levels) {
        const double found = queryDouble(matrix, elements, depth, levels);
        // Ranks follow the bins of the depth, so a bin is added at either end.
        const int size = 1 << (matrix.bits - levels), columns = static_cast<int>(sorted.size());
        const int first = std::min(rank / size * size, columns - 1), last = rank / size * size + size;
        ASSERT_GE(found, blockedBefore(row, elements, sorted[static_cast<std::size_t>(first)] - 1.0 / 4096) - 1e-9);
        ASSERT_LE(
            found,
            (last < columns ? blockedBefore(row, elements, sorted[static_cast<std::size_t>(last)] + 1.0 / 4096) : 1) +
                1e-9);
        error[static_cast<std::size_t>(levels)] += std::abs(found - exact);
      }
    }
  }
  for (int levels = 1; levels < 5; ++levels)
    EXPECT_LT(error[static_cast<std::size_t>(levels)], error[static_cast<std::size_t>(levels) - 1]);
}

}  // namespace
