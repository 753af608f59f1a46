// How long frames take around a change of one parameter: the wall clock of a whole frame, from its declaration until
// the device has finished it, as somebody at the editor's window waits for it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/readback.hpp"
#include "app/session.hpp"

namespace tyndall::hitch {

using Settings = std::vector<std::string>;  ///< "id=value"

struct Change {
  std::string what;         ///< "volumetrics.basis_count 16 -> 32"
  double before = 0;        ///< ms, median of frames with the old value
  double after = 0;         ///< the same with the new one
  double worst = 0;         ///< slowest frame from the change until the new value has been drawn three times
  std::string slowestPass;  ///< in that frame, with its ms
  int frames = 0;           ///< that went on with the old value
  double seconds = 0;       ///< until the new value was drawn
  double ratio() const { return worst / std::max(before, after); }

  // The same in processor time of the program, which other programs hardly change; of frames once everything was built.
  double cpuBefore = 0, cpuAfter = 0, cpuWorst = 0;  ///< ms
  double cpuRatio() const { return cpuWorst / std::max(cpuBefore, cpuAfter); }
  /// Entries of llvmpipe's cache that frames with the new value added: code that nobody had compiled ahead.
  int late = 0;
};

/// An engine with caches of its own that are empty at first: whatever is needed has to be compiled.
class Bench {
 public:
  /// `background`: as the editor; else as `tyndall render`.
  Bench(const std::string& level, std::uint32_t width, std::uint32_t height, bool background);
  ~Bench();
  /// Defaults, then small maps, then `settings`; drawn until nothing is left to build.
  void settle(const Settings& settings);
  Change change(const std::string& id, const std::string& value);
  /// Draws a frame and returns its picture.
  image::ByteImage shoot();
  app::Session& session() { return *session_; }
  /// Smallest possible maps, and nothing on automatic.
  static const Settings& small();

 private:
  struct Times {
    double wall = 0, cpu = 0;  ///< ms
  };
  Times frame();
  Times steady();
  int cacheEntries() const;
  std::filesystem::path caches_;
  app::FrameRequest request_;
  std::unique_ptr<app::Session> session_;
  app::Readback readback_;  // after the session: its buffers go before the device
};

double median(std::vector<double> values);

}  // namespace tyndall::hitch
