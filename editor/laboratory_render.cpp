// What the second engine does: frames whose numbers come back, alone or timed.
#include <algorithm>

#include "app/median.hpp"
#include "app/readback.hpp"
#include "laboratory.hpp"

namespace tyndall::editor {
namespace {

// As `tyndall render` does: two frames for shaders and caches, more only while speed variants are still being timed.
constexpr std::uint32_t kWarmUpFrames = 2, kMostWarmUpFrames = 64, kFramesPerVariant = 4;

struct Frame {
  app::Readback readback;
  app::ViewReadback views;
};

Result<void> renderOne(app::Session& session, const app::FrameRequest& request,
                       const std::vector<app::ViewRequest>& views, Frame& frame) {
  render::Graph graph(session.device(), session.graphMemory());
  auto output = session.buildFrame(graph, request);
  if (!output) return output.error();
  // A frame that was begun has to be submitted, also when its results cannot be read.
  auto added = frame.readback.addPasses(session, graph, *output, request, {false, true, false});
  if (added) added = frame.views.addPasses(session, graph, *output, views);
  if (auto submitted = session.submitFrame(graph); !submitted) return submitted;
  if (auto finished = session.finishFrames(); !finished) return finished;
  if (session.effect().failure()) return *session.effect().failure();
  return added;
}

double effectMs(const app::Session& session, const std::string& owner) {
  double sum = 0;
  for (const render::PassTime& pass : session.lastPassTimes())
    if (pass.owner == owner) sum += pass.milliseconds;
  return sum;
}

Result<RenderResult> referenceOf(RenderResult result) {
  const app::ViewPicture& view = result.views.front();
  if (view.values.empty()) return failed("reference: this frame has no image for the view '" + view.name + "'");
  image::FloatImage radiance{view.width, view.height, 3, {}};
  for (std::size_t i = 0; i < view.values.size(); i += view.channels)
    for (std::size_t c = 0; c < 3; ++c)
      radiance.values.push_back(view.values[i + std::min<std::size_t>(c, view.channels - 1)]);
  result.scatter = std::move(radiance);
  result.views.clear();
  return result;
}

}  // namespace

/// Takes the plugin, the shaders, the level and the settings of the shot.
Result<void> Laboratory::follow(const Shot& shot) {
  if (session_->pluginChanged())
    if (auto reloaded = session_->reloadPlugin(); !reloaded) return reloaded;
  (void)session_
      ->reloadShaders();  // what is broken is told by the window's own engine, and the last good code stays here too
  if (level_ != shot.level) {
    level_.reset();
    if (auto set = session_->setLevel(*shot.level); !set) return set;
    level_ = shot.level;
  }
  for (const auto& [id, value] : shot.values)
    if (session_->table().find(id))
      if (auto set = session_->table().set(id, value); !set) return set;
  return {};
}

Result<RenderResult> Laboratory::renderNow(const RenderTask& task, Job& job) {
  if (auto followed = follow(task.shot); !followed) return followed.error();
  app::FrameRequest request;
  request.width = task.shot.width, request.height = task.shot.height;
  request.camera = task.shot.camera;
  request.seconds = task.shot.seconds;
  std::vector<app::ViewRequest> views = task.views;
  Frame frame;
  if (task.reference) {
    // The views of a layout are known once it has been made for these lights.
    if (auto done = renderOne(*session_, request, {}, frame); !done) return done.error();
    views.clear();
    for (const render::DebugViewInfo& view : session_->debugViews())
      if (view.role == render::ViewRole::kReference) views.push_back({view.name});
    if (views.empty())
      return failed("reference: the technique in use offers no view to judge by; choose another technique");
  }
  for (const app::ViewRequest& view : views) request.views.push_back(view.name);
  const std::string owner = session_->catalogue().effectPlugin().id();
  const std::uint32_t counted = std::max(task.repeats, 1u);
  std::vector<std::pair<std::string, std::string>> resolved;
  std::uint32_t unchanged = 0;
  for (std::uint32_t i = 0; task.repeats > 0 && i < kMostWarmUpFrames; ++i) {
    if (auto done = renderOne(*session_, request, views, frame); !done) return done.error();
    if (job.cancelled) return failed("cancelled");
    const auto now = session_->effect().resolved();
    unchanged = now == resolved ? unchanged + 1 : 0;
    resolved = now;
    if (i + 1 >= kWarmUpFrames && unchanged >= (resolved.empty() ? 1u : kFramesPerVariant)) break;
  }
  std::vector<double> times;
  for (std::uint32_t i = 0; i < counted; ++i) {
    if (auto done = renderOne(*session_, request, views, frame); !done) return done.error();
    if (job.cancelled) return failed("cancelled");
    times.push_back(effectMs(*session_, owner));
    job.progress = static_cast<float>(i + 1) / static_cast<float>(counted);
  }
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>((times.size() - 1) / 2);
  std::nth_element(times.begin(), middle, times.end());
  RenderResult result{frame.readback.scatter(), frame.views.pictures(), *middle};
  return task.reference ? referenceOf(std::move(result)) : Result<RenderResult>(std::move(result));
}

}  // namespace tyndall::editor
