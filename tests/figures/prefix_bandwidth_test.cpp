// What the prefix pass moves, against what the device can copy: bytes read and written over time, for each scheme, as a
// share of the rate of a plain copy in the same run (docs/results/prefiltered.md).
#include <algorithm>

#include <gtest/gtest.h>

#include "bench/stand.hpp"
#include "laboratory.hpp"
#include "table.hpp"

namespace tyndall::figures {
namespace {

constexpr int kFrames = 9;
constexpr double kTexels = 1024.0 * 1024;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// What one prefix pass has to move, bytes: every rectified depth once for each group of functions, every result once.
struct Case {
  const char* name;
  Settings settings;
  double depthBytes, groups, prefixBytes;  ///< a texel
};

TEST(PrefixBandwidth, Table) {
  Laboratory lab("hall", 0, 320, 180);
  Report report("prefix_bandwidth");
  const auto copied = bench::copyRate(lab.session());
  ASSERT_TRUE(copied) << copied.error().message;
  const double rate = *copied;
  report.line("Device: " + lab.device() + ". Copy: " + figure(rate / 1e9) +
              " GB/s (read and written). Map 1024², K = 3, bounds.");
  report.line("");
  report.head({"technique", "scheme", "MB", "ms", "GB/s", "share of the copy"});
  const Case cases[] = {
      {"moments4, 64 bit", {"volumetrics.technique=moments4", "volumetrics.precision=compact"}, 2, 1, 3 * 8 + 4},
      {"moments6, 60 bit", {"volumetrics.technique=moments6", "volumetrics.precision=compact"}, 2, 1, 3 * 8 + 4},
      {"moments6, 96 bit", {"volumetrics.technique=moments6"}, 2, 1, 3 * 12 + 4},
      {"moments6, 192 bit", {"volumetrics.technique=moments6", "volumetrics.precision=full"}, 4, 1, 3 * 24 + 4},
      {"fourier 32, 8 a thread", {"volumetrics.technique=fourier", "volumetrics.bases_per_thread=8"}, 2, 4, 3 * 32 + 4},
      {"fourier 32, 32 a thread",
       {"volumetrics.technique=fourier", "volumetrics.bases_per_thread=32"},
       2,
       1,
       3 * 32 + 4}};
  for (const Case& c : cases)
    for (const char* scheme : {"row", "block", "scan"}) {
      lab.shoot(c.settings + Settings{"volumetrics.prefix_scheme=" + std::string(scheme)});
      std::vector<double> times;
      for (const Shot& shot : lab.again(kFrames)) times.push_back(shot.pluginMs("prefix"));
      const double bytes = kTexels * (c.depthBytes * c.groups + c.prefixBytes), ms = median(times);
      ASSERT_GT(ms, 0);
      report.row({c.name, scheme, figure(bytes / 1e6), figure(ms), figure(bytes / ms / 1e6),
                  figure(1e3 * bytes / ms / rate, 2)});
      // Nothing beats the device's own copy by more than noise; a share above means that bytes are counted that nobody
      // moves.
      EXPECT_LT(1e3 * bytes / ms / rate, 1.5);
    }
}

}  // namespace
}  // namespace tyndall::figures
