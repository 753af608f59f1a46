// What `tyndall bench` is asked for. The benchmark itself is a room above this one (engine/bench), which defines
// runBench.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/result.hpp"

namespace tyndall::app {

struct BenchOptions {
  std::vector<std::string> levels;  ///< empty: the sweep's own, else all samples
  std::string sweep = "quick";      ///< a sweep that comes with the program, or a path to a .json file
  std::optional<std::pair<std::uint32_t, std::uint32_t>> size;
  std::optional<std::uint32_t> repetitions;
  std::filesystem::path out;  ///< folder; empty: out/bench/<sweep>
  std::string device;
  std::filesystem::path pluginFolder;
  bool fresh = false;                          ///< measures everything again
  std::vector<std::filesystem::path> compare;  ///< two results.json to compare, instead of measuring
  std::filesystem::path report;                ///< a results.json to make the report of again, instead of measuring
};

/// Measures a sweep, or compares two results. Writes results.json, results.csv and report.html into the folder. Errors:
/// an unknown sweep or level and a wrong sweep file are bad calls; a device that cannot be opened, a file that cannot
/// be written, an interruption fail.
Result<void> runBench(const BenchOptions& options);

struct TuneOptions {
  std::string level;
  std::vector<std::uint32_t> cameras;  ///< empty: all of the level's but those held out
  std::vector<std::uint32_t>
      holdOut;  ///< views that the search does not see; the evidence says what was found has there
  std::uint32_t turned =
      0;  ///< further views at each camera that is tuned on: turned by 20 degrees to both sides in turn, by 40, ...
  bool lightViews = true;  ///< a camera that sees no light on these views gets one more, turned to a light
  double margin =
      0.1;  ///< part of the bound that the search keeps clear of, so that views it has not seen meet it too; 0...0.9
  std::pair<std::uint32_t, std::uint32_t> size{1280, 720};
  std::optional<double> budgetMs, maxError;  ///< one of the two
  std::filesystem::path
      candidates;             ///< what to try, a file of the form of a sweep; empty: tune/*.json beside the program
  std::filesystem::path out;  ///< empty: the preset goes to stdout
  std::string device;
  std::filesystem::path pluginFolder;
};

/// Searches the cheapest settings under a bound on the error, or the least error within a time, and writes them as a
/// preset with the evidence. Fails if no setting meets the bound; the message names the best that was found.
Result<void> runTune(const TuneOptions& options);

}  // namespace tyndall::app
