// A second engine on a thread of its own, for what would take too long between two frames of the window: debug views,
// references, the times of techniques. One job at a time, in the order asked, so that nothing that is timed runs beside
// something else.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "app/session.hpp"
#include "app/view_readback.hpp"
#include "image/image_io.hpp"

namespace tyndall::editor {

/// Everything that a picture depends on, by value: what it was asked for stays what it is made with.
struct Shot {
  std::shared_ptr<const app::Level> level;
  scene::CameraView camera;
  double seconds = 0;
  std::uint32_t width = 1, height = 1;
  std::map<std::string, double> values;  ///< of every parameter
  bool operator==(const Shot& other) const;
  /// Whether the same light is scattered: level, camera, time, size and medium are equal, whatever the technique.
  bool sameTruth(const Shot& other) const;
  Shot scaledTo(std::uint32_t newWidth, std::uint32_t newHeight) const;
};

/// A job's state, shared by both threads.
struct Job {
  std::string label;
  std::atomic<float> progress{0};      ///< 0 to 1
  std::atomic<bool> cancelled{false};  ///< asked for; its result is then dropped
  std::atomic<bool> finished{false};
  void cancel() { cancelled = true; }
};
using JobPointer = std::shared_ptr<Job>;
inline bool running(const JobPointer& job) { return job && !job->finished && !job->cancelled; }

struct RenderTask {
  Shot shot;
  std::vector<app::ViewRequest> views;
  bool reference = false;     ///< the view that the effect offers for judging instead of `views`
  std::uint32_t repeats = 0;  ///< above 0: the effect is warmed up and timed over so many frames
};
struct RenderResult {
  image::FloatImage scatter;  ///< RGBA; of a reference, its radiance
  std::vector<app::ViewPicture> views;
  double effectMs = 0;  ///< median over the repeats of everything that the effect's plugin owns
};
struct TruthTask {
  Shot shot;
  std::uint32_t samples = 256;
};

class Laboratory {
 public:
  struct Options {
    gpu::DeviceOptions device;
    std::filesystem::path pluginFolder;
    std::function<void()> wake;  ///< called from the thread when a job has finished
  };
  /// Returns when the second engine stands, so that nothing else uses Vulkan while it is loaded.
  static Result<std::unique_ptr<Laboratory>> open(const Options& options);
  ~Laboratory();  ///< cancels what is left and waits

  /// `done` is called from poll(), unless the job was cancelled before.
  JobPointer render(std::string label, RenderTask task, std::function<void(Result<RenderResult>)> done);
  JobPointer truth(std::string label, TruthTask task, std::function<void(Result<image::FloatImage>)> done);

  /// Calls what waits for finished jobs. To be called by the window's thread.
  void poll();
  bool busy() const { return unfinished_ > 0; }
  std::uint32_t validationMessages() const { return messages_; }

 private:
  struct Work {
    JobPointer job;
    std::function<std::function<void()>(Job&)> run;  ///< on the thread; returns what poll() calls
  };
  struct Queue {
    std::deque<Work> waiting;
    JobPointer current;
    std::thread thread;
  };
  explicit Laboratory(const Options& options) : options_(options) {}
  void live(const std::function<void(Result<void>)>& opened);
  void serve(Queue& queue);
  JobPointer add(Queue& queue, std::string label, std::function<std::function<void()>(Job&)> run);
  Result<RenderResult> renderNow(const RenderTask& task, Job& job);
  Result<void> follow(const Shot& shot);

  Options options_;
  std::unique_ptr<app::Session> session_;  ///< lives and dies on the thread of the frames
  std::shared_ptr<const app::Level> level_;
  std::atomic<int> unfinished_{0};
  std::atomic<std::uint32_t> messages_{0};
  std::mutex mutex_;  ///< guards all below but the threads themselves
  std::condition_variable changed_;
  std::vector<std::pair<JobPointer, std::function<void()>>> done_;
  bool closing_ = false;
  Queue frames_, rays_;
};

}  // namespace tyndall::editor
