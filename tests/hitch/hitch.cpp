#include "hitch.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include <time.h>

namespace tyndall::hitch {
namespace {

using Clock = std::chrono::steady_clock;
using Background = host::PluginEffect::Background;

template <class T>
T must(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().message);
  return result.take();
}
void must(const Result<void>& result) {
  if (!result) throw std::runtime_error(result.error().message);
}

double processSeconds() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

constexpr int kSteadyFrames = 5;  // whose median is the steady state's time
constexpr int kFramesAfter = 3;   // of the new value that may show what was left to compile
// Between frames, as a window's waits for its images: what is built gets a share of a processor that frames would fill.
constexpr std::chrono::milliseconds kPause{80};
constexpr double kMostSeconds = 120;  // for a build beside frames that take most of the processor

}  // namespace

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

const Settings& Bench::small() {
  static const Settings settings = {"volumetrics.columns=256", "volumetrics.slices=128", "shadows.resolution=256",
                                    "volumetrics.prefix_scheme=row", "volumetrics.steps=64"};
  return settings;
}

Bench::Bench(const std::string& level, std::uint32_t width, std::uint32_t height, bool background) {
  std::string name = (std::filesystem::temp_directory_path() / "tyndall-hitch-XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
  caches_ = name;
  ::setenv("MESA_SHADER_CACHE_DIR", (caches_ / "mesa").c_str(), 1);
  ::setenv("XDG_CACHE_HOME", caches_.c_str(), 1);
  app::Level loaded = must(app::loadLevel(level));
  request_.width = width;
  request_.height = height;
  request_.camera = must(app::chooseCamera(loaded, 0, 0));
  session_ = must(app::Session::open(must(app::Catalogue::load(app::pluginFolder({}))), {}));
  session_->buildInBackground(background);
  must(session_->setLevel(std::move(loaded)));
}

Bench::~Bench() {
  readback_ = {};
  session_.reset();
  std::error_code none;
  std::filesystem::remove_all(caches_, none);
}

Bench::Times Bench::frame() {
  const auto start = Clock::now();
  const double cpuStart = processSeconds();
  render::Graph graph(session_->device(), session_->graphMemory());
  const render::FrameOutput output = must(session_->buildFrame(graph, request_));
  must(readback_.addPasses(*session_, graph, output, request_, {true, false, false}));
  must(session_->submitFrame(graph));
  must(session_->finishFrames());
  if (session_->effect().failure()) throw std::runtime_error(session_->effect().failure()->message);
  return {1000 * secondsSince(start), 1000 * (processSeconds() - cpuStart)};
}

image::ByteImage Bench::shoot() {
  (void)frame();
  return readback_.picture();
}

Bench::Times Bench::steady() {
  std::vector<double> wall, cpu;
  for (int i = 0; i < kSteadyFrames; ++i) {
    const Times times = frame();
    wall.push_back(times.wall), cpu.push_back(times.cpu);
  }
  return {median(std::move(wall)), median(std::move(cpu))};
}

int Bench::cacheEntries() const {
  int count = 0;
  std::error_code none;
  for (std::filesystem::recursive_directory_iterator entry(caches_ / "mesa", none), end; !none && entry != end;
       entry.increment(none))
    if (entry->is_regular_file(none) && entry->path().extension() != ".tmp") ++count;
  return count;
}

void Bench::settle(const Settings& settings) {
  session_->table().resetToDefaults();
  for (const Settings& list : {small(), settings})
    for (const std::string& setting : list) must(session_->table().setAssignment(setting));
  const auto start = Clock::now();
  do (void)frame();
  while (session_->background() != Background::kIdle && secondsSince(start) < kMostSeconds);
  (void)frame();
}

Change Bench::change(const std::string& id, const std::string& value) {
  params::Table& table = session_->table();
  Change change;
  change.what = id + " " + params::toText(*table.find(id), table.value(id)) + " -> " + value;
  const Times before = steady();
  change.before = before.wall, change.cpuBefore = before.cpu;
  must(table.setText(id, value));
  const auto start = Clock::now();
  const auto timed = [&] {
    std::this_thread::sleep_for(kPause);
    const bool building = session_->background() == Background::kBuilding;
    const Times times = frame();
    if (!building) change.cpuWorst = std::max(change.cpuWorst, times.cpu);
    if (times.wall <= change.worst) return;
    change.worst = times.wall;
    const auto& passes = session_->lastPassTimes();
    const auto slowest = std::max_element(passes.begin(), passes.end(),
                                          [](const auto& a, const auto& b) { return a.milliseconds < b.milliseconds; });
    if (slowest != passes.end())
      change.slowestPass = slowest->name + " " + std::to_string(std::lround(slowest->milliseconds));
  };
  int entries = cacheEntries();
  for (;; ++change.frames) {
    timed();
    if (session_->background() == Background::kIdle) break;
    entries = cacheEntries();
    if (secondsSince(start) > kMostSeconds)
      throw std::runtime_error(change.what + ": not built in " + std::to_string(kMostSeconds) + " s");
  }
  change.seconds = secondsSince(start);
  for (int i = 1; i < kFramesAfter; ++i) timed();
  const Times after = steady();
  change.after = after.wall, change.cpuAfter = after.cpu;
  change.late = cacheEntries() - entries;
  return change;
}

}  // namespace tyndall::hitch
