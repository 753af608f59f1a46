// tyndall tune: successive halving over measured settings.
#include "app/bench_options.hpp"

#include <algorithm>
#include <cstdio>
#include <map>

#include <nlohmann/json.hpp>

#include "app/catalogue.hpp"
#include "app/level.hpp"
#include "app/outputs.hpp"
#include "base/file.hpp"
#include "bench/error_split.hpp"
#include "bench/halving.hpp"
#include "bench/stand.hpp"
#include "bench/truths.hpp"

namespace tyndall::bench {
namespace {

using Json = nlohmann::ordered_json;

/// A round: how many views, at which size errors are taken, with which truth, how many frames are timed, and how many candidates go on.
struct Round {
  bool everyView;
  Size errorSize;
  std::uint32_t truthSamples;
  int timed;
  double slack;
  std::size_t keep;  ///< at most, of those that go on; 0: the last round
};
constexpr Round kRounds[] = {{false, {160, 90}, 256, 1, 1.3, 16}, {true, {160, 90}, 256, 2, 1.15, 5}, {true, {320, 180}, 512, 5, 1.0, 0}};

struct Candidate {
  std::string technique;
  Assignments settings;
  std::vector<std::vector<double>> milliseconds;  ///< of each view
  std::vector<double> errors;                     ///< of each view
  std::string failure;
  std::string text() const {
    std::string all;
    for (const auto& [id, value] : settings) all += (all.empty() ? "" : " ") + id + "=" + value;
    return all;
  }
  /// The worst view's error, the mean of the views' medians.
  Score score() const {
    Score s;
    for (const double e : errors) s.error = std::max(s.error, e);
    for (const auto& view : milliseconds) s.milliseconds += spreadOf(view).median / static_cast<double>(milliseconds.size());
    return s;
  }
};

class Tuner {
 public:
  Tuner(Stand& stand, const app::TuneOptions& options, const Sweep& sweep, std::vector<std::uint32_t> cameras)
      : stand_(stand), options_(options), sweep_(sweep), cameras_(std::move(cameras)), goal_{options.maxError, options.budgetMs} {}

  Result<void> run() {
    if (auto made = makeCandidates(); !made) return made;
    if (candidates_.empty()) return failed("tune: no technique of the plugin in use can be tuned");
    for (std::size_t r = 0; r < std::size(kRounds); ++r) {
      std::fprintf(stderr, "tyndall: tune: round %zu of %zu, %zu candidates\n", r + 1, std::size(kRounds), candidates_.size());
      counts_.push_back(candidates_.size());
      if (auto done = measure(kRounds[r]); !done) return done;
      std::erase_if(candidates_, [&](const Candidate& c) {
        if (!c.failure.empty()) left_.push_back(c.text() + ": " + c.failure);
        return !c.failure.empty();
      });
      if (candidates_.empty()) return failed("tune: no candidate could be rendered: " + left_.front());
      std::vector<Score> scores;
      for (const Candidate& c : candidates_) scores.push_back(c.score());
      const auto order = kRounds[r].keep > 0 ? survivors(scores, goal_, kRounds[r].slack, kRounds[r].keep) : ranking(scores, goal_, 1);
      std::vector<Candidate> next;
      for (const std::size_t i : order) next.push_back(std::move(candidates_[i]));
      candidates_ = std::move(next);
    }
    return {};
  }

  const Candidate& best() const { return candidates_.front(); }
  const Goal& goal() const { return goal_; }

