#include "app/session.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/assert.hpp"
#include "base/file.hpp"
#include "image/image_io.hpp"

namespace tyndall::app {

Result<std::unique_ptr<Session>> Session::open(std::unique_ptr<Catalogue> catalogue,
                                               const gpu::DeviceOptions& options) {
  auto session = std::unique_ptr<Session>(new Session);
  session->catalogue_ = std::move(catalogue);
  auto device = gpu::Device::create(options);
  if (!device) return device.error();
  session->device_ = device.take();
  session->memory_ = std::make_unique<render::GraphMemory>(*session->device_);
  auto renderer = render::Renderer::create(*session->device_, executableFolder() / "shaders");
  if (!renderer) return renderer.error();
  session->renderer_ = renderer.take();
  session->frameBuilder_ =
      std::make_unique<render::FrameBuilder>(*session->device_, *session->renderer_, executableFolder() / "shaders");
  auto effect = host::PluginEffect::create(*session->device_, session->catalogue_->effectPlugin(), session->table());
  if (!effect) return effect.error();
  session->effect_ = effect.take();
  return session;
}

Session::~Session() {
  // Nothing can be reported from here; what waits for the GPU is destroyed with the device in any case.
  if (device_) (void)device_->waitIdle();
}

Result<void> Session::setLevel(Level level) {
  level_.reset();
  if (auto finished = finishFrames(); !finished) return finished;
  if (auto uploaded = renderer_->setScene(level.scene); !uploaded)
    return Error{level.path.string() + ": " + uploaded.error().message, uploaded.error().kind};
  level_ = std::move(level);
  frameBuilder_->cancel();
  drawn_.reset(), coming_.reset();
  metered_.reset();
  momentsForeseen_ = false;
  ++levelsSet_;
  cut_ = true;
  return {};
}

render::FrameSettings Session::asked(const FrameRequest& request) const {
  const params::Table& values = catalogue_->table();
  const auto text = [&](const char* id) { return params::toText(*values.find(id), values.value(id)); };
  render::FrameSettings settings;
  const ExposureSource source = exposureSource();
  settings.exposure = static_cast<float>(values.value("view.exposure"));
  if (source == ExposureSource::kLevel) settings.exposure *= *level_->scene.exposure;
  settings.autoExposure = source == ExposureSource::kAutomatic;
  settings.meter = request.meter;
  settings.adaptSeconds = request.reset || cut_ ? -1 : request.adaptSeconds;
  settings.shownExposure = exposureFactor();
  settings.shadowResolution = static_cast<std::uint32_t>(values.value("shadows.resolution"));
  settings.skyStrength = static_cast<float>(values.value("sky.strength"));
  settings.reuseShadows = values.value("shadows.reuse") != 0;
  settings.shadowMode = text("shadows.mode") == "moments" ? render::ShadowMode::kMoments : render::ShadowMode::kPcf;
  settings.shadowPrecision = text("shadows.precision") == "128" ? 128 : 64;
  settings.debugView = request.debugView;
  settings.offered = request.views;
  return settings;
}

Session::ExposureSource Session::exposureSource() const {
  const params::Table& values = catalogue_->table();
  const bool hint = level_ && level_->scene.exposure;
  if (values.isAssigned("view.auto_exposure") || !hint) {
    if (values.value("view.auto_exposure") != 0) return ExposureSource::kAutomatic;
  }
  return hint ? ExposureSource::kLevel : ExposureSource::kFixed;
}

float Session::exposureFactor() const {
  const auto own = static_cast<float>(catalogue_->table().value("view.exposure"));
  switch (exposureSource()) {
    case ExposureSource::kAutomatic: return own * (metered_ ? metered_->factor : 1);
    case ExposureSource::kLevel: return own * *level_->scene.exposure;
    case ExposureSource::kFixed: break;
  }
  return own;
}

bool Session::exposureMoving() const {
  constexpr float kSeen = 0.01f;  // stops; a step of an 8-bit picture is some 0.03
  return metered_ && exposureSource() == ExposureSource::kAutomatic &&
         std::abs(std::log2(metered_->target / metered_->factor)) > kSeen;
}

namespace {

/// Whether frames with both settings are drawn by the same pipelines and the same code of theirs (which llvmpipe makes
/// for sides that are powers of two, or are not).
bool sameCode(const render::FrameSettings& a, const render::FrameSettings& b) {
  return a.shadowMode == b.shadowMode && a.shadowPrecision == b.shadowPrecision &&
         std::has_single_bit(a.shadowResolution) == std::has_single_bit(b.shadowResolution);
}

}  // namespace

render::FrameSettings Session::inEffect(const render::FrameSettings& asked, const render::Renderer::Input& frame) {
  if (!inBackground_ || !drawn_ || sameCode(asked, *drawn_)) {
    if (coming_) frameBuilder_->cancel(), coming_.reset();
    drawn_ = asked;
    // The effect may be about to read moment maps that surfaces do not.
    if (inBackground_ && !momentsForeseen_ && effect_->readsShadowMoments()) {
      momentsForeseen_ = true;
      render::FrameSettings moments = asked;
      moments.shadowMode = render::ShadowMode::kMoments;
      frameBuilder_->start(frame, moments);
    }
    if (frameBuilder_->done()) frameBuilder_->finish();
    return asked;
  }
  if (!coming_ || !sameCode(*coming_, asked)) {
    coming_ = asked;
    momentsForeseen_ = false;  // if that is what was being built
    frameBuilder_->start(frame, asked);
  }
  if (frameBuilder_->done()) {
    frameBuilder_->finish();
    coming_.reset();
    drawn_ = asked;
    return asked;
  }
  render::FrameSettings before = asked;
  before.shadowMode = drawn_->shadowMode;
  before.shadowPrecision = drawn_->shadowPrecision;
  before.shadowResolution = drawn_->shadowResolution;
  return before;
}

Session::Background Session::background() const {
  const Background effect = effect_->background();
  if (!coming_ || effect == Background::kReady) return effect;
  return frameBuilder_->done() ? Background::kReady : Background::kBuilding;
}

Result<render::FrameOutput> Session::buildFrame(render::Graph& graph, const FrameRequest& request) {
  TY_ASSERT(level_, "buildFrame() needs setLevel()");
  TY_ASSERT(!commands_, "buildFrame() twice without submitFrame()");
  auto commands = device_->beginFrame();
  if (!commands) return commands.error();
  // The slot's last frame is finished: beginFrame() waited for it.
  takeTimes(currentSlot());

  const std::pair size{request.width, request.height};
  render::Renderer::Input input{level_->scene, level_->worldFromNode(request.seconds), request.camera,
                                level_->lights(request.seconds)};
  input.width = request.width;
  input.height = request.height;
  input.seconds = request.seconds;
  input.frameIndex = frameIndex_++;
  input.reset = request.reset || cut_ || size != lastSize_;
  input.settings = inEffect(asked(request), input);
  input.effect = effect_.get();
  auto output = renderer_->addFrame(graph, input);
  if (!output) {
    (void)device_->endFrame();  // the reason of the failure is told, not that of an empty submission
    effect_->frameDropped(output.error());
    return output;
  }
  commands_ = *commands;
  currentSlot().metered = output->metered;
  lastSize_ = size;
  cut_ = false;
  return output;
}

Result<void> Session::submitFrame(render::Graph& graph, const gpu::FrameSignals& signals) {
  TY_ASSERT(commands_, "submitFrame() needs buildFrame()");
  const VkCommandBuffer commands = std::exchange(commands_, VK_NULL_HANDLE);
  Slot& slot = currentSlot();
  auto recorded = [&]() -> Result<void> {
    if (auto compiled = graph.compile(); !compiled) return compiled;
    statistics_ = graph.statistics();
    transients_ = graph.transients();
    // A capacity of 0 is none at all, which a graph without passes could not be recorded with.
    if (slot.timestamps.capacity() == 0 || slot.timestamps.capacity() < statistics_.passesRun) {
      auto made = gpu::Timestamps::create(*device_, statistics_.passesRun + 16);
      if (!made) return made.error();
      slot.timestamps = made.take();
    }
    graph.record(commands, &slot.timestamps);
    return {};
  }();
  if (!recorded) {
    (void)device_->endFrame();
    effect_->frameDropped(recorded.error());
    return recorded;
  }
  slot.passes = graph.passes();
  if (auto submitted = device_->endFrame(signals); !submitted) {
    effect_->frameDropped(submitted.error());
    return submitted;
  }
  effect_->frameSubmitted();
  slot.waiting = true;
  return {};
}

void Session::takeTimes(Slot& slot) {
  if (!slot.waiting) return;
  slot.waiting = false;
  const std::vector<double> spans = slot.timestamps.milliseconds();
  TY_ASSERT(spans.size() == slot.passes.size(),
            std::to_string(spans.size()) + " times for " + std::to_string(slot.passes.size()) + " passes");
  for (std::size_t i = 0; i < spans.size(); ++i) slot.passes[i].milliseconds = spans[i];
  lastTimes_ = slot.passes;
  if (slot.metered) metered_ = renderer_->metered(*std::exchange(slot.metered, std::nullopt));
  ++finished_;
  effect_->frameFinished(lastTimes_);
}

Result<void> Session::finishFrames() {
  if (auto waited = device_->waitIdle(); !waited) return waited;
  // The slot that would be used next holds the older frame.
  const std::size_t next = device_->submittedFrames() % slots_.size();
  for (std::size_t i = 0; i < slots_.size(); ++i) takeTimes(slots_[(next + i) % slots_.size()]);
  return {};
}

std::vector<render::DebugViewInfo> Session::debugViews() const {
  std::vector<render::DebugViewInfo> views = render::Renderer::debugViews();
  for (const host::PluginDebugView& view : effect_->debugViews()) views.push_back({view.name, view.doc, view.role});
  return views;
}

Result<void> Session::reloadPlugin() {
  if (auto finished = finishFrames(); !finished) return finished;
  auto plugin = host::Plugin::load(catalogue_->effectPlugin().path());
  if (!plugin) return plugin.error();
  // The new effect is made first, with a table of its own, so that a failure leaves the running one alone.
  params::Table trial;
  if (auto added = trial.add((*plugin)->parameters()); !added) return added;
  if (auto effect = host::PluginEffect::create(*device_, **plugin, trial); !effect) return effect.error();
  effect_.reset();
  auto replaced = catalogue_->replaceEffectPlugin(plugin.take());
  auto effect = host::PluginEffect::create(*device_, catalogue_->effectPlugin(), table());
  if (!effect) return effect.error();
  effect_ = effect.take();
  effect_->buildInBackground(inBackground_);
  cut_ = true;
  return replaced;
}

void Session::buildInBackground(bool on) {
  inBackground_ = on;
  if (!on) frameBuilder_->cancel(), coming_.reset();
  effect_->buildInBackground(on);
}

std::vector<std::string> Session::reloadShaders() {
  frameBuilder_->cancel();  // what it makes may be of the shaders before
  coming_.reset();
  std::vector<std::string> lines = renderer_->reloadShaders();
  for (std::string& line : effect_->reloadShaders()) lines.push_back(std::move(line));
  return lines;
}

std::uint32_t Session::maxSide() const {
  const VkPhysicalDeviceLimits& limits = device_->info().limits;
  return std::min(
      {limits.maxImageDimension2D, limits.maxFramebufferWidth, limits.maxFramebufferHeight, image::kMaxSide});
}

}  // namespace tyndall::app
