#include "bench/campaign.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include "bench/error_split.hpp"
#include "bench/truths.hpp"
#include "image/metrics.hpp"

namespace tyndall::bench {
namespace {

/// What one measurement found; points that share it copy it.
struct Measured {
  std::string technique;
  Assignments settings;
  Size size{0, 0};
  double seconds = 0;  ///< that its timed frames took so far, by the clock
  bool motion = false;
  std::vector<double> gpu, effect;
  double shadows = 0;  ///< taken by itself, since maps are kept from frame to frame
  std::vector<std::pair<std::string, std::string>> passOrder;  // name, owner
  std::map<std::string, std::vector<double>> passes;
  std::uint64_t memory = 0;
  std::optional<std::uint64_t> moved;
  std::optional<SplitErrors> truth, march;
  std::optional<double> motionError, flicker;
  std::string failure;

  void add(const std::vector<render::PassTime>& times, const std::string& effectId) {
    double all = shadows, own = 0;
    std::map<std::string, double> byName;
    for (const render::PassTime& pass : times) {
      if (isShadowPass(pass)) continue;
      all += pass.milliseconds;
      if (pass.owner == effectId) own += pass.milliseconds;
      if (!byName.contains(pass.name) && !passes.contains(pass.name)) passOrder.emplace_back(pass.name, pass.owner);
      byName[pass.name] += pass.milliseconds;
    }
    gpu.push_back(all), effect.push_back(own);
    for (const auto& [name, ms] : byName) passes[name].push_back(ms);
  }
  void into(PointFigures& f) const {
    f.failure = failure;
    if (!failure.empty()) return;
    f.gpu = spreadOf(gpu), f.volumetrics = spreadOf(effect), f.shadows = spreadOf({shadows});
    for (const auto& [name, owner] : passOrder) f.passes.push_back({name, owner, spreadOf(passes.at(name)).median});
    f.memoryBytes = memory, f.movedBytes = moved, f.truth = truth, f.march = march, f.motionError = motionError,
    f.flicker = flicker;
  }
};

class View {
 public:
  View(Stand& stand, const Sweep& sweep, const app::Level& level, std::uint32_t camera, const scene::CameraView& view,
       const Watcher& watcher)
      : stand_(stand),
        sweep_(sweep),
        level_(level),
        cameraIndex_(camera),
        camera_(view),
        watcher_(watcher),
        lights_(lightsInPicture(level.lights(0), view, sweep.errorSize)) {}

  /// False: stopped.
  Result<bool> references() {
    truth::Medium medium;
    if (auto applied = applySettings(stand_.session().table(), sweep_.settings); !applied) return applied.error();
    const params::Table& table = stand_.session().table();
    for (const auto& [id, target] :
         {std::pair{"medium.sigma_t", &medium.sigma_t}, {"medium.albedo", &medium.albedo}, {"medium.g", &medium.g}}) {
      if (!table.find(id))
        return failed("bench: the plugin in use has no parameter " + std::string(id) +
                      "; the volumetrics plugin is needed");
      *target = table.value(id);
    }
    bool go = true;
    const auto progress = [&](double share) {
      return go = watcher_.tell("truth " + std::to_string(static_cast<int>(100 * share)) + " %", 0, 1);
    };
    auto truth = truthOf(level_, cameraIndex_, {}, sweep_.errorSize, 0, medium, sweep_.truthSamples, progress);
    if (!go) return false;
    if (!truth) return truth.error();
    truth_ = truth.take();
    auto half =
        truthOf(level_, cameraIndex_, {}, sweep_.errorSize, 0, medium, std::max(1u, sweep_.truthSamples / 2), progress);
    if (!go) return false;
    if (!half) return half.error();
    if (auto self = splitErrors(truth_.scatter, half->scatter, {}, {})) truthSelf = self->all->nrmse;
    if (sweep_.march.empty()) return true;
    marchSettings_ = sweep_.settings;
    for (const auto& [id, value] : sweep_.march) marchSettings_[id] = value;
    if (auto done = stand_.render(marchSettings_, camera_, sweep_.errorSize, 0, 2, true); !done) return done.error();
    march_ = stand_.scatter();
    return true;
  }