  std::string preset() {
    params::Table& table = stand_.session().table();
    (void)applySettings(table, best().settings);
    Json settings = Json::object();
    for (const auto& [id, value] : best().settings) {
      const params::Parameter& p = *table.find(id);
      if (p.type == params::Type::kEnum)
        settings[id] = value;
      else if (p.type == params::Type::kBool)
        settings[id] = table.value(id) != 0;
      else if (p.type == params::Type::kInt)
        settings[id] = static_cast<std::int64_t>(table.value(id));
      else
        settings[id] = table.value(id);
    }
    Json evidence;
    const gpu::DeviceInfo& device = stand_.session().device().info();
    const auto number = [](double v) { char t[32]; std::snprintf(t, sizeof t, "%.6g", v); return std::string(t); };
    evidence["command"] = "tyndall tune " + options_.level + (goal_.maxError ? " --max-error " + number(*goal_.maxError) : " --budget-ms " + number(*goal_.budgetMs)) +
                          cameraOptions() + " --size " + std::to_string(options_.size.first) + "x" + std::to_string(options_.size.second);
    evidence["device"] = device.name;
    evidence["driver"] = device.driver;
    evidence["bound"] = goal_.maxError ? Json{{"max_nrmse", *goal_.maxError}} : Json{{"budget_ms", *goal_.budgetMs}};
    evidence["milliseconds"] = best().score().milliseconds;
    evidence["nrmse"] = best().score().error;
    evidence["views"] = Json::array();
    for (std::size_t v = 0; v < cameras_.size(); ++v)
      evidence["views"].push_back({{"level", options_.level}, {"camera", cameras_[v]}, {"milliseconds", spreadOf(best().milliseconds[v]).median}, {"nrmse", best().errors[v]}});
    evidence["errors"] = "nRMSE against the ray-traced truth; pixels where rasteriser and ray tracer end on different surfaces count as right";
    evidence["error_size"] = {kRounds[std::size(kRounds) - 1].errorSize.first, kRounds[std::size(kRounds) - 1].errorSize.second};
    evidence["candidates_by_round"] = counts_;
    evidence["others_of_the_last_round"] = Json::array();
    for (std::size_t i = 1; i < candidates_.size(); ++i)
      evidence["others_of_the_last_round"].push_back({{"settings", candidates_[i].text()}, {"milliseconds", candidates_[i].score().milliseconds}, {"nrmse", candidates_[i].score().error}});
    Json varied = Json::array(), left = left_;
    for (const Knob& knob : sweep_.knobs) varied.push_back(knob.id);
    for (const std::string& text : notBuilt_) left.push_back(text);
    evidence["varied"] = varied;
    evidence["left_out"] = left;
    return Json{{"settings", settings}, {"evidence", evidence}}.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  }

 private:
  std::string cameraOptions() const {
    std::string text;
    for (const std::uint32_t camera : options_.cameras) text += " --camera " + std::to_string(camera);
    return text;
  }

  Result<void> makeCandidates() {
    const app::Catalogue& catalogue = stand_.catalogue();
    for (const params::Parameter& p : stand_.session().table().parameters()) {
      if (p.id != "volumetrics.technique") continue;
      for (std::size_t i = 0; i < p.choices.size(); ++i)
        if (!p.built.empty() && !p.built[i]) notBuilt_.push_back(p.choices[i] + ": not built yet");
    }
    for (const host::TechniqueInfo& technique : catalogue.effectPlugin().techniques()) {
      const auto reads = [&](const std::string& id) { return std::find(technique.reads.begin(), technique.reads.end(), id) != technique.reads.end(); };
      std::vector<Assignments> combinations{{{"volumetrics.technique", technique.id}}};
      for (const Knob& knob : sweep_.knobs) {
        if (!reads(knob.id)) continue;
        std::vector<Assignments> next;
        for (const Assignments& a : combinations)
          for (const std::string& value : knob.values) {
            next.push_back(a);
            next.back()[knob.id] = value;
            for (const std::string& id : knob.together) next.back()[id] = value;
          }
        combinations = std::move(next);
      }
      for (Assignments& a : combinations) {
        if (auto good = applySettings(stand_.session().table(), a); !good) return good;
        candidates_.push_back({technique.id, std::move(a), {}, {}, {}});
      }
    }
    return {};
  }

