#include "tune_search.hpp"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <limits>

#include "app/level.hpp"
#include "bench/error_split.hpp"
#include "bench/statistics.hpp"

namespace tyndall::bench {
namespace {

/// Degrees between the views that --turned adds at a camera.
constexpr double kTurn = 20;

constexpr Round kRounds[] = {{false, false, 1, 1.3, 16, 2}, {true, false, 2, 1.15, 5, 2}, {true, true, 5, 1.0, 0, 1}};

/// How many times as long as one that meets the bound a candidate may take, by the round before, and still be tried.
constexpr double kDear = 1.5;

}  // namespace

std::string Candidate::text() const {
  std::string all;
  for (const auto& [id, value] : settings) all += (all.empty() ? "" : " ") + id + "=" + value;
  return all;
}

double Candidate::worstError() const { return errors.empty() ? 0 : *std::max_element(errors.begin(), errors.end()); }

Score Candidate::score() const {
  Score s;
  s.error = worstError();
  for (const auto& view : milliseconds)
    if (!view.empty()) s.milliseconds = std::max(s.milliseconds, spreadOf(view).median);
  return s;
}

bool Candidate::timed() const {
  return std::any_of(milliseconds.begin(), milliseconds.end(), [](const auto& view) { return !view.empty(); });
}

TuneSearch::TuneSearch(Stand& stand, const app::TuneOptions& options)
    : stand_(stand), options_(options), goal_{options.maxError, options.budgetMs}, sought_(goal_) {
  for (auto* bound : {&sought_.maxError, &sought_.budgetMs})
    if (*bound) **bound *= 1 - options.margin;
}

Result<void> TuneSearch::chooseViews(const std::vector<std::uint32_t>& cameras) {
  const auto seesLight = [](const TunedView& view) { return view.lightOnScreen; };
  for (const std::uint32_t camera : cameras) {
    const auto first = static_cast<std::ptrdiff_t>(views_.size());
    for (std::uint32_t i = 0; i <= options_.turned; ++i) {
      auto view = viewOf(camera, {(i % 2 == 1 ? 1.0 : -1.0) * kTurn * ((i + 1) / 2) + 0.0, 0});
      if (!view) return view.error();
      views_.push_back(*view);
    }
    if (!options_.lightViews || std::any_of(views_.begin() + first, views_.end(), seesLight)) continue;
    const app::Level& level = *stand_.session().level();
    auto placed = app::chooseCamera(level, camera, 0);
    if (!placed) return placed.error();
    if (const auto turn = turnTowardsLight(level.lights(0), *placed, options_.size))
      views_.push_back({camera, *turn, true});
  }
  std::stable_partition(views_.begin(), views_.end(), seesLight);
  return {};
}

Result<void> TuneSearch::run(const Sweep& field) {
  field_ = field;
  std::vector<Candidate> before;
  std::swap(before, candidates_);
  if (auto made = makeCandidates(); !made) return made;
  if (candidates_.empty()) return failed("tune: no technique of the plugin in use can be tuned");
  for (std::size_t r = 0; r < std::size(kRounds); ++r) {
    std::fprintf(stderr, "tyndall: tune: round %zu of %zu, %zu candidates\n", r + 1, std::size(kRounds),
                 candidates_.size());
    counts_.push_back(candidates_.size());
    if (auto done = measure(kRounds[r]); !done) return done;
    std::erase_if(candidates_, [&](const Candidate& c) {
      if (!c.failure.empty()) left_.push_back(c.text() + ": " + c.failure);
      return !c.failure.empty();
    });
    if (candidates_.empty()) return failed("tune: no candidate could be rendered: " + left_.front());
    dear_ += std::erase_if(candidates_, [](const Candidate& c) { return c.dear; });
    if (std::all_of(candidates_.begin(), candidates_.end(), [](const Candidate& c) { return c.dropped; })) {
      take(ranking(scores(), sought_, 1));
      break;  // nothing of this field comes near the bound
    }
    take(kRounds[r].keep > 0 ? survivors(scores(), sought_, kRounds[r].slack, kRounds[r].keep)
                             : ranking(scores(), sought_, 1));
  }
  if (!before.empty()) {
    std::move(before.begin(), before.end(), std::back_inserter(candidates_));
    take(ranking(scores(), sought_, 1));
  }
  return {};
}

Result<void> TuneSearch::holdOut(std::uint32_t camera) {
  auto view = viewOf(camera, {});
  if (!view) return view.error();
  std::vector<Candidate> only{candidates_.front()};
  std::vector<TunedView> views{*view};
  std::swap(only, candidates_);
  std::swap(views, views_);
  Round round = kRounds[std::size(kRounds) - 1];
  round.hopeless = std::numeric_limits<double>::infinity();
  const Result<void> done = measure(round);
  std::swap(views, views_);
  std::swap(only, candidates_);
  if (!done) return done;
  if (!only.front().failure.empty())
    return failed("tune: camera " + std::to_string(camera) + ": " + only.front().failure);
  const bool searched = std::any_of(views_.begin(), views_.end(),
                                    [&](const TunedView& v) { return v.lightOnScreen == view->lightOnScreen; });
  held_.push_back({*view, only.front().score(), searched});
  return {};
}

Score TuneSearch::scoreOf(const Candidate& c) const {
  Score s = c.score();
  s.error = std::max(s.error, predictionLimit(c.errors).value_or(0) * (1 - options_.margin));
  return s;
}

std::vector<Score> TuneSearch::scores() const {
  std::vector<Score> scores;
  for (const Candidate& c : candidates_) scores.push_back(scoreOf(c));
  return scores;
}

void TuneSearch::take(const std::vector<std::size_t>& order) {
  std::vector<Candidate> next;
  for (const std::size_t i : order) next.push_back(std::move(candidates_[i]));
  candidates_ = std::move(next);
}

Result<void> TuneSearch::makeCandidates() {
  params::Table& table = stand_.session().table();
  if (const params::Parameter* p = table.find("volumetrics.technique"))
    for (std::size_t i = 0; i < p->choices.size(); ++i)
      if (!p->built.empty() && !p->built[i]) notBuilt_.insert(p->choices[i] + ": not built yet");
  // Parameters of the engine (shadow maps, say) bear on every technique.
  const auto engines = [&](const std::string& id) { return table.find(id) && table.find(id)->owner == "engine"; };
  for (const host::TechniqueInfo& technique : stand_.catalogue().effectPlugin().techniques()) {
    const auto reads = [&](const std::string& id) {
      return std::find(technique.reads.begin(), technique.reads.end(), id) != technique.reads.end();
    };
    read_.insert(technique.reads.begin(), technique.reads.end());
    varied_.insert("volumetrics.technique");
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
      if (auto good = applySettings(table, a); !good) return good;
      candidates_.push_back({technique.id, std::move(a), {}, {}, {}});
    }
  }
  return {};
}