  Result<void> errorsOf(Measured& m) {
    if (auto done = stand_.render(m.settings, camera_, sweep_.errorSize, 0, 2, true); !done) return done;
    const image::FloatImage picture = stand_.scatter();
    auto split = splitErrors(picture, truth_.scatter, truth_.distance, lights_);
    if (!split) return split.error();
    m.truth = split.take();
    if (march_.values.empty()) return {};
    auto marched = splitErrors(picture, march_, truth_.distance, lights_);
    if (!marched) return marched.error();
    m.march = marched.take();
    return {};
  }

  /// A moving camera: the mean error against the march, and what changes from frame to frame that should not.
  Result<void> motionOf(Measured& m) {
    if (path_.empty())
      if (auto filled = pictures(marchSettings_, path_); !filled) return filled;
    std::vector<image::FloatImage> own;
    if (auto filled = pictures(m.settings, own); !filled) return filled;
    double errors = 0, squares = 0, mean = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < own.size(); ++i) {
      auto error = image::compare(own[i], path_[i]);
      if (!error) return error.error();
      errors += error->nRmse;
      mean += error->referenceMean;
      for (std::size_t v = 0; i > 0 && v < own[i].values.size(); ++v) {
        if (v % 4 == 3) continue;
        const double change = static_cast<double>(own[i].values[v]) - static_cast<double>(own[i - 1].values[v]);
        const double right = static_cast<double>(path_[i].values[v]) - static_cast<double>(path_[i - 1].values[v]);
        squares += (change - right) * (change - right);
        ++count;
      }
    }
    const auto frames = static_cast<double>(own.size());
    m.motionError = errors / frames;
    m.flicker = std::sqrt(squares / static_cast<double>(count)) / (mean / frames);
    return {};
  }

  std::optional<double> truthSelf;
  bool lightInView() const { return insidePicture(lights_, sweep_.errorSize); }

 private:
  Result<void> pictures(const Assignments& settings, std::vector<image::FloatImage>& frames) {
    for (std::uint32_t i = 0; i < sweep_.motion.frames; ++i) {
      const scene::CameraView camera = turned(camera_, {sweep_.motion.turn * i, 0});
      // Two frames at the first place: the first compiles and starts afresh what is kept from frame to frame.
      if (auto done =
              stand_.render(settings, camera, sweep_.errorSize, sweep_.motion.seconds * i, i == 0 ? 2 : 1, true);
          !done)
        return done;
      frames.push_back(stand_.scatter());
    }
    return {};
  }

  Stand& stand_;
  const Sweep& sweep_;
  const app::Level& level_;
  std::uint32_t cameraIndex_;
  scene::CameraView camera_;
  const Watcher& watcher_;
  std::vector<glm::vec2> lights_;
  Truth truth_;
  image::FloatImage march_;
  Assignments marchSettings_;
  std::vector<image::FloatImage> path_;  ///< of the march
};

LevelFigures figuresOf(const app::Level& level, std::uint32_t camera, const Sweep& sweep, const View& view) {
  LevelFigures figures;
  figures.name = level.name;
  figures.camera = camera;
  for (const scene::Node& node : level.scene.nodes)
    if (node.mesh != scene::kNone)
      for (const scene::Primitive& primitive : level.scene.meshes[static_cast<std::size_t>(node.mesh)].primitives)
        figures.triangles += primitive.indices.size() / 3;
  figures.lights = level.lights(0).size();
  figures.lightInView = view.lightInView();
  figures.truthSamples = sweep.truthSamples;
  figures.truthSelf = view.truthSelf;
  return figures;
}

}  // namespace

