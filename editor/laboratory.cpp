#include "laboratory.hpp"

#include <future>

#include "truth/truth.hpp"

namespace tyndall::editor {
namespace {

bool sameCamera(const scene::CameraView& a, const scene::CameraView& b) {
  return a.worldFromView == b.worldFromView && a.camera.yfov == b.camera.yfov && a.camera.znear == b.camera.znear &&
         a.camera.zfar == b.camera.zfar;
}

Result<image::FloatImage> traced(const TruthTask& task, Job& job) {
  truth::Settings settings;
  settings.width = task.shot.width, settings.height = task.shot.height;
  settings.seconds = task.shot.seconds;
  settings.samples = task.samples;
  for (const auto& [id, target] : {std::pair{"medium.sigma_t", &settings.medium.sigma_t},
                                   {"medium.albedo", &settings.medium.albedo},
                                   {"medium.g", &settings.medium.g}}) {
    const auto value = task.shot.values.find(id);
    if (value == task.shot.values.end())
      return failed("truth: the plugin in use has no parameter " + std::string(id) +
                    "; the volumetrics plugin is needed");
    *target = value->second;
  }
  settings.progress = [&job](double share) {
    job.progress = static_cast<float>(share);
    return !job.cancelled;
  };
  const app::Level& level = *task.shot.level;
  auto picture = truth::render(level.scene, task.shot.camera, level.lights(task.shot.seconds), settings);
  if (!picture) return picture.error();
  image::FloatImage result{picture->width, picture->height, 4, {}};
  result.values.reserve(picture->scatter.size() * 4);
  for (const glm::vec4& pixel : picture->scatter)
    result.values.insert(result.values.end(), {pixel.r, pixel.g, pixel.b, pixel.a});
  return result;
}

}  // namespace

bool Shot::operator==(const Shot& other) const {
  return level == other.level && sameCamera(camera, other.camera) && seconds == other.seconds && width == other.width &&
         height == other.height && values == other.values;
}

bool Shot::sameTruth(const Shot& other) const {
  const auto medium = [](const std::map<std::string, double>& all) {
    std::map<std::string, double> part;
    for (const auto& [id, value] : all)
      if (id.starts_with("medium.")) part[id] = value;
    return part;
  };
  return level == other.level && sameCamera(camera, other.camera) && seconds == other.seconds && width == other.width &&
         height == other.height && medium(values) == medium(other.values);
}

Shot Shot::scaledTo(std::uint32_t newWidth, std::uint32_t newHeight) const {
  Shot scaled = *this;
  scaled.width = newWidth, scaled.height = newHeight;
  return scaled;
}

Result<std::unique_ptr<Laboratory>> Laboratory::open(const Options& options) {
  std::unique_ptr<Laboratory> made(new Laboratory(options));
  // A plugin's instance belongs to the thread that made it, so the whole engine is made there.
  std::promise<Result<void>> opened;
  auto standing = opened.get_future();
  Laboratory* raw = made.get();
  made->frames_.thread = std::thread(
      [&opened, raw] { raw->live([&opened](Result<void> result) { opened.set_value(std::move(result)); }); });
  if (auto result = standing.get(); !result) return result.error();
  made->rays_.thread = std::thread([raw] { raw->serve(raw->rays_); });
  return made;
}

Laboratory::~Laboratory() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
    for (Queue* queue : {&frames_, &rays_}) {
      for (const Work& work : queue->waiting) work.job->cancel();
      if (queue->current) queue->current->cancel();
    }
  }
  changed_.notify_all();
  for (Queue* queue : {&frames_, &rays_})
    if (queue->thread.joinable()) queue->thread.join();
}

void Laboratory::live(const std::function<void(Result<void>)>& opened) {
  auto catalogue = app::Catalogue::load(app::pluginFolder(options_.pluginFolder));
  if (!catalogue) return opened(catalogue.error());
  auto session = app::Session::open(catalogue.take(), options_.device);
  if (!session) return opened(session.error());
  session_ = session.take();
  opened({});
  serve(frames_);
  session_.reset();
}

void Laboratory::serve(Queue& queue) {
  for (;;) {
    Work work;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [&] { return closing_ || !queue.waiting.empty(); });
      if (closing_) return;
      work = std::move(queue.waiting.front());
      queue.waiting.pop_front();
      queue.current = work.job;
    }
    std::function<void()> report;
    if (!work.job->cancelled) report = work.run(*work.job);
    {
      const std::lock_guard lock(mutex_);
      queue.current.reset();
      done_.emplace_back(work.job, std::move(report));
    }
    if (options_.wake) options_.wake();
  }
}

JobPointer Laboratory::add(Queue& queue, std::string label, std::function<std::function<void()>(Job&)> run) {
  auto job = std::make_shared<Job>();
  job->label = std::move(label);
  ++unfinished_;
  {
    const std::lock_guard lock(mutex_);
    queue.waiting.push_back({job, std::move(run)});
  }
  changed_.notify_all();
  return job;
}

JobPointer Laboratory::render(std::string label, RenderTask task, std::function<void(Result<RenderResult>)> done) {
  return add(frames_, std::move(label),
             [this, task = std::move(task), done = std::move(done)](Job& job) -> std::function<void()> {
               auto result = std::make_shared<Result<RenderResult>>(renderNow(task, job));
               messages_ = session_->device().validationMessages();
               return [result, done] { done(std::move(*result)); };
             });
}

JobPointer Laboratory::truth(std::string label, TruthTask task, std::function<void(Result<image::FloatImage>)> done) {
  return add(rays_, std::move(label),
             [task = std::move(task), done = std::move(done)](Job& job) -> std::function<void()> {
               auto result = std::make_shared<Result<image::FloatImage>>(traced(task, job));
               return [result, done] { done(std::move(*result)); };
             });
}

void Laboratory::poll() {
  std::vector<std::pair<JobPointer, std::function<void()>>> done;
  {
    const std::lock_guard lock(mutex_);
    done.swap(done_);
  }
  for (auto& [job, report] : done) {
    --unfinished_;
    job->finished = true;
    job->progress = 1;
    if (report && !job->cancelled) report();
  }
}

}  // namespace tyndall::editor
