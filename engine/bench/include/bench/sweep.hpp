// A sweep: which levels, sizes and settings are measured. Data, not code: techniques come from the registry, so that
// one that is added later joins every sweep.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/result.hpp"

namespace tyndall::bench {

using Assignments = std::map<std::string, std::string>;  ///< parameter id -> value as text
using Size = std::pair<std::uint32_t, std::uint32_t>;    ///< width, height in pixels

/// A parameter whose values are tried with every technique that reads it.
struct Knob {
  std::string id;
  std::vector<std::string> values;
  std::vector<std::string> together;  ///< ids that take the same value
  Assignments with;                ///< set beside it; a technique that does not read one of these does without that one
  std::vector<std::string> plots;  ///< families of plots that the points belong to
};

/// What a paper measured, for the table beside ours.
struct PaperFigure {
  std::string paper, table, row;
  std::optional<double> milliseconds;  ///< the paper's own
  std::optional<double> ratio;         ///< the paper's time over its brute force's
};

/// A setting of its own, by name.
struct Single {
  std::string series, label;
  Assignments settings;
  std::vector<std::string> plots;
  std::optional<PaperFigure> paper;
  bool baseline = false;  ///< the brute force that paper figures are divided by
};

/// A moving camera: `frames` steps, each a turn about the vertical and a step of the level's animations.
struct Motion {
  std::uint32_t frames = 0;
  double turn = 0;     ///< degrees a frame
  double seconds = 0;  ///< a frame
};

struct Sweep {
  std::string name, doc;
  std::vector<std::string> levels;  ///< empty: all samples
  std::vector<std::uint32_t> cameras{0};
  Size size{1280, 720};
  Size errorSize{320, 180};  ///< at which pictures are compared
  std::uint32_t repetitions = 3;
  double secondsPerPoint = 1e9;  ///< a point whose timed frames took longer is not repeated
  std::uint32_t truthSamples = 512;
  Assignments settings;        ///< all points share these
  Assignments march;           ///< the converged march, second reference
  bool everyTechnique = true;  ///< a point with defaults of each technique that is built
  std::vector<Knob> knobs;
  std::vector<Size> resolutions;  ///< every technique with defaults at each
  std::vector<Single> singles;
  Motion motion;
};

/// Reads a sweep. Errors name `source` and the key; unknown keys are answered with the nearest.
Result<Sweep> readSweep(const std::string& text, const std::string& source);

/// Names of the sweeps beside the program (sweeps/*.json), sorted.
std::vector<std::string> sweepNames();
/// A name of these, or a path ending in .json.
Result<Sweep> findSweep(const std::string& nameOrPath);

}  // namespace tyndall::bench
