#include "render/frame_builder.hpp"

#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "base/log.hpp"
#include "gpu/compile_ahead.hpp"
#include "pipeline_library.hpp"
#include "stand_in.hpp"

namespace tyndall::render {
namespace {

struct Job {
  std::uint64_t number = 0;
  StandIn level;
  scene::CameraView camera;
  std::vector<scene::LightView> lights;
  std::uint32_t width = 1, height = 1;
  FrameSettings settings;
  PipelineLibrary::Names known;
};

}  // namespace

struct FrameBuilder::State {
  State(gpu::Device& d, Renderer& r, std::filesystem::path folder)
      : device(d), renderer(r), shaders(std::move(folder)) {}
  void work();
  Result<PipelineLibrary::Made> run(const Job& job, std::unique_ptr<gpu::Device>& own);

  gpu::Device& device;
  Renderer& renderer;
  std::filesystem::path shaders;

  std::thread thread;
  mutable std::mutex mutex;
  std::condition_variable wake;
  bool ending = false;
  std::optional<Job> next;
  std::uint64_t started = 0, finished = 0, wanted = 0;  ///< numbers of jobs; wanted: 0 for none
  std::vector<PipelineLibrary::Made> unwanted;          ///< for the owner's thread to destroy
  PipelineLibrary::Made made;
};

FrameBuilder::FrameBuilder(gpu::Device& device, Renderer& renderer, const std::filesystem::path& shaderFolder)
    : state_(std::make_unique<State>(device, renderer, shaderFolder)) {}

FrameBuilder::~FrameBuilder() {
  if (!state_->thread.joinable()) return;
  {
    const std::lock_guard lock(state_->mutex);
    state_->ending = true;
  }
  state_->wake.notify_one();
  state_->thread.join();
}

void FrameBuilder::start(const Renderer::Input& frame, const FrameSettings& settings) {
  Job job;
  job.level = standInFor(frame);
  job.camera = frame.camera;
  job.lights = frame.lights;
  job.width = smallSide(frame.width), job.height = smallSide(frame.height);
  job.settings = settings;
  job.settings.shadowResolution =
      settings.shadowResolution > 1 ? smallSide(settings.shadowResolution) + 14 : 1;  // 16 or 17: with mips
  job.settings.debugView.clear();
  job.settings.offered.clear();
  job.settings.reuseShadows = false;
  job.known = state_->renderer.pipelines().names();
  cancel();
  {
    const std::lock_guard lock(state_->mutex);
    job.number = state_->wanted = ++state_->started;
    state_->next = std::move(job);
  }
  if (!state_->thread.joinable()) state_->thread = std::thread([state = state_.get()] { state->work(); });
  state_->wake.notify_one();
}

void FrameBuilder::cancel() {
  std::vector<PipelineLibrary::Made> old;  // destroyed here, by the owner's thread
  PipelineLibrary::Made made;
  const std::lock_guard lock(state_->mutex);
  state_->wanted = 0;
  state_->next.reset();
  std::swap(old, state_->unwanted);
  std::swap(made, state_->made);
}

bool FrameBuilder::done() const {
  const std::lock_guard lock(state_->mutex);
  return state_->wanted != 0 && state_->finished == state_->wanted;
}

void FrameBuilder::finish() {
  PipelineLibrary::Made made;
  {
    const std::lock_guard lock(state_->mutex);
    std::swap(made, state_->made);
    state_->wanted = 0;
  }
  state_->renderer.pipelines().adopt(std::move(made));
}

void FrameBuilder::State::work() {
  gpu::giveWayToFrames();
  std::unique_ptr<gpu::Device> own;
  for (;;) {
    std::optional<Job> job;
    {
      std::unique_lock lock(mutex);
      wake.wait(lock, [this] { return ending || next; });
      if (ending) return;
      std::swap(job, next);
    }
    auto result = run(*job, own);
    if (!result) log::debug("not compiled ahead: " + result.error().message);
    const std::lock_guard lock(mutex);
    finished = job->number;
    if (!result) continue;
    (wanted == job->number ? made : unwanted.emplace_back()) = result.take();
  }
}

Result<PipelineLibrary::Made> FrameBuilder::State::run(const Job& job, std::unique_ptr<gpu::Device>& own) {
  if (!own) {
    auto opened = device.createSibling();
    if (!opened) return opened.error();
    own = opened.take();
  }
  GraphMemory memory(*own);
  auto small = Renderer::create(*own, shaders);
  if (!small) return small.error();
  (void)(*small)->reloadShaders();  // of sources that were edited since the build; what is broken was told already
  if (auto set = (*small)->setScene(job.level.scene); !set) return set.error();
  auto commands = own->beginFrame();
  if (!commands) return commands.error();
  Graph graph(*own, memory);
  Renderer::Input input{job.level.scene, job.level.worldFromNode, job.camera, job.lights};
  input.width = job.width, input.height = job.height;
  input.settings = job.settings;
  const auto drawn = [&]() -> Result<void> {
    auto output = (*small)->addFrame(graph, input);
    if (!output) return output.error();
    graph.pass("keep").use(output->picture, Use::kTransferRead).keep().run([](PassContext&) {});
    if (auto compiled = graph.compile(); !compiled) return compiled;
    graph.record(*commands, nullptr);
    return {};
  }();
  const Result<void> ended = own->endFrame();
  if (!drawn) return drawn.error();
  if (!ended) return ended.error();
  if (auto waited = own->waitIdle(); !waited) return waited.error();
  auto result = (*small)->pipelines().makeFor(device, job.known);
  gpu::awaitDriverCache();
  return result;
}

}  // namespace tyndall::render