Result<TunedView> TuneSearch::viewOf(std::uint32_t camera, Turn turn) {
  const app::Level& level = *stand_.session().level();
  auto placed = app::chooseCamera(level, camera, 0);
  if (!placed) return placed.error();
  const auto lights = lightsInPicture(level.lights(0), turned(*placed, turn), options_.size);
  return TunedView{camera, turn, insidePicture(lights, options_.size)};
}

Result<void> TuneSearch::measure(const Round& round) {
  const std::uint32_t part = round.wholeErrors ? 1 : 2;
  const Size errorSize{std::max(1u, field_.errorSize.first / part), std::max(1u, field_.errorSize.second / part)};
  auto views = prepare(round, errorSize);
  if (!views) return views.error();
  measureErrors(round, *views, errorSize);
  measureTimes(round, *views);
  return {};
}

Result<std::vector<TuneSearch::Prepared>> TuneSearch::prepare(const Round& round, Size errorSize) {
  const app::Level& level = *stand_.session().level();
  params::Table& table = stand_.session().table();
  table.resetToDefaults();
  truth::Medium medium;
  for (const auto& [id, target] :
       {std::pair{"medium.sigma_t", &medium.sigma_t}, {"medium.albedo", &medium.albedo}, {"medium.g", &medium.g}})
    if (table.find(id)) *target = table.value(id);
  const std::uint32_t samples = std::max(1u, field_.truthSamples / (round.wholeErrors ? 1 : 2));
  std::vector<Prepared> views;
  for (std::size_t v = 0; v < (round.everyView ? views_.size() : 1); ++v) {
    auto camera = app::chooseCamera(level, views_[v].camera, 0);
    if (!camera) return camera.error();
    auto truth = truthOf(level, views_[v].camera, views_[v].turn, errorSize, 0, medium, samples, {});
    if (!truth) return truth.error();
    views.push_back({turned(*camera, views_[v].turn), truth.take()});
  }
  return views;
}

void TuneSearch::measureErrors(const Round& round, const std::vector<Prepared>& views, Size errorSize) {
  for (Candidate& c : candidates_) {
    c.known = c.score().milliseconds;
    c.milliseconds.clear();
    c.errors.clear();
    c.dropped = c.dear = false;
  }
  std::stable_sort(candidates_.begin(), candidates_.end(),
                   [](const Candidate& x, const Candidate& y) { return x.known < y.known; });
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
        if (errors)
          c.errors.push_back(errors->all->nrmse);
        else
          ok = errors.error();
      }
      if (!ok) c.failure = ok.error().message;
      c.dropped = sought_.maxError && !sought_.met(c.score(), round.hopeless);
    }
    const bool good = round.everyView && sought_.maxError && !c.out() && sought_.met(scoreOf(c), 1 / round.slack);
    if (good) meets = std::min(meets, c.known);
  }
}

void TuneSearch::measureTimes(const Round& round, const std::vector<Prepared>& views) {
  const std::string& plugin = stand_.catalogue().effectPlugin().id();
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
          if (pass.owner == plugin) own += pass.milliseconds;
        c.milliseconds.back().push_back(own);
      }
    for (Candidate& c : candidates_) c.dropped = c.dropped || !sought_.met(c.score(), round.hopeless);
  }
}

}  // namespace tyndall::bench
