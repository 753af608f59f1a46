// One thread that makes pipelines beside the frames.
#pragma once

#include <atomic>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "pipelines.hpp"
#include "warm_up.hpp"

namespace tyndall::host {

/// A pipeline to make, to have its code compiled by the driver, or both.
struct BuildStep {
  PipelinePlan plan;
  bool make = true;
  std::vector<Scratch> warmUps;  ///< only where the driver compiles late
};

/// Called by the thread that owns the device. The builder's thread touches the device only to make pipelines; where the
/// driver compiles at the first dispatch it has a device of its own for that, whose code reaches the first one through
/// the driver's cache on disk: on the one queue that such a driver has, a dispatch that compiles would hold up every
/// frame behind it.
class BackgroundBuilder {
 public:
  explicit BackgroundBuilder(gpu::Device& device) : device_(device) {}
  ~BackgroundBuilder();  ///< waits for the pipeline that is being made
  BackgroundBuilder(const BackgroundBuilder&) = delete;
  BackgroundBuilder& operator=(const BackgroundBuilder&) = delete;

  /// Begins these steps in place of those before: of them, only the pipeline that is being made is finished.
  void start(std::vector<BuildStep> steps);
  /// Forgets the steps that were started.
  void cancel() { start({}); }
  bool done() const { return finished_ == started_; }
  /// What the last start() gave, once done(): the pipelines by key, or the first error.
  Result<std::map<std::string, PipelinePtr>> take();

 private:
  struct Job {
    std::uint64_t number = 0;
    std::vector<BuildStep> steps;
  };
  void work();
  Result<void> run(const Job& job, std::unique_ptr<gpu::Device>& own);
  void warmUp(const BuildStep& step, std::unique_ptr<gpu::Device>& own);

  gpu::Device& device_;
  std::thread thread_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool ending_ = false;
  Job next_;
  std::atomic<std::uint64_t> started_{0}, finished_{0};  ///< numbers of jobs
  /// Of all jobs since the last take(): those that nobody wants any more are destroyed by the owner's thread, not by
  /// this one.
  std::vector<std::pair<std::string, gpu::Pipeline>> made_;
  std::optional<Error> error_;  ///< of the job finished last
};

}  // namespace tyndall::host
