// tyndall tune: successive halving over measured settings.
#include "app/bench_options.hpp"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <limits>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "app/catalogue.hpp"
#include "app/level.hpp"
#include "app/outputs.hpp"
#include "base/file.hpp"
#include "bench/error_split.hpp"
#include "bench/halving.hpp"
#include "bench/stand.hpp"
#include "bench/statistics.hpp"
#include "bench/truths.hpp"

namespace tyndall::bench {
namespace {

using Json = nlohmann::ordered_json;

/// The first and cheap candidates, and those for bounds that they do not meet.
constexpr const char* kFields[] = {"candidates.json", "stronger.json"};

/// Degrees between the views that --turned adds at a camera.
constexpr double kTurn = 20;

/// A round: how many views, whether errors are taken at the field's size and with its truth or with half of both, how many frames are timed,
/// and how many candidates go on.
struct Round {
  bool everyView, wholeErrors;
  int timed;
  double slack;
  std::size_t keep;  ///< at most, of those that go on; 0: the last round
  double hopeless;   ///< a view on which a candidate misses the bound by this factor is its last of the round
};
constexpr Round kRounds[] = {{false, false, 1, 1.3, 16, 2}, {true, false, 2, 1.15, 5, 2}, {true, true, 5, 1.0, 0, 1}};

/// How many times as long as one that meets the bound a candidate may take, by the round before, and still be tried.
constexpr double kDear = 1.5;

/// A camera of the level and how it is turned.
struct TunedView {
  std::uint32_t camera;
  Turn turn;
  bool lightOnScreen = false;
};

struct Candidate {
  std::string technique;
  Assignments settings;
  std::vector<std::vector<double>> milliseconds;  ///< of each view that was measured
  std::vector<double> errors;                     ///< of each view that was measured
  double known = 0;                               ///< ms that the round before measured
  bool dropped = false;                           ///< out of the round before its last view
  bool dear = false;                              ///< because another meets the bound in far less time
  std::string failure;
  std::string text() const {
    std::string all;
    for (const auto& [id, value] : settings) all += (all.empty() ? "" : " ") + id + "=" + value;
    return all;
  }
  double worstError() const { return errors.empty() ? 0 : *std::max_element(errors.begin(), errors.end()); }
  /// The worst error and median time of the views that were measured.
  Score score() const {
    Score s;
    s.error = worstError();
    for (const auto& view : milliseconds)
      if (!view.empty()) s.milliseconds = std::max(s.milliseconds, spreadOf(view).median);
    return s;
  }
  bool timed() const { return std::any_of(milliseconds.begin(), milliseconds.end(), [](const auto& view) { return !view.empty(); }); }  ///< who misses the error is not
  bool out() const { return dropped || !failure.empty(); }
};

class Tuner {
 public:
  Tuner(Stand& stand, const app::TuneOptions& options)
      : stand_(stand), options_(options), goal_{options.maxError, options.budgetMs}, sought_(goal_) {
    for (auto* bound : {&sought_.maxError, &sought_.budgetMs})
      if (*bound) **bound *= 1 - options.margin;
  }

  /// The views to search on: `cameras`, each also turned as asked for. A camera that sees no light so gets one more view, turned to one, unless that is not
  /// wanted. Those with a light on the screen come first: they are the hardest, and who fails there need not be tried on the others.
  Result<void> chooseViews(const std::vector<std::uint32_t>& cameras) {
    for (const std::uint32_t camera : cameras) {
      const std::size_t first = views_.size();
      for (std::uint32_t i = 0; i <= options_.turned; ++i) {
        auto view = viewOf(camera, {(i % 2 == 1 ? 1.0 : -1.0) * kTurn * ((i + 1) / 2) + 0.0, 0});
        if (!view) return view.error();
        views_.push_back(*view);
      }
      if (!options_.lightViews || std::any_of(views_.begin() + static_cast<std::ptrdiff_t>(first), views_.end(), [](const TunedView& v) { return v.lightOnScreen; })) continue;
      auto placed = app::chooseCamera(*stand_.session().level(), camera, 0);
      if (!placed) return placed.error();
      if (const auto turn = turnTowardsLight(stand_.session().level()->lights(0), *placed, options_.size)) views_.push_back({camera, *turn, true});
    }
    std::stable_partition(views_.begin(), views_.end(), [](const TunedView& v) { return v.lightOnScreen; });
    return {};
  }

