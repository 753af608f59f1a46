#include "stress.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/memory.hpp"
#include "memory_growth.hpp"
#include "node_motion.hpp"
#include "stress_level.hpp"

namespace tyndall::editor {
namespace {

using Background = host::PluginEffect::Background;

constexpr std::pair<std::uint32_t, std::uint32_t> kHomeSize{320, 200};
constexpr std::uint32_t kQuietFrames =
    30;  // drawn at home with nothing left to build, so that what was let go of is gone (render/pipeline_library.cpp)
constexpr std::uint32_t kMostQuietFrames = 5000;  // for a build that never ends
// Growth from the warm-up to the end (growthOf()). Of images and buffers: staging memory grows to the largest level. Of
// the process: heaps are torn, and a driver for the CPU keeps code for a while.
constexpr double kDeviceGrowthMiB = 16, kResidentGrowthMiB = 128, kAllocatedGrowthMiB = 64;
constexpr std::uint32_t kLongRun = 1000;  // steps from which on a line is printed at each return
constexpr std::size_t kPrinted = 8;       // different texts of a list

/// Maps so small that drawing is cheap, and nothing on automatic.
constexpr std::pair<const char*, const char*> kCheap[] = {{"volumetrics.columns", "64"},
                                                          {"volumetrics.slices", "64"},
                                                          {"shadows.resolution", "128"},
                                                          {"volumetrics.steps", "32"},
                                                          {"volumetrics.prefix_scheme", "row"}};

double mebibytes(std::uint64_t bytes) { return static_cast<double>(bytes) / (1 << 20); }

void printList(const char* title, const std::map<std::string, std::uint32_t>& list) {
  if (list.empty()) return;
  std::printf("%s\n", title);
  std::size_t printed = 0;
  for (const auto& [text, count] : list)
    if (printed++ < kPrinted) std::printf("  %5u  %s\n", count, text.c_str());
  if (list.size() > kPrinted) std::printf("  ... and %zu more\n", list.size() - kPrinted);
}

}  // namespace

Stress::Stress(std::uint32_t steps, std::uint32_t seed) : steps_(steps), random_(seed) {}

Result<bool> Stress::act(const Stage& stage) {
  const auto now = std::chrono::steady_clock::now();
  const double ms = std::chrono::duration<double, std::milli>(now - lastTurn_).count();
  if (lastTurn_.time_since_epoch().count() != 0 && stage.pictures > lastPictures_ && ms > longestMs_)
    longestMs_ = ms, longestAfter_ = lastAction_;
  lastTurn_ = now;
  lastPictures_ = stage.pictures;
  listen(stage);
  stage.workspace.changed = true;

  if (levels_.empty()) {
    levels_ = {stage.session.level()->name, "", "", ""};
    if (auto home = goHome(stage); !home) return home.error();
  }
  if (mode_ == Mode::kGoingHome) {
    ++pause_;
    quiet_ = stage.session.background() == Background::kIdle ? quiet_ + 1 : 0;
    if (quiet_ < kQuietFrames && pause_ < kMostQuietFrames) return true;
    if (quiet_ < kQuietFrames) unexpected_.push_back("the background build does not end");
    returnFreeMemory();  // as the editor does when nobody uses it
    atHome_.push_back({residentBytes(), allocatedBytes(), stage.session.device().allocatedBytes()});
    if (steps_ >= kLongRun)
      std::fprintf(stderr, "tyndall: stress: step %u of %u, %.0f MiB resident, %.0f MiB allocated\n", step_, steps_,
                   mebibytes(atHome_.back().resident), mebibytes(atHome_.back().allocated));
    pause_ = quiet_ = 0;
    mode_ = Mode::kRoaming;
    if (step_ == steps_) return false;
  }
  if (pause_ > 0) return --pause_, true;
  faults_.withdraw();
  faulty_ = false;
  const std::uint32_t roam = std::clamp(steps_ / 5, 10u, 100u);
  if (step_ == steps_ || (step_ % roam == 0 && step_ > 0 && lastAction_ != "going home")) {
    if (auto home = goHome(stage); !home) return home.error();
    return true;
  }
  ++step_;
  pause_ = below(4);
  if (auto done = something(stage); !done) return done.error();
  return true;
}

Result<void> Stress::something(const Stage& stage) {
  Workspace& workspace = stage.workspace;
  const std::uint32_t kind = below(100);
  lastAction_ = "";
  if (kind < 45)
    changeParameter(stage);
  else if (kind < 55)
    editLevel(stage);
  else if (kind < 67)
    resize(stage);
  else if (kind < 74)
    return changeLevel(stage);
  else if (kind < 84)
    changeView(stage);
  else if (kind < 88)
    workspace.reloadShaders = true, lastAction_ = "reload of shaders";
  else if (kind < 91)
    workspace.reloadPlugin = true, lastAction_ = "reload of the plugin";
  else if (kind < 94)
    workspace.seconds = 10 * unit(), lastAction_ = "another time";
  else
    orderFault(stage);
  note(lastAction_.starts_with("volumetrics.") || lastAction_.find('.') != std::string::npos ? "parameter"
                                                                                             : lastAction_);
  return {};
}

void Stress::changeParameter(const Stage& stage) {
  params::Table& table = stage.session.table();
  const params::Parameter& p = table.parameters()[below(static_cast<std::uint32_t>(table.parameters().size()))];
  double value = 0;
  if (p.type == params::Type::kBool) {
    value = below(2);
  } else if (p.type == params::Type::kEnum) {
    value = below(static_cast<std::uint32_t>(p.choices.size()));
  } else {
    const bool wide = p.builtMin > 0 && p.builtMax / p.builtMin > 16;
    value =
        wide ? p.builtMin * std::pow(p.builtMax / p.builtMin, unit()) : p.builtMin + (p.builtMax - p.builtMin) * unit();
    if (below(20) == 0) value = below(2) ? p.builtMin : p.builtMax;
    if (p.type == params::Type::kInt) value = std::clamp(std::round(value), p.builtMin, p.builtMax);
  }
  lastAction_ = p.id + "=" + params::toText(p, value);
  if (!table.set(p.id, value))
    lastAction_ = "a choice that is not built yet";
  else
    keepCheap(table, p.id);
}

/// One large map at a time: all of them at once take seconds a frame and gigabytes.
void Stress::keepCheap(params::Table& table, const std::string& changed) {
  for (const auto& [id, text] : kCheap) {
    const params::Parameter* p = table.find(id);
    if (!p || p->type != params::Type::kInt || id == changed) continue;
    const auto cheap = params::fromText(*p, text);
    if (cheap && table.value(id) > 4 * *cheap) (void)table.set(id, *cheap);
  }
}

void Stress::resize(const Stage& stage) {
  static constexpr std::pair<std::uint32_t, std::uint32_t> kTiny[] = {{1, 1}, {2, 1}, {1, 40}, {17, 3}, {64, 64}};
  std::pair<std::uint32_t, std::uint32_t> size{100 + below(400), 80 + below(240)};
  const std::uint32_t kind = below(20);
  if (kind < 6)
    size = kTiny[below(std::size(kTiny))];
  else if (kind == 6)
    size = {1400, 900};
  stage.window.resize(size.first, size.second);
  lastAction_ = "another size";
}

Result<void> Stress::changeLevel(const Stage& stage) {
  const std::string& name = levels_[below(static_cast<std::uint32_t>(levels_.size()))];
  app::Level level;
  if (name.empty()) {
    level = stressLevel(random_);
  } else {
    auto loaded = app::loadLevel(name);
    if (!loaded) return loaded.error();
    level = loaded.take();
  }
  lastAction_ = "another level";
  note(lastAction_);
  return stage.session.setLevel(std::move(level));
}

void Stress::changeView(const Stage& stage) {
  const auto views = stage.session.debugViews();
  const std::uint32_t chosen = below(static_cast<std::uint32_t>(views.size()) + 2);
  stage.workspace.debugView = chosen < views.size() ? views[chosen].name : "";
  lastAction_ = "another debug view";
}

/// As the level's panel and its handles do.
void Stress::editLevel(const Stage& stage) {
  scene::Scene& scene = stage.session.editScene();
  lastAction_ = "an edit of the level";
  if (below(2) == 0 && !scene.materials.empty()) {
    const int material = static_cast<int>(below(static_cast<std::uint32_t>(scene.materials.size())));
    MaterialEdit edit = materialAt(scene, material);
    for (int i = 0; i < 4; ++i) edit.baseColor[i] = static_cast<float>(unit());
    edit.roughness = static_cast<float>(unit());
    return setMaterial(scene, material, edit);
  }
  if (scene.nodes.empty()) return;
  const int node = static_cast<int>(below(static_cast<std::uint32_t>(scene.nodes.size())));
  const auto worldFromNode = stage.session.level()->worldFromNode(stage.workspace.seconds);
  const glm::mat4 parent = worldFromParent(scene, worldFromNode, node);
  const auto signedUnit = [this] { return static_cast<float>(2 * unit() - 1); };
  NodeEdit place = moved(nodeAt(scene, node), parent, {signedUnit(), signedUnit(), signedUnit()});
  place = turned(place, parent, {signedUnit(), signedUnit(), signedUnit()},
                 glm::angleAxis(signedUnit(), glm::vec3(0, 1, 0)));
  setNode(scene, node, place);
  if (scene.nodes[static_cast<std::size_t>(node)].light == scene::kNone) return;
  LightEdit light = lightAt(scene, node);
  light.intensity *= static_cast<float>(0.5 + unit());
  setLight(scene, node, light);
}

void Stress::orderFault(const Stage& stage) {
  static constexpr std::pair<Fault, const char*> kFaults[] = {{Fault::kOutOfDate, "out of date"},
                                                              {Fault::kSuboptimal, "suboptimal"},
                                                              {Fault::kSurfaceLost, "surface lost"},
                                                              {Fault::kOutOfDateLate, "out of date at presentation"},
                                                              {Fault::kSurfaceLostLate, "surface lost at presentation"},
                                                              {Fault::kNoArea, "no area"},
                                                              {Fault::kNoMemory, "no memory"}};
  const auto& [fault, name] = kFaults[below(std::size(kFaults))];
  if (fault == Fault::kNoArea)
    stage.window.resize(200 + below(100), 150 + below(100));  // only then is the surface looked at
  if (fault == Fault::kNoMemory) {
    // Twice as many columns need new images. One refusal is got over; after more, the settings before go on.
    params::Table& table = stage.session.table();
    if (table.find("volumetrics.columns"))
      (void)table.set("volumetrics.columns", table.value("volumetrics.columns") < 1000 ? 2048 : 512);
  }
  faulty_ = true;
  faults_.order(fault, 1 + below(3));
  lastAction_ = std::string("fault: ") + name;
}

Result<void> Stress::goHome(const Stage& stage) {
  mode_ = Mode::kGoingHome;
  lastAction_ = "going home";
  params::Table& table = stage.session.table();
  table.resetToDefaults();
  for (const auto& [id, text] : kCheap)
    if (table.find(id))
      if (auto set = table.setText(id, text); !set) return set;
  stage.window.resize(kHomeSize.first, kHomeSize.second);
  stage.workspace.debugView.clear();
  stage.workspace.seconds = 0;
  auto level = app::loadLevel(levels_.front());
  if (!level) return level.error();
  return stage.session.setLevel(level.take());
}

/// Notes each new error that is shown to the user.
void Stress::listen(const Stage& stage) {
  std::string text;
  if (const auto& failure = stage.session.effect().failure())
    text = failure->message;
  else if (stage.workspace.messageIsError)
    text = stage.workspace.message;
  if (text != lastMessage_ && !text.empty()) {
    ++refusals_[text];
    if (!faulty_) unexpected_.push_back("after " + lastAction_ + ": " + text);
  }
  lastMessage_ = text;
}

Result<void> Stress::report(const Stage& stage) {
  const std::uint32_t messages = stage.session.device().validationMessages();
  const auto growth = [this](std::uint64_t Memory::*bytes) {
    std::vector<double> readings;
    for (const Memory& memory : atHome_) readings.push_back(mebibytes(memory.*bytes));
    return growthOf(readings);
  };
  const MemoryGrowth resident = growth(&Memory::resident), allocated = growth(&Memory::allocated),
                     device = growth(&Memory::device);
  std::printf("stress: %u steps, %u pictures, %u faults\n", step_, stage.pictures, faults_.happened());
  printList("steps by kind:", done_);
  printList("errors shown:", refusals_);
  std::printf("validation messages: %u\n", messages);
  const auto print = [](const char* what, const MemoryGrowth& g) {
    std::printf("memory %s, MiB: %.2f after the warm-up, %.2f at the end (%+.2f)\n", what, g.before, g.after,
                g.grown());
  };
  print("of the process", resident);
  print("that is allocated", allocated);
  print("of images and buffers", device);
  std::printf("  at each return to the defaults:");
  for (const Memory& memory : atHome_)
    std::printf(" %.0f/%.0f", mebibytes(memory.resident), mebibytes(memory.allocated));
  std::printf("\n");
  std::printf("longest frame: %.0f ms, after %s\n", longestMs_, longestAfter_.c_str());
  std::string wrong;
  const auto add = [&wrong](const std::string& what) { wrong += (wrong.empty() ? "" : "; ") + what; };
  if (messages > 0) add(std::to_string(messages) + " validation messages");
  // A short run is all warm-up: every setting that is met for the first time makes pipelines.
  if (steps_ >= kLongRun && resident.grown() > kResidentGrowthMiB) add("the process grows");
  if (steps_ >= kLongRun && allocated.grown() > kAllocatedGrowthMiB) add("what is allocated grows");
  if (device.grown() > kDeviceGrowthMiB) add("images and buffers grow");
  if (!unexpected_.empty())
    add(std::to_string(unexpected_.size()) + " errors without a reason, the first " + unexpected_.front());
  std::fflush(stdout);
  return wrong.empty() ? Result<void>() : failed("--stress: " + wrong);
}

}  // namespace tyndall::editor