Result<bool> measureView(Stand& stand, const Sweep& sweep, const app::Level& level, std::uint32_t camera,
                         const std::vector<PlannedPoint>& planned, Results& results, const Watcher& watcher) {
  auto chosen = app::chooseCamera(level, camera, 0);
  if (!chosen) return chosen.error();
  std::vector<std::string> order;
  std::map<std::string, Measured> measured;
  for (const PlannedPoint& point : planned) {
    if (results.find(point.figures.key) || measured.contains(point.measurement)) continue;
    order.push_back(point.measurement);
    Measured& m = measured[point.measurement];
    m.technique = point.figures.technique, m.settings = point.all, m.size = point.figures.size, m.motion = point.motion;
  }
  if (order.empty()) return true;

  View view(stand, sweep, level, camera, *chosen, watcher);
  auto ready = view.references();
  if (!ready || !*ready) return ready;
  const std::size_t steps = order.size() * (sweep.repetitions + 1);
  std::size_t done = 0;
  const auto go = [&] { return watcher.tell("points", done++, steps); };
  const std::string& effect = stand.catalogue().effectPlugin().id();
  std::map<std::string, Assignments> choices;  // of each technique, what is left to measurement
  std::map<std::string, double> shadowTimes;   // by the settings of shadow maps
  const auto takeShadows = [&](Measured& m) -> Result<void> {
    std::string of = std::to_string(m.size.first) + "x" + std::to_string(m.size.second);
    for (const auto& [id, value] : m.settings)
      if (id.starts_with("shadows.")) of += " " + id + "=" + value;
    const auto known = shadowTimes.find(of);
    if (known != shadowTimes.end()) {
      m.shadows = known->second;
      return {};
    }
    auto taken = stand.shadowTime(m.settings, *chosen, m.size, 0);
    if (!taken) return taken.error();
    m.shadows = shadowTimes[of] = *taken;
    return {};
  };
  for (const std::string& name : order) {
    if (!go()) return false;
    Measured& m = measured.at(name);
    // What is chosen by measurement depends on the maps, not on the picture: a small one will do. Where every technique
    // is tried with defaults first, what was chosen there holds for its other points.
    Result<void> ok{};
    if (const auto known = choices.find(m.technique); sweep.everyTechnique && known != choices.end()) {
      m.settings.insert(known->second.begin(), known->second.end());
    } else {
      ok = stand.warmUp(m.settings, *chosen, sweep.errorSize, 0);
      const auto resolved = stand.session().effect().resolved();
      if (ok) choices[m.technique] = {resolved.begin(), resolved.end()};
    }
    if (ok) ok = view.errorsOf(m);
    if (ok) ok = takeShadows(m);
    if (ok && m.motion) ok = view.motionOf(m);
    if (!ok) m.failure = ok.error().message;
  }
  for (std::uint32_t round = 0; round < sweep.repetitions; ++round)
    for (const std::string& name : order) {
      if (!go()) return false;
      Measured& m = measured.at(name);
      if (!m.failure.empty() || (round > 0 && m.seconds > sweep.secondsPerPoint)) continue;
      const auto start = std::chrono::steady_clock::now();
      if (auto ok = stand.render(m.settings, *chosen, m.size, 0, 2, false); !ok) {
        m.failure = ok.error().message;
        continue;
      }
      m.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      m.add(stand.passes(), effect);
      m.memory = stand.session().effect().memoryBytes(), m.moved = stand.session().effect().bytesMoved();
    }

  for (const PlannedPoint& point : planned) {
    if (results.find(point.figures.key)) continue;
    PointFigures figures = point.figures;
    measured.at(point.measurement).into(figures);
    results.points.push_back(std::move(figures));
  }
  const LevelFigures figures = figuresOf(level, camera, sweep, view);
  const auto same = [&](const LevelFigures& l) { return l.name == figures.name && l.camera == figures.camera; };
  std::erase_if(results.levels, same);
  results.levels.push_back(figures);
  return true;
}

}  // namespace tyndall::bench