  /// Searches one field of candidates. Afterwards best() is the best of all fields so far.
  Result<void> run(const Sweep& field) {
    field_ = field;
    std::vector<Candidate> before;
    std::swap(before, candidates_);
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
      dear_ += std::erase_if(candidates_, [](const Candidate& c) { return c.dear; });
      std::vector<Score> scores;
      for (const Candidate& c : candidates_) scores.push_back(scoreOf(c));
      if (std::all_of(candidates_.begin(), candidates_.end(), [](const Candidate& c) { return c.dropped; })) {
        take(ranking(scores, sought_, 1));
        break;  // nothing of this field comes near the bound
      }
      take(kRounds[r].keep > 0 ? survivors(scores, sought_, kRounds[r].slack, kRounds[r].keep) : ranking(scores, sought_, 1));
    }
    if (!before.empty()) {
      std::move(before.begin(), before.end(), std::back_inserter(candidates_));
      std::vector<Score> scores;
      for (const Candidate& c : candidates_) scores.push_back(scoreOf(c));
      take(ranking(scores, sought_, 1));
    }
    return {};
  }

  /// The best on a view that the search did not see.
  Result<void> holdOut(std::uint32_t camera) {
    Candidate probe = candidates_.front();
    std::vector<Candidate> only{std::move(probe)};
    std::swap(only, candidates_);
    auto view = viewOf(camera, {});
    if (!view) return view.error();
    std::vector<TunedView> views{*view};
    std::swap(views, views_);
    Round round = kRounds[std::size(kRounds) - 1];
    round.hopeless = std::numeric_limits<double>::infinity();
    const Result<void> done = measure(round);
    std::swap(views, views_);
    std::swap(only, candidates_);
    if (!done) return done;
    if (!only.front().failure.empty()) return failed("tune: camera " + std::to_string(camera) + ": " + only.front().failure);
    const bool searched = std::any_of(views_.begin(), views_.end(), [&](const TunedView& v) { return v.lightOnScreen == view->lightOnScreen; });
    held_.push_back({*view, only.front().score(), searched});
    return {};
  }
  struct Held {
    TunedView view;
    Score score;
    bool kindSearched;  ///< whether a view of the search is like it in having a light on the screen, or none
  };
  const std::vector<Held>& held() const { return held_; }

  bool met() const { return sought_.met(scoreOf(best())); }

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
                          cameraOptions() + (options_.candidates.empty() ? "" : " --candidates " + options_.candidates.string()) + " --margin " + number(options_.margin) + " --size " + std::to_string(options_.size.first) + "x" + std::to_string(options_.size.second);
    evidence["device"] = device.name;
    evidence["driver"] = device.driver;
    evidence["bound"] = goal_.maxError ? Json{{"max_nrmse", *goal_.maxError}} : Json{{"budget_ms", *goal_.budgetMs}};
    evidence["margin"] = options_.margin;
    evidence["times"] = "of the plugin's passes, without the engine's shadow maps; the worst view's median";
    evidence["milliseconds"] = best().score().milliseconds;
    evidence["nrmse"] = best().worstError();
    evidence["nrmse_of_unseen_views"] = limitOf(best());
    evidence["unseen_views"] = "19 of 20 are to stay under this, by the spread of the views that were searched; null: too few of them";
    evidence["views"] = Json::array();
    for (std::size_t v = 0; v < views_.size(); ++v)
      evidence["views"].push_back({{"level", options_.level}, {"camera", views_[v].camera}, {"turned_degrees", views_[v].turn.yaw}, {"raised_degrees", views_[v].turn.pitch}, {"light_on_screen", views_[v].lightOnScreen}, {"milliseconds", spreadOf(best().milliseconds[v]).median}, {"nrmse", best().errors[v]}});
    evidence["hold_out"] = Json::array();
    for (const auto& [view, score, kindSearched] : held_)
      evidence["hold_out"].push_back({{"level", options_.level}, {"camera", view.camera}, {"light_on_screen", view.lightOnScreen}, {"milliseconds", score.milliseconds}, {"nrmse", score.error}, {"met", goal_.met(score)}});
    evidence["errors"] = "nRMSE against the ray-traced truth; pixels where rasteriser and ray tracer end on different surfaces count as right";
    evidence["error_size"] = {field_.errorSize.first, field_.errorSize.second};
    evidence["candidates_by_round"] = counts_;
    evidence["candidates_too_dear"] = dear_;
    evidence["others_of_the_last_round"] = Json::array();
    for (std::size_t i = 1; i < candidates_.size(); ++i)
      evidence["others_of_the_last_round"].push_back({{"settings", candidates_[i].text()}, {"milliseconds", candidates_[i].timed() ? Json(candidates_[i].score().milliseconds) : Json()}, {"nrmse", candidates_[i].worstError()}, {"nrmse_of_unseen_views", limitOf(candidates_[i])}, {"views", candidates_[i].errors.size()}});
    Json varied = Json::array(), left = left_;
    for (const std::string& id : varied_) varied.push_back(id);
    for (const std::string& text : notBuilt_) left.push_back(text);
    table.resetToDefaults();
    for (const std::string& id : read_)
      if (!varied_.contains(id) && !id.starts_with("medium.") && table.find(id)) left.push_back(id + ": kept at " + params::toText(*table.find(id), table.value(id)));
    evidence["varied"] = varied;
    evidence["left_out"] = left;
    return Json{{"settings", settings}, {"evidence", evidence}}.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  }