  Result<void> measure(const Round& round) {
    const app::Level& level = *stand_.session().level();
    truth::Medium medium;
    stand_.session().table().resetToDefaults();
    for (const auto& [id, target] : {std::pair{"medium.sigma_t", &medium.sigma_t}, {"medium.albedo", &medium.albedo}, {"medium.g", &medium.g}})
      if (stand_.session().table().find(id)) *target = stand_.session().table().value(id);
    const std::size_t views = round.everyView ? cameras_.size() : 1;
    for (Candidate& c : candidates_) c.milliseconds.assign(views, {}), c.errors.assign(views, 0);
    for (std::size_t v = 0; v < views; ++v) {
      auto camera = app::chooseCamera(level, cameras_[v], 0);
      if (!camera) return camera.error();
      auto truth = truthOf(level, cameras_[v], round.errorSize, 0, medium, round.truthSamples, {});
      if (!truth) return truth.error();
      for (Candidate& c : candidates_) {
        if (!c.failure.empty()) continue;
        Result<void> ok = stand_.render(c.settings, *camera, round.errorSize, 0, 2, true);
        if (ok) {
          auto errors = splitErrors(onSameSurface(stand_.scatter(), truth->scatter), truth->scatter, {}, {});
          if (errors) c.errors[v] = errors->all->nrmse; else ok = errors.error();
        }
        if (ok && round.keep == 0) ok = stand_.warmUp(c.settings, *camera, options_.size, 0);
        if (!ok) c.failure = ok.error().message;
      }
      // Interleaved, so that a drift of the machine meets all alike.
      for (int i = 0; i < round.timed; ++i)
        for (Candidate& c : candidates_) {
          if (!c.failure.empty()) continue;
          if (auto ok = stand_.render(c.settings, *camera, options_.size, 0, 2, false); !ok) {
            c.failure = ok.error().message;
            continue;
          }
          double own = 0;
          for (const render::PassTime& pass : stand_.passes())
            if (pass.owner == stand_.catalogue().effectPlugin().id()) own += pass.milliseconds;
          c.milliseconds[v].push_back(own);
        }
    }
    return {};
  }

  Stand& stand_;
  const app::TuneOptions& options_;
  const Sweep& sweep_;
  std::vector<std::uint32_t> cameras_;
  Goal goal_;
  std::vector<Candidate> candidates_;
  std::vector<std::size_t> counts_;
  std::vector<std::string> left_, notBuilt_;
};

}  // namespace
}  // namespace tyndall::bench

namespace tyndall::app {

Result<void> runTune(const TuneOptions& options) {
  auto path = findLevel(options.level);
  if (!path) return path.error();
  Outputs outputs;
  outputs.protect(*path);
  if (!options.out.empty())
    if (auto added = outputs.add("--out", options.out, ".json"); !added) return added;
  const std::filesystem::path file = executableFolder() / "tune" / "candidates.json";
  auto text = readText(file, 1u << 20);
  if (!text) return text.error();
  auto sweep = bench::readSweep(*text, file.string());
  if (!sweep) return sweep.error();
  auto catalogue = Catalogue::load(pluginFolder(options.pluginFolder));
  if (!catalogue) return catalogue.error();
  auto level = loadLevel(options.level);
  if (!level) return level.error();
  std::vector<std::uint32_t> cameras = options.cameras;
  if (cameras.empty())
    for (std::uint32_t i = 0; i < level->cameras(0).size(); ++i) cameras.push_back(i);
  for (const std::uint32_t camera : cameras)
    if (auto chosen = chooseCamera(*level, camera, 0); !chosen) return chosen.error();
  auto stand = bench::Stand::open(catalogue.take(), options.device);
  if (!stand) return stand.error();
  if (auto set = (*stand)->setLevel(level.take()); !set) return set;

  bench::Tuner tuner(**stand, options, *sweep, cameras);
  if (auto done = tuner.run(); !done) return done;
  const bench::Score score = tuner.best().score();
  char figures[96];
  std::snprintf(figures, sizeof figures, "nRMSE %.4g in %.4g ms", score.error, score.milliseconds);
  if (!tuner.goal().met(score)) return failed("tune: nothing that was tried meets the bound; nearest is " + std::string(figures) + " with " + tuner.best().text());
  const std::string preset = tuner.preset();
  if (auto done = outputs.write("--out", [&](const std::filesystem::path& p) { return writeTextAtomically(p, preset); }); !done) return done;
  if (auto done = outputs.commit(); !done) return done;
  std::fprintf(stderr, "tyndall: tune: %s: %s\n", figures, tuner.best().text().c_str());
  const std::string shown = options.out.empty() ? preset : options.out.string() + "\n";
  if (std::fwrite(shown.data(), 1, shown.size(), stdout) != shown.size() || std::fflush(stdout) != 0) return failed("standard output: cannot be written");
  return {};
}

}  // namespace tyndall::app
