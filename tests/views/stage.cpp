#include "stage.hpp"

namespace tyndall::views {

bool Stage::open(const std::string& level, std::uint32_t camera, const std::vector<std::string>& settings) {
  auto catalogue = app::Catalogue::load(app::pluginFolder({}));
  EXPECT_TRUE(catalogue) << catalogue.error().message;
  if (!catalogue) return false;
  auto session = app::Session::open(catalogue.take(), {});
  EXPECT_TRUE(session) << session.error().message;
  if (!session) return false;
  session_ = session.take();
  auto loaded = app::loadLevel(level);
  EXPECT_TRUE(loaded) << loaded.error().message;
  if (!loaded) return false;
  auto chosen = app::chooseCamera(*loaded, camera, 0);
  EXPECT_TRUE(chosen) << chosen.error().message;
  if (!chosen) return false;
  camera_ = *chosen;
  auto placed = session_->setLevel(loaded.take());
  EXPECT_TRUE(placed) << placed.error().message;
  set(settings);
  return placed.ok();
}

void Stage::set(const std::vector<std::string>& settings) {
  for (const std::string& setting : settings) {
    auto done = session_->table().setAssignment(setting);
    EXPECT_TRUE(done) << done.error().message;
  }
}

Taken Stage::take(std::uint32_t width, std::uint32_t height, const std::vector<app::ViewRequest>& views,
                  const std::string& shown) {
  app::FrameRequest request;
  request.width = width, request.height = height, request.camera = camera_, request.debugView = shown;
  for (const app::ViewRequest& view : views) request.views.push_back(view.name);
  app::Readback readback;
  app::ViewReadback viewReadback;
  render::Graph graph(session_->device(), session_->graphMemory());
  auto output = session_->buildFrame(graph, request);
  EXPECT_TRUE(output) << output.error().message;
  if (!output) return {};
  EXPECT_TRUE(readback.addPasses(*session_, graph, *output, request, {true, true, true}));
  EXPECT_TRUE(viewReadback.addPasses(*session_, graph, *output, views));
  EXPECT_TRUE(session_->submitFrame(graph));
  EXPECT_TRUE(session_->finishFrames());
  return {viewReadback.pictures(), readback.scatter(), readback.distance(), readback.picture()};
}

std::string Stage::viewOf(render::ViewRole role) const {
  for (const render::DebugViewInfo& view : session_->debugViews())
    if (view.role == role) return view.name;
  return "";
}

}  // namespace tyndall::views