 private:
  /// Of a bound on the error two things are asked: that the worst view keeps clear of it by the margin, and that a view which the search has not seen
  /// is to be under it.
  Score scoreOf(const Candidate& c) const {
    Score s = c.score();
    s.error = std::max(s.error, predictionLimit(c.errors).value_or(0) * (1 - options_.margin));
    return s;
  }
  static Json limitOf(const Candidate& c) {
    const auto limit = predictionLimit(c.errors);
    return limit ? Json(*limit) : Json();
  }

  std::string cameraOptions() const {
    std::string text;
    for (const std::uint32_t camera : options_.cameras) text += " --camera " + std::to_string(camera);
    if (options_.turned > 0) text += " --turned " + std::to_string(options_.turned);
    if (!options_.lightViews) text += " --no-light-views";
    for (const std::uint32_t camera : options_.holdOut) text += " --hold-out " + std::to_string(camera);
    return text;
  }

  void take(const std::vector<std::size_t>& order) {
    std::vector<Candidate> next;
    for (const std::size_t i : order) next.push_back(std::move(candidates_[i]));
    candidates_ = std::move(next);
  }

  Result<void> makeCandidates() {
    const app::Catalogue& catalogue = stand_.catalogue();
    params::Table& table = stand_.session().table();
    for (const params::Parameter& p : stand_.session().table().parameters()) {
      if (p.id != "volumetrics.technique") continue;
      for (std::size_t i = 0; i < p.choices.size(); ++i)
        if (!p.built.empty() && !p.built[i]) notBuilt_.insert(p.choices[i] + ": not built yet");
    }
    for (const host::TechniqueInfo& technique : catalogue.effectPlugin().techniques()) {
      const auto reads = [&](const std::string& id) { return std::find(technique.reads.begin(), technique.reads.end(), id) != technique.reads.end(); };
      read_.insert(technique.reads.begin(), technique.reads.end());
      varied_.insert("volumetrics.technique");
      // Parameters of the engine (shadow maps, say) bear on every technique.
      const auto engines = [&](const std::string& id) { return table.find(id) && table.find(id)->owner == "engine"; };
      std::vector<Assignments> combinations{field_.settings};
      combinations.front()["volumetrics.technique"] = technique.id;
      for (const auto& [id, value] : field_.settings) varied_.insert(id);
      for (const Knob& knob : field_.knobs) {
        if (!reads(knob.id) && !engines(knob.id)) continue;
        varied_.insert(knob.id);
        varied_.insert(knob.together.begin(), knob.together.end());
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

  Result<TunedView> viewOf(std::uint32_t camera, Turn turn) {
    const app::Level& level = *stand_.session().level();
    auto placed = app::chooseCamera(level, camera, 0);
    if (!placed) return placed.error();
    return TunedView{camera, turn, insidePicture(lightsInPicture(level.lights(0), turned(*placed, turn), options_.size), options_.size)};
  }

  Result<void> measure(const Round& round) {
    const app::Level& level = *stand_.session().level();
    truth::Medium medium;
    stand_.session().table().resetToDefaults();
    for (const auto& [id, target] : {std::pair{"medium.sigma_t", &medium.sigma_t}, {"medium.albedo", &medium.albedo}, {"medium.g", &medium.g}})
      if (stand_.session().table().find(id)) *target = stand_.session().table().value(id);
    const std::uint32_t part = round.wholeErrors ? 1 : 2;
    const Size errorSize{std::max(1u, field_.errorSize.first / part), std::max(1u, field_.errorSize.second / part)};
    struct Prepared {
      scene::CameraView camera;
      Truth truth;
    };
    std::vector<Prepared> views;
    for (std::size_t v = 0; v < (round.everyView ? views_.size() : 1); ++v) {
      auto camera = app::chooseCamera(level, views_[v].camera, 0);
      if (!camera) return camera.error();
      auto truth = truthOf(level, views_[v].camera, views_[v].turn, errorSize, 0, medium, std::max(1u, field_.truthSamples / part), {});
      if (!truth) return truth.error();
      views.push_back({turned(*camera, views_[v].turn), truth.take()});
    }

    // Errors, the cheapest by what is known first: once one meets the bound everywhere, those that are dearer by far are not tried.
    for (Candidate& c : candidates_) c.known = c.score().milliseconds, c.milliseconds.clear(), c.errors.clear(), c.dropped = c.dear = false;
    std::stable_sort(candidates_.begin(), candidates_.end(), [](const Candidate& x, const Candidate& y) { return x.known < y.known; });
    double meets = std::numeric_limits<double>::infinity();
    for (Candidate& c : candidates_) {
      if (c.known > kDear * meets) {
        c.dropped = c.dear = true;
        continue;
      }
      for (std::size_t v = 0; v < views.size() && !c.out(); ++v) {
        Result<void> ok = stand_.render(c.settings, views[v].camera, errorSize, 0, 2, true);
        if (ok) {
          const image::FloatImage& reference = views[v].truth.scatter;
          auto errors = splitErrors(onSameSurface(stand_.scatter(), reference), reference, {}, {});
          if (errors) c.errors.push_back(errors->all->nrmse); else ok = errors.error();
        }
        if (!ok) c.failure = ok.error().message;
        c.dropped = sought_.maxError && !sought_.met(c.score(), round.hopeless);
      }
      if (round.everyView && sought_.maxError && !c.out() && sought_.met(scoreOf(c), 1 / round.slack)) meets = std::min(meets, c.known);
    }
    // Times, interleaved, so that a drift of the machine meets all alike.
    for (const Prepared& view : views) {
      for (Candidate& c : candidates_) {
        if (c.out()) continue;
        c.milliseconds.emplace_back();
        if (round.keep > 0) continue;
        if (auto ok = stand_.warmUp(c.settings, view.camera, options_.size, 0); !ok) c.failure = ok.error().message;
      }
      for (int i = 0; i < round.timed; ++i)
        for (Candidate& c : candidates_) {
          if (c.out()) continue;
          if (auto ok = stand_.render(c.settings, view.camera, options_.size, 0, 2, false); !ok) {
            c.failure = ok.error().message;
            continue;
          }
          double own = 0;
          for (const render::PassTime& pass : stand_.passes())
            if (pass.owner == stand_.catalogue().effectPlugin().id()) own += pass.milliseconds;
          c.milliseconds.back().push_back(own);
        }
      for (Candidate& c : candidates_) c.dropped = c.dropped || !sought_.met(c.score(), round.hopeless);
    }
    return {};
  }

  Stand& stand_;
  const app::TuneOptions& options_;
  Sweep field_;
  std::vector<TunedView> views_;
  Goal goal_, sought_;  ///< as asked for, and with the margin
  std::vector<Candidate> candidates_;
  std::vector<std::size_t> counts_;
  std::size_t dear_ = 0;
  std::vector<Held> held_;
  std::vector<std::string> left_;
  std::set<std::string> notBuilt_, read_, varied_;
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
  std::vector<bench::Sweep> fields;
  std::vector<std::filesystem::path> files;
  if (options.candidates.empty())
    for (const char* name : bench::kFields) files.push_back(executableFolder() / "tune" / name);
  else
    files.push_back(options.candidates);
  for (const std::filesystem::path& file : files) {
    auto text = readText(file, 1u << 20);
    if (!text) return text.error();
    auto field = bench::readSweep(*text, file.string());
    if (!field) return field.error();
    fields.push_back(field.take());
  }
  auto catalogue = Catalogue::load(pluginFolder(options.pluginFolder));
  if (!catalogue) return catalogue.error();
  auto level = loadLevel(options.level);
  if (!level) return level.error();
  std::vector<std::uint32_t> cameras = options.cameras;
  const auto heldOut = [&](std::uint32_t camera) { return std::find(options.holdOut.begin(), options.holdOut.end(), camera) != options.holdOut.end(); };
  if (cameras.empty())
    for (std::uint32_t i = 0; i < level->cameras(0).size(); ++i)
      if (!heldOut(i)) cameras.push_back(i);
  if (cameras.empty()) return badCall("--hold-out: no camera of '" + options.level + "' is left to tune on");
  for (const auto* list : {&options.cameras, &options.holdOut})
    for (const std::uint32_t camera : *list)
      if (auto chosen = chooseCamera(*level, camera, 0); !chosen) return chosen.error();
  for (const std::uint32_t camera : cameras)
    if (heldOut(camera)) return badCall("--hold-out: camera " + std::to_string(camera) + " is tuned on, by --camera; a view is one or the other");
  auto stand = bench::Stand::open(catalogue.take(), options.device);
  if (!stand) return stand.error();
  if (auto set = (*stand)->setLevel(level.take()); !set) return set;

  bench::Tuner tuner(**stand, options);
  if (auto chosen = tuner.chooseViews(cameras); !chosen) return chosen;
  for (const bench::Sweep& field : fields) {
    if (auto done = tuner.run(field); !done) return done;
    if (tuner.met()) break;
  }
  const bench::Score score = tuner.best().score();
  char figures[128];
  int length = std::snprintf(figures, sizeof figures, "nRMSE %.4g", score.error);
  if (const auto limit = bench::predictionLimit(tuner.best().errors))
    length += std::snprintf(figures + length, sizeof figures - static_cast<std::size_t>(length), " (of unseen views up to %.4g)", *limit);
  if (tuner.best().timed()) std::snprintf(figures + length, sizeof figures - static_cast<std::size_t>(length), " in %.4g ms", score.milliseconds);
  if (!tuner.met())
    return failed("tune: nothing that was tried meets the bound with its margin; nearest is " + std::string(figures) + " with " + tuner.best().text());
  for (const std::uint32_t camera : options.holdOut)
    if (auto done = tuner.holdOut(camera); !done) return done;
  for (const auto& [view, held, kindSearched] : tuner.held()) {
    char text[96];
    std::snprintf(text, sizeof text, "nRMSE %.4g in %.4g ms", held.error, held.milliseconds);
    const char* other = kindSearched ? "" : view.lightOnScreen ? "; a light is on the screen there, and on no view that was searched" : "; no light is on the screen there, and one is on every view that was searched";
    std::fprintf(stderr, "tyndall: %stune: camera %u, which was held out: %s%s%s\n", tuner.goal().met(held) ? "" : "warning: ", view.camera, text,
                 tuner.goal().met(held) ? "" : ", outside the bound", other);
  }
  const std::string preset = tuner.preset();
  if (auto done = outputs.write("--out", [&](const std::filesystem::path& p) { return writeTextAtomically(p, preset); }); !done) return done;
  if (auto done = outputs.commit(); !done) return done;
  std::fprintf(stderr, "tyndall: tune: %s: %s\n", figures, tuner.best().text().c_str());
  const std::string shown = options.out.empty() ? preset : options.out.string() + "\n";
  if (std::fwrite(shown.data(), 1, shown.size(), stdout) != shown.size() || std::fflush(stdout) != 0) return failed("standard output: cannot be written");
  return {};
}

}  // namespace tyndall::app
