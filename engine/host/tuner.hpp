// Chooses among variants that differ in speed only, by timing each for a few frames; remembers the choice per device.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "host/layout.hpp"

namespace tyndall::host {

/// What is remembered between runs of the program: {"key": variant} as JSON. A damaged or missing file is an empty one.
class TunerStore {
 public:
  explicit TunerStore(std::filesystem::path file);  ///< an empty path: nothing is remembered
  const double* find(const std::string& key) const;
  /// Reads the file again before writing it, so that two programs lose little of each other's.
  void remember(const std::string& key, double variant);

 private:
  std::filesystem::path file_;
  std::map<std::string, double> known_;
};

class Tuner {
 public:
  /// 1 frame to warm up (shaders compile at their first use) and 3 that count.
  static constexpr std::size_t kFrames = 4;
  /// A variant whose first two frames that count take so many times as long as another's median is timed no further.
  static constexpr double kClearly = 1.5;

  explicit Tuner(TunerStore store) : store_(std::move(store)) {}

  /// Where a tunable stands. `variants` as in the layout; the same key always comes with the same ones, or starts anew.
  struct Choice {
    std::size_t variant = 0;
    bool settled = false;
  };
  Choice current(const std::string& key, const std::vector<double>& variants);
  /// The variant that was found fastest, in this program or an earlier one; null if it was not measured.
  const double* remembered(const std::string& key) const { return store_.find(key); }
  /// The time of one frame that ran with `variant`; ignored unless it is the one being timed. `lights`: those that the
  /// timed passes ran for; variants are compared on the same ones, so that a frame with others starts the timing anew.
  void add(const std::string& key, std::size_t variant, double milliseconds,
           const std::set<std::uint32_t>& lights = {});

 private:
  struct Entry {
    std::vector<double> variants;
    std::vector<std::vector<double>> times;
    Choice choice;
    std::set<std::uint32_t> lights;
  };
  TunerStore store_;
  std::map<std::string, Entry> entries_;
};

/// Names what a choice holds for: the plugin's build, the device, the parameter, the timed passes' shaders with their
/// constants (those of the variant that stands for "automatic"), and the formats and sizes of their images - the power
/// of two of each timed pass's groups, so that a window dragged wider does not start the timing anew at every pixel.
std::string tunableKey(const std::string& plugin, const std::string& device, const std::string& parameter,
                       const LayoutTunable& tunable, const Layout& layout);

}  // namespace tyndall::host
