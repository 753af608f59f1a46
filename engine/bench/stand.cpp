#include "bench/stand.hpp"

#include <algorithm>

namespace tyndall::bench {
namespace {

// The host gives each variant of an automatic parameter this many frames; one that stood for as long has been decided.
// More frames than the longest list of variants needs are not spent.
constexpr int kFramesPerVariant = 4, kMostWarmUp = 64;

}  // namespace

bool isShadowPass(const render::PassTime& pass) { return pass.owner == "engine" && pass.name.starts_with("shadow"); }

Result<std::unique_ptr<Stand>> Stand::open(std::unique_ptr<app::Catalogue> catalogue, const std::string& device) {
  gpu::DeviceOptions options;
  options.name = device;
  auto session = app::Session::open(std::move(catalogue), options);
  if (!session) return session.error();
  std::unique_ptr<Stand> stand(new Stand);
  stand->session_ = session.take();
  return stand;
}

Result<void> Stand::setLevel(app::Level level) { return session_->setLevel(std::move(level)); }

Result<void> Stand::frame(const app::FrameRequest& request, bool scatter) {
  render::Graph graph(session_->device(), session_->graphMemory());
  auto output = session_->buildFrame(graph, request);
  if (!output) return output.error();
  // The picture is always read: the graph drops passes that nobody needs, and the times are of the whole frame.
  if (auto added = readback_.addPasses(*session_, graph, *output, request, {true, scatter, false}); !added)
    return added;
  if (auto submitted = session_->submitFrame(graph); !submitted) return submitted;
  if (auto finished = session_->finishFrames(); !finished) return finished;
  if (session_->effect().failure()) return *session_->effect().failure();
  return {};
}

Result<void> Stand::frames(const Assignments& settings, const scene::CameraView& camera, Size size, double seconds,
                           int count, bool scatter, bool keepShadows) {
  if (auto applied = applySettings(session_->table(), settings); !applied) return applied;
  if (auto kept = session_->table().setText("shadows.reuse", keepShadows ? "true" : "false"); !kept) return kept;
  app::FrameRequest request;
  request.width = size.first, request.height = size.second, request.camera = camera, request.seconds = seconds;
  for (int i = 0; i < count; ++i)
    if (auto done = frame(request, scatter); !done) return done;
  passes_ = session_->lastPassTimes();
  std::erase_if(passes_, [](const render::PassTime& pass) { return pass.owner == app::Readback::kOwner; });
  return {};
}

Result<void> Stand::render(const Assignments& settings, const scene::CameraView& camera, Size size, double seconds,
                           int frameCount, bool scatter) {
  return frames(settings, camera, size, seconds, frameCount, scatter, true);
}

Result<double> Stand::shadowTime(const Assignments& settings, const scene::CameraView& camera, Size size,
                                 double seconds) {
  if (auto done = frames(settings, camera, size, seconds, 2, false, false); !done) return done.error();
  double milliseconds = 0;
  for (const render::PassTime& pass : passes_)
    if (isShadowPass(pass)) milliseconds += pass.milliseconds;
  return milliseconds;
}

Result<void> Stand::warmUp(const Assignments& settings, const scene::CameraView& camera, Size size, double seconds) {
  std::vector<std::pair<std::string, std::string>> resolved;
  int unchanged = 0;
  for (int i = 0; i < kMostWarmUp; ++i) {
    if (auto done = render(settings, camera, size, seconds, 1, false); !done) return done;
    const auto now = session_->effect().resolved();
    unchanged = now == resolved ? unchanged + 1 : 0;
    resolved = now;
    if (i >= 1 && unchanged >= (resolved.empty() ? 1 : kFramesPerVariant)) break;
  }
  return {};
}

Result<double> copyRate(app::Session& session) {
  constexpr std::uint64_t kBytes = 64ull << 20;
  const auto make = [&](const char* name) {
    return session.device().createBuffer(
        {name, kBytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT});
  };
  auto from = make("copy rate, from"), to = make("copy rate, to");
  if (!from) return from.error();
  if (!to) return to.error();
  std::vector<double> times;
  for (int i = 0; i < 7; ++i) {
    auto commands = session.device().beginFrame();
    if (!commands) return commands.error();
    render::Graph graph(session.device(), session.graphMemory());
    const render::BufferRef a = graph.import(*from), b = graph.import(*to);
    graph.pass("copy")
        .use(a, render::Use::kTransferRead)
        .use(b, render::Use::kTransferWrite)
        .keep()
        .run([a, b](render::PassContext& pass) {
          const VkBufferCopy region{0, 0, kBytes};
          vkCmdCopyBuffer(pass.commands(), pass.buffer(a), pass.buffer(b), 1, &region);
        });
    if (auto compiled = graph.compile(); !compiled) return compiled.error();
    auto stamps = gpu::Timestamps::create(session.device(), 4);
    if (!stamps) return stamps.error();
    graph.record(*commands, &*stamps);
    if (auto ended = session.device().endFrame(); !ended) return ended.error();
    if (auto idle = session.device().waitIdle(); !idle) return idle.error();
    times.push_back(stamps->milliseconds().at(0));
  }
  return 2e3 * kBytes / spreadOf(times).median;
}

}  // namespace tyndall::bench
