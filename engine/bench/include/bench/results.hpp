// What was measured: results.json (the report reads it), results.csv, and the comparison of two.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/statistics.hpp"
#include "bench/sweep.hpp"

namespace tyndall::bench {

/// Errors over some pixels, divided by the reference's mean over all pixels.
struct Errors {
  double nrmse = 0, p99 = 0, maximum = 0, bias = 0;
  std::uint64_t pixels = 0;
};
/// Against one reference; a part without pixels is missing.
struct SplitErrors {
  std::optional<Errors> all, silhouettes, interior, light;
};

struct PassMs {
  std::string name, owner;
  double milliseconds = 0;
};

struct LevelFigures {
  std::string name;
  std::uint32_t camera = 0;
  std::uint64_t triangles = 0, lights = 0;
  bool lightInView = false;
  std::uint32_t truthSamples = 0;
  std::optional<double> truthSelf;  ///< nRMSE of the truth against one of half the samples
};

struct PointFigures {
  std::string key;  ///< of everything that makes the point
  std::string level;
  std::uint32_t camera = 0;
  double seconds = 0;
  Size size{0, 0};
  std::string series, technique, label;
  std::vector<std::string> plots;
  std::optional<std::pair<std::string, std::string>> knob;
  Assignments settings;  ///< besides those that all points share
  Spread gpu, volumetrics, shadows;
  std::vector<PassMs> passes;
  std::uint64_t memoryBytes = 0;
  std::optional<std::uint64_t> movedBytes;  ///< PluginEffect::bytesMoved()
  std::optional<SplitErrors> truth, march;
  std::optional<double> motionError, flicker;
  std::optional<PaperFigure> paper;
  std::string baselineKey;
  std::string failure;  ///< why there are no figures; "" = there are
};

struct Results {
  std::string device, driver, sweep, started, command;
  std::uint32_t repetitions = 0;        ///< asked for
  std::optional<double> copyGigabytes;  ///< a second, read and written
  Assignments settings;
  std::vector<LevelFigures> levels;
  std::vector<PointFigures> points;

  const PointFigures* find(const std::string& key) const;
};

std::string resultsJson(const Results& results);
Result<Results> readResults(const std::string& json, const std::string& source);
std::string resultsCsv(const Results& results);

/// A table, one line a point that both have: times and errors of `b` over those of `a`, and the medians of the ratios.
std::string compareResults(const Results& a, const Results& b);

}  // namespace tyndall::bench
