// results.json as plain data. Whatever may be null there is optional here; texts that are missing are empty.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace tyndall::bench::report {

using Number = std::optional<double>;

struct Spread {
  double median = 0;
  Number low, high, n;
};  ///< ms; quartiles; repetitions
struct Region {
  double nrmse = 0;
  Number p99, maximum, bias, pixels;
};  ///< over the reference's mean
struct Split {
  std::optional<Region> all, silhouettes, interior, light;
};
struct Temporal {
  Number nrmseMean, flicker;
};
struct Pass {
  std::string name, owner;
  double ms = 0;
};
struct Value {
  std::string text;
  Number number;
};  ///< a setting; `number` for numbers only
struct Knob {
  std::string id;
  Value value;
};
struct Paper {
  std::string paper, table, row, baselineKey;
  Number figureMs, figureRatio;
};
using Settings = std::map<std::string, Value>;

struct Point {
  std::string key, level, series, technique, label;
  int camera = 0;
  Number seconds;
  int width = 0, height = 0;  ///< 0: not given
  std::vector<std::string> plots;
  std::optional<Knob> knob;
  Settings settings;                                 ///< what differs from the shared ones
  std::optional<Spread> frame, volumetrics, shadow;  ///< frame: gpu_ms
  std::vector<Pass> passes;
  Number memoryBytes, floorBytes;
  Split truth, march;  ///< errors against the ray-traced truth and against the converged march
  std::optional<Temporal> temporal;
  std::optional<Paper> paper;
  std::optional<std::string> failed;

  bool in(const std::string& plot) const;
};

struct Level {
  std::string name;
  int camera = 0;
  Number triangles, lights, truthSamples, truthSelfNrmse;
  std::optional<bool> lightInView;
};

struct Results {
  std::string device, driver, sweep, started;
  std::string command;  ///< optional in the file; else made from sweep and levels
  Number copyGbS;
  Settings settings;
  std::vector<Level> levels;  ///< with an entry for every level and camera of the points
  std::vector<Point> points;
};

/// Errors name the field by its path: "points[3].gpu_ms.median".
Result<Results> readResults(const std::string& json);

}  // namespace tyndall::bench::report
