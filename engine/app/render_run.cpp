#include "render_run.hpp"

#include <algorithm>

#include "app/median.hpp"
#include "base/file.hpp"

namespace tyndall::app {
namespace {

// Shaders are compiled at their first use, and a second frame settles caches and the driver's memory.
constexpr std::uint32_t kWarmUpFrames = 2;
// More only while the effect is still timing variants of its tunables; this many are more than any list of them needs.
constexpr std::uint32_t kMaxWarmUpFrames = 64;
// The host gives each variant this many frames: a tunable that stood for as long has been decided.
constexpr std::uint32_t kFramesPerVariant = 4;

Result<void> oneFrame(Session& session, const FrameRequest& request, const ReadbackWants& wants, RenderRun& run) {
  render::Graph graph(session.device(), session.graphMemory());
  auto output = session.buildFrame(graph, request);
  if (!output) return output.error();
  std::vector<ViewRequest> views;
  for (const std::string& name : request.views) views.push_back({name});
  // A frame that was begun has to be submitted, also when its results cannot be read.
  auto added = run.readback.addPasses(session, graph, *output, request, wants);
  if (added && !views.empty()) added = run.views.addPasses(session, graph, *output, views);
  if (auto submitted = session.submitFrame(graph); !submitted) return submitted;
  if (auto finished = session.finishFrames(); !finished) return finished;
  return added;
}

Result<void> unknownView(const Session& session, const std::string& name) {
  std::vector<std::string> names;
  std::string list;
  for (const render::DebugViewInfo& view : session.debugViews()) {
    names.push_back(view.name);
    list += (list.empty() ? "" : ", ") + view.name;
  }
  if (std::find(names.begin(), names.end(), name) != names.end()) return {};
  const std::string near = nearestName(name, names);
  return badCall("--debug-view '" + name + "': no such view" + (near.empty() ? "" : ", did you mean '" + near + "'?") +
                 "; there are " + list);
}

}  // namespace

Result<RenderRun> renderFrames(Session& session, const RenderOptions& options, const scene::CameraView& camera) {
  FrameRequest request{options.size.first, options.size.second, camera, options.seconds, "", {}, false};
  request.meter = true;  // of the warm-up; the frames that are timed do what their settings ask for
  // The picture is always read: the graph drops passes that nobody needs, and the times are of the whole frame.
  const ReadbackWants wants{true, !options.scatter.empty(), !options.depth.empty()};
  RenderRun run;
  std::vector<std::pair<std::string, std::string>> resolved;
  std::uint32_t unchanged = 0;
  for (std::uint32_t frame = 0; frame < kMaxWarmUpFrames; ++frame) {
    if (auto done = oneFrame(session, request, wants, run); !done) return done.error();
    if (session.effect().failure()) return *session.effect().failure();
    if (frame == 0 && !options.debugView.empty()) {
      // The effect's views are known once it has a layout.
      if (auto known = unknownView(session, options.debugView); !known) return known.error();
      request.debugView = options.debugView;
      if (!options.viewExr.empty()) request.views = {options.debugView};
    }
    const auto now = session.effect().resolved();
    unchanged = now == resolved ? unchanged + 1 : 0;
    resolved = now;
    if (frame + 1 >= kWarmUpFrames && unchanged >= (resolved.empty() ? 1u : kFramesPerVariant)) break;
  }
  request.meter = false;
  std::vector<std::vector<render::PassTime>> frames;
  for (std::uint32_t frame = 0; frame < options.frames; ++frame) {
    if (auto done = oneFrame(session, request, wants, run); !done) return done.error();
    std::vector<render::PassTime> passes = session.lastPassTimes();
    std::erase_if(passes, [](const render::PassTime& pass) { return pass.owner == Readback::kOwner; });
    frames.push_back(std::move(passes));
  }
  run.passes = medianFrame(frames);
  run.effectBytes = session.effect().memoryBytes();
  run.transientBytes = session.statistics().transientBytes;
  run.deviceBytes = session.device().allocatedBytes();
  run.validationMessages = session.device().validationMessages();
  return run;
}

}  // namespace tyndall::app
