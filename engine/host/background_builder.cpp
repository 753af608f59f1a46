#include "background_builder.hpp"

#include "base/log.hpp"
#include "gpu/compile_ahead.hpp"

namespace tyndall::host {

BackgroundBuilder::~BackgroundBuilder() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
    ++started_;
  }
  wake_.notify_one();
  thread_.join();
}

void BackgroundBuilder::start(std::vector<BuildStep> steps) {
  if (!thread_.joinable() && steps.empty()) return;
  std::vector<std::pair<std::string, gpu::Pipeline>> unwanted;
  {
    const std::lock_guard lock(mutex_);
    unwanted = std::move(made_);
    made_.clear();
    next_ = {++started_, std::move(steps)};
  }
  if (!thread_.joinable()) thread_ = std::thread([this] { work(); });
  wake_.notify_one();
}

Result<std::map<std::string, PipelinePtr>> BackgroundBuilder::take() {
  const std::lock_guard lock(mutex_);
  std::map<std::string, PipelinePtr> pipelines;
  for (auto& [key, pipeline] : made_) pipelines[key] = std::make_shared<const gpu::Pipeline>(std::move(pipeline));
  made_.clear();
  if (error_) return *error_;
  return pipelines;
}

void BackgroundBuilder::work() {
  gpu::giveWayToFrames();
  std::unique_ptr<gpu::Device> own;
  for (;;) {
    Job job;
    {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [this] { return ending_ || next_.number != finished_; });
      if (ending_) return;
      job = std::move(next_);
      next_.number = job.number;
    }
    auto done = run(job, own);
    const std::lock_guard lock(mutex_);
    error_.reset();
    if (!done) error_ = done.error();
    finished_ = job.number;
  }
}

Result<void> BackgroundBuilder::run(const Job& job, std::unique_ptr<gpu::Device>& own) {
  bool warmed = false;
  for (const BuildStep& step : job.steps) {
    if (started_ != job.number) return {};  // a newer one waits
    if (step.make) {
      auto made = makePipeline(device_, step.plan);
      if (!made) return made.error();
      const std::lock_guard lock(mutex_);
      made_.emplace_back(step.plan.key, made.take());
    }
    if (!step.warmUps.empty()) warmUp(step, own), warmed = true;
  }
  if (warmed) gpu::awaitDriverCache();
  return {};
}

/// What fails here is only slower: the first frame then compiles.
void BackgroundBuilder::warmUp(const BuildStep& step, std::unique_ptr<gpu::Device>& own) {
  const auto tried = [&]() -> Result<void> {
    if (!own) {
      auto opened = device_.createSibling();
      if (!opened) return opened.error();
      own = opened.take();
    }
    auto pipeline = makePipeline(*own, step.plan);
    if (!pipeline) return pipeline.error();
    for (const Scratch& scratch : step.warmUps) {
      auto made = WarmUp::create(*own, scratch);
      if (!made) return made.error();
      const auto record = [&](VkCommandBuffer commands) { (*made)->record(commands, *pipeline); };
      if (auto done = own->submitAndWait(record); !done) return done;
    }
    return {};
  }();
  if (!tried) log::debug("not compiled ahead: " + tried.error().message);
}

}  // namespace tyndall::host
