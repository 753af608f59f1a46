// What K stored sums of a row are best made of: weights of K reference rays, joined by a polynomial in the inclination,
// or Chebyshev polynomials of the column as channels, joined so that they make the ray's own weights. In double,
// without visibility's own error: rows of lit and shadowed stretches, so that all that is judged is the weights.
// plugins/volumetrics/techniques/exact/README.md has the table.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace volumetrics {
namespace {

constexpr int kColumns = 1024;
constexpr double kPrefixKappa = 0.15, kLeastKappa = 0.01;  // stages/reference_rays.glsl

/// A row of a sun's map: columns evenly spaced across the light, `depth` the optical depth of all of them there. A
/// ray's is that times its cosecant.
struct Row {
  double depth;
  std::vector<bool> lit;
};

double node(int k, int count) { return std::cos(std::numbers::pi * (2 * k + 1) / (2.0 * count)); }

/// What a ray of this cosecant scatters in a column, but for a factor.
double weight(const Row& row, double cosecant, int column) {
  const double step = row.depth * cosecant / kColumns;
  return std::exp(-step * column) * -std::expm1(-step);
}

double visibleShare(const Row& row, double cosecant, int end) {
  double lit = 0, all = 0;
  for (int i = 0; i < end; ++i) {
    const double w = weight(row, cosecant, i);
    all += w, lit += row.lit[static_cast<std::size_t>(i)] ? w : 0;
  }
  return lit / all;
}

/// The weights of value k at x of the polynomial through the places `at`.
std::vector<double> lagrange(const std::vector<double>& at, double x) {
  std::vector<double> share(at.size(), 1);
  for (std::size_t k = 0; k < at.size(); ++k)
    for (std::size_t j = 0; j < at.size(); ++j)
      if (j != k) share[k] *= (x - at[j]) / (at[k] - at[j]);
  return share;
}

/// As `exact` has it: nodes spread in log(1 + depth cosecant), joined in the prefix's own coordinate.
double byReferenceRays(const Row& row, double least, double most, int count, double cosecant, int end) {
  const double kappa = std::max(kPrefixKappa * row.depth * end / kColumns, kLeastKappa);
  std::vector<double> at, value;
  for (int k = 0; k < count; ++k) {
    const double low = std::log1p(row.depth * least), high = std::log1p(row.depth * most);
    const double c = std::expm1(low + (high - low) * (0.5 + 0.5 * node(k, count))) / row.depth;
    at.push_back(std::log1p(kappa * c));
    value.push_back(visibleShare(row, c, end));
  }
  const std::vector<double> share = lagrange(at, std::log1p(kappa * cosecant));
  double sum = 0;
  for (std::size_t k = 0; k < share.size(); ++k) sum += share[k] * value[k];
  return std::clamp(sum, 0.0, 1.0);
}

/// Channels: sums of T_k(column) times the weights of the middle reference ray. The ray's weights over those are taken
/// as the polynomial of the column through `count` Chebyshev nodes of the prefix, which is a sum of the channels;
/// normalised by the same sum of a lit row.
double byChannels(const Row& row, double least, double most, int count, double cosecant, int end) {
  const double low = std::log1p(row.depth * least), high = std::log1p(row.depth * most);
  const double middle = std::expm1(0.5 * (low + high)) / row.depth;
  std::vector<double> at, ratio;
  for (int k = 0; k < count; ++k) {
    at.push_back((0.5 + 0.5 * node(k, count)) * end);
    ratio.push_back(std::exp(-row.depth * (cosecant - middle) * at.back() / kColumns));
  }
  // Polynomials of one degree are one space, so that the sums can be taken with the polynomial itself.
  double lit = 0, all = 0;
  for (int i = 0; i < end; ++i) {
    const std::vector<double> share = lagrange(at, i + 0.5);
    double polynomial = 0;
    for (std::size_t k = 0; k < share.size(); ++k) polynomial += share[k] * ratio[k];
    const double w = weight(row, middle, i) * polynomial;
    all += w, lit += row.lit[static_cast<std::size_t>(i)] ? w : 0;
  }
  return std::clamp(all > 0 ? lit / all : 0, 0.0, 1.0);
}

Row randomRow(std::mt19937& random, double depth) {
  Row row{depth, {}};
  std::exponential_distribution<double> stretch(1.0 / 60);
  for (bool lit = (random() & 1u) != 0; row.lit.size() < kColumns; lit = !lit)
    row.lit.insert(row.lit.end(), 1 + static_cast<std::size_t>(stretch(random)), lit);
  row.lit.resize(kColumns);
  return row;
}

struct View {
  const char* name;
  double least, most;  ///< inclinations of the slice, radians
};

TEST(ReferenceChannels, ReferenceRaysBeatPolynomialsOfTheColumnWhereItIsSeen) {
  std::printf("%-22s depth  K   reference rays   channels   (RMS error of the visible share)\n", "inclinations");
  for (const View& view :
       {View{"0.5 to 1.2, sun aside", 0.5, 1.2}, View{"0.1 to 0.7", 0.1, 0.7}, View{"0.02 to 1, on screen", 0.02, 1.0}})
    for (const double depth : {0.3, 1.5})
      for (const int count : {3, 4}) {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> theta(view.least, view.most), place(0.02, 1);
        double rays = 0, channels = 0;
        constexpr int kCases = 300;
        for (int i = 0; i < kCases; ++i) {
          const Row row = randomRow(random, depth);
          const double c = 1 / std::sin(theta(random));
          const int end = std::max(1, static_cast<int>(place(random) * kColumns));
          const double truth = visibleShare(row, c, end), least = 1 / std::sin(view.most),
                       most = 1 / std::sin(view.least);
          rays += std::pow(byReferenceRays(row, least, most, count, c, end) - truth, 2);
          channels += std::pow(byChannels(row, least, most, count, c, end) - truth, 2);
        }
        rays = std::sqrt(rays / kCases), channels = std::sqrt(channels / kCases);
        std::printf("%-22s %-6g %d   %-14.2g   %-8.2g\n", view.name, depth, count, rays, channels);
        // Below this neither is seen, and the channels are now and then the better by a third.
        constexpr double kUnseen = 1e-4;
        EXPECT_LT(rays, std::max(channels, kUnseen)) << view.name << ", depth " << depth << ", K = " << count;
        if (channels > kUnseen) {
          EXPECT_LT(2 * rays, channels) << view.name << ", depth " << depth << ", K = " << count;
        }
      }
}

}  // namespace
}  // namespace volumetrics
