#include "laboratory.hpp"

#include <stdexcept>

#include "bench/error_split.hpp"
#include "bench/truths.hpp"
#include "truth/truth.hpp"

namespace tyndall::figures {
namespace {

template <class T>
T must(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().message);
  return result.take();
}
void must(const Result<void>& result) {
  if (!result) throw std::runtime_error(result.error().message);
}

}  // namespace

Settings operator+(Settings a, const Settings& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

double Shot::pluginMs(const std::string& name) const {
  double sum = 0;
  for (const render::PassTime& pass : passes)
    if (pass.owner == "volumetrics" && pass.name.starts_with(name)) sum += pass.milliseconds;
  return sum;
}

Laboratory::Laboratory(const std::string& level, std::uint32_t camera, std::uint32_t width, std::uint32_t height)
    : level_(level), cameraIndex_(camera) {
  app::Level loaded = must(app::loadLevel(level));
  start_ = must(app::chooseCamera(loaded, camera, 0));
  request_.width = width;
  request_.height = height;
  request_.camera = start_;
  session_ = must(app::Session::open(must(app::Catalogue::load(app::pluginFolder({}))), {}));
  must(session_->setLevel(std::move(loaded)));
}

void Laboratory::turn(double degrees) { request_.camera = bench::turned(start_, {degrees, 0}); }

std::vector<glm::vec2> Laboratory::lightsInPicture() const {
  return bench::lightsInPicture(session_->level()->lights(0), start_, {request_.width, request_.height});
}

Shot Laboratory::frame() {
  render::Graph graph(session_->device(), session_->graphMemory());
  const render::FrameOutput output = must(session_->buildFrame(graph, request_));
  must(readback_.addPasses(*session_, graph, output, request_, {!request_.debugView.empty(), true, false}));
  must(session_->submitFrame(graph));
  must(session_->finishFrames());
  if (session_->effect().failure()) throw std::runtime_error(session_->effect().failure()->message);
  return {readback_.scatter(), session_->lastPassTimes()};
}

Shot Laboratory::shoot(const Settings& settings) {
  session_->table().resetToDefaults();
  must(session_->table().setText("shadows.reuse", "true"));
  for (const std::string& setting : settings) must(session_->table().setAssignment(setting));
  frame();
  return frame();
}

image::ByteImage Laboratory::look(const Settings& settings, const std::string& view) {
  request_.debugView = view;
  shoot(settings);
  request_.debugView.clear();
  return readback_.picture();
}

std::vector<Shot> Laboratory::again(int frames) {
  std::vector<Shot> shots;
  for (int i = 0; i < frames; ++i) shots.push_back(frame());
  return shots;
}

image::FloatImage Laboratory::truth(std::uint32_t samples) {
  const std::filesystem::path file =
      std::filesystem::path(TYNDALL_TRUTH_CACHE) /
      (level_ + "-" + std::to_string(cameraIndex_) + "-" + std::to_string(request_.width) + "x" +
       std::to_string(request_.height) + "-" + std::to_string(samples) + ".exr");
  // A level that was made anew makes its kept truths worthless.
  std::error_code missing;
  const auto made = std::filesystem::last_write_time(file, missing);
  if (!missing && made > std::filesystem::last_write_time(session_->level()->path))
    if (auto kept = image::readExr(file)) return kept.take();
  truth::Settings settings;
  settings.width = request_.width;
  settings.height = request_.height;
  settings.samples = samples;
  const truth::Picture picture =
      must(truth::render(session_->level()->scene, start_, session_->level()->lights(0), settings));
  image::FloatImage result{request_.width, request_.height, 4, {}};
  for (const glm::vec4& p : picture.scatter) result.values.insert(result.values.end(), {p.r, p.g, p.b, p.a});
  std::filesystem::create_directories(file.parent_path());
  must(image::writeExr(file, result));
  return result;
}

image::ErrorMetrics errorOf(const image::FloatImage& picture, const image::FloatImage& reference) {
  return must(image::compare(picture, reference));
}

}  // namespace tyndall::figures
