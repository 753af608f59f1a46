// The running average of prefix.glsl along one row, in float, with what it should have been.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "distributions.hpp"
#include "lib/cpp.hpp"

namespace tyndall::stability {

/// One row of a rectified map: normalised depths in [0, 1] as stored (16-bit or float), and the optical depth of a
/// column.
struct MapRow {
  std::vector<float> depth;
  float opticalDepth = 0;
};

/// `columns` depths: drawn from a distribution, drifting, in runs, or one outlier before a constant rest (which a
/// running average forgets last). `bits`: 16, or 32 for float.
MapRow makeRow(Random& random, int columns, int bits);

/// The weight of each column relative to its segment, exactly as the shader's floats make it.
std::vector<float> columnWeights(const MapRow& row);

/// Running averages of vectors (`make(column)`) by the recurrence of prefix.glsl in float: plain, or with what rounding
/// loses carried on (shaders/lib/average.glsl). `visit(column, average)` is called for every column.
template <std::size_t N, class Make, class Visit>
void runningAverage(const std::vector<float>& weights, bool compensated, Make&& make, Visit&& visit) {
  std::array<glm::vec4, N> average{}, rest{};
  float total = 0;
  for (std::size_t column = 0; column < weights.size(); ++column) {
    const std::array<glm::vec4, N> next = make(column);
    total += weights[column];
    const float share = total > 0 ? weights[column] / total : 1.0f;
    for (std::size_t i = 0; i < N; ++i) {
      const glm::vec4 step = (next[i] - average[i]) * share + rest[i];
      if (compensated) rest[i] = lib::f32::lostInSum(average[i], step);
      average[i] += step;
    }
    visit(column, average);
  }
}

/// The same by the workgroup scan: `runs` runs of columns are averaged each on its own, and every run starts from the
/// join of the averages before it.
template <std::size_t N, class Make, class Visit>
void scannedAverage(const std::vector<float>& weights, std::size_t runs, Make&& make, Visit&& visit) {
  using Vectors = std::array<glm::vec4, N>;
  struct State {
    Vectors average{}, rest{};
    float total = 0;
    void take(const Vectors& next, float weight) {
      total += weight;
      const float share = total > 0 ? weight / total : 1.0f;
      for (std::size_t i = 0; i < N; ++i) {
        const glm::vec4 step = (next[i] - average[i]) * share + rest[i];
        rest[i] = lib::f32::lostInSum(average[i], step);
        average[i] += step;
      }
    }
  };
  const std::size_t length = (weights.size() + runs - 1) / runs;
  std::vector<State> finished;
  for (std::size_t from = 0; from < weights.size(); from += length) {
    const std::size_t to = std::min(from + length, weights.size());
    State own, joined;
    for (std::size_t column = from; column < to; ++column) own.take(make(column), weights[column]);
    for (const State& before : finished) joined.take(before.average, before.total);
    finished.push_back(own);
    for (std::size_t column = from; column < to; ++column) {
      joined.take(make(column), weights[column]);
      visit(column, joined.average);
    }
  }
}

/// Blockers of the first `count` columns, z = 2 depth - 1 as the shader computes it, with the shares that the weights
/// give.
Blockers blockersOf(const MapRow& row, const std::vector<float>& weights, std::size_t count);

}  // namespace tyndall::stability
