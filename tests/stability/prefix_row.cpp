#include "prefix_row.hpp"

#include <algorithm>

namespace tyndall::stability {

MapRow makeRow(Random& random, int columns, int bits) {
  const Blockers blockers = makeBlockers(random);
  const auto drawn = [&] {
    return static_cast<double>(blockers.z[static_cast<std::size_t>(random.below(static_cast<int>(blockers.z.size())))]);
  };
  MapRow row;
  const int order = random.below(4);
  const double drift = random.decades(1e-8, 1e-2);
  const int run = 1 + random.below(columns);
  double z = drawn();
  const double outlier = random.next() < 0.5 ? drawn() : z + random.decades(1e-7, 1e-2);
  for (int i = 0; i < columns; ++i) {
    if (order == 0) z = drawn();
    if (order == 1) z += drift * (random.next() - 0.4);
    if (order == 2 && i % run == 0) z = drawn();
    const double depth = std::clamp(0.5 + 0.5 * (order == 3 && i == 0 ? outlier : z), 0.0, 1.0);
    row.depth.push_back(static_cast<float>(bits == 16 ? std::round(depth * 65535) / 65535 : depth));
  }
  row.opticalDepth = random.next() < 0.3 ? 0.0f : static_cast<float>(random.decades(1e-6, 0.3));
  return row;
}

std::vector<float> columnWeights(const MapRow& row) {
  std::vector<float> weights;
  float power = 1;
  const float x = row.opticalDepth;
  for (std::size_t i = 0; i < row.depth.size(); ++i) {
    weights.push_back(power * (x < 1e-4f ? 1.0f - 0.5f * x : lib::f32::oneMinusExp(x) / x));
    power *= std::exp(-x);
  }
  return weights;
}

Blockers blockersOf(const MapRow& row, const std::vector<float>& weights, std::size_t count) {
  Blockers blockers;
  double total = 0;
  for (std::size_t i = 0; i < count; ++i) {
    blockers.z.push_back(2.0f * row.depth[i] - 1.0f);
    blockers.share.push_back(static_cast<double>(weights[i]));
    total += blockers.share.back();
  }
  for (double& share : blockers.share) share /= total;
  return blockers;
}

}  // namespace tyndall::stability
