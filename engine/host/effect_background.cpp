// A new layout made beside the frames: they go on with the old one until everything of the new one is there.
//
// 1. begin(): the plugin's other instance answers for the new values; layout, plans and steps come of it.
// 2. The builder's thread makes the pipelines and, where the driver compiles late, has them compiled.
// 3. goOn(): there, this device's driver then fetches the code from its cache, a few pipelines a frame.
// 4. swap(): the next frame is drawn with the new layout.
#include <algorithm>

#include "base/log.hpp"
#include "effect_state.hpp"

namespace tyndall::host {

namespace {

// Fetching one pipeline's code takes llvmpipe 5 to 30 ms on one core: about as much as a whole frame of a small
// picture.
constexpr std::size_t kFetchedPerFrame = 1;

}  // namespace

PluginEffect::State::~State() {
  if (second) plugin.state().destroy(second);
}

TyInstance* PluginEffect::State::spare() {
  Plugin::State& p = plugin.state();
  if (built->instance != p.instance) return p.instance;
  if (!second) {
    p.log.hold();
    second = p.create();
    if (second) p.log.letGo();
  }
  return second;
}

void PluginEffect::State::forgetComing() {
  if (!coming) return;
  builder.cancel();
  coming.reset();
}

Result<void> PluginEffect::State::updateInBackground(const Structure& wanted, const render::EffectInput& input) {
  if (asked->structure.sameLayout(wanted)) {
    askedNext.reset();
  } else if (!askedNext || !askedNext->structure.sameLayout(wanted)) {
    forgetComing();
    askedNext.reset();
    TyInstance* const instance = spare();
    if (!instance) return failed("could not be set up a second time: its create failed" + plugin.state().log.reason());
    auto layout = ask(instance, wanted);
    if (!layout) return layout.error();
    askedNext = Asked{wanted, automaticsOf(wanted, *layout)};
  }
  Structure structure = resolved(wanted, (askedNext ? *askedNext : *asked).automatics);
  if (built->structure.sameLayout(structure)) {
    forgetComing();
    if (askedNext) asked = *std::exchange(askedNext, std::nullopt);
    return {};
  }
  if (!coming || !coming->built->structure.sameLayout(structure))
    if (auto begun = begin(std::move(structure), input); !begun) return begun;
  return goOn(input);
}

Result<void> PluginEffect::State::keepUp(const Structure& wanted, const render::EffectInput& input) {
  if (built->structure.sameSurroundings(wanted)) return {};
  Structure structure = wanted, drawn = wanted;
  for (std::size_t i = 0; i < wanted.values.size(); ++i)
    if (wanted.structural[i])
      structure.values[i] = asked->structure.values[i], drawn.values[i] = built->structure.values[i];
  TyInstance* const instance = built->instance;
  built.reset();  // before the new one is made: both at once may not fit
  auto layout = ask(instance, structure);
  if (!layout) return layout.error();
  asked = Asked{structure, automaticsOf(structure, *layout)};
  return build(instance, std::move(drawn), input);
}

/// Kinds of images that the pass's pipeline has not been compiled for.
std::vector<Scratch> PluginEffect::State::newScratches(const Layout& layout, std::uint32_t pass,
                                                       const PipelinePlan& plan, const std::vector<PassRun>& runs,
                                                       const render::EffectInput& input) const {
  std::vector<Scratch> found;
  std::set<std::string> seen;
  if (const auto known = compiled.find(plan.key); known != compiled.end()) seen = known->second;
  for (const PassRun& run : runs) {
    if (run.pass != pass) continue;
    Scratch scratch = scratchOf(input, layout, layout.passes[pass], run.light);
    if (seen.insert(scratch.key()).second) found.push_back(std::move(scratch));
  }
  return found;
}

void PluginEffect::State::noteCompiled(const Built& of, const std::vector<std::optional<PipelinePlan>>& plans,
                                       const render::EffectInput& input) {
  std::erase_if(compiled, [this](const auto& entry) { return !pipelines.has(entry.first); });
  if (!background || !device.info().isCpu) return;
  for (std::uint32_t pass = 0; pass < plans.size(); ++pass)
    if (plans[pass])
      for (const Scratch& scratch : newScratches(of.layout, pass, *plans[pass], of.runs, input))
        compiled[plans[pass]->key].insert(scratch.key());
}

Result<void> PluginEffect::State::begin(Structure structure, const render::EffectInput& input) {
  forgetComing();
  TyInstance* const instance = spare();
  if (!instance) return failed("could not be set up a second time: its create failed" + plugin.state().log.reason());
  auto next = describe(instance, std::move(structure), static_cast<bool>(input.drawCasters));
  if (!next) return next.error();
  auto plans = pipelines.plan((*next)->layout);
  if (!plans) return plans.error();
  Coming now{next.take(), plans.take(), {}, {}};
  for (std::uint32_t pass = 0; pass < now.plans.size(); ++pass) {
    if (!now.plans[pass]) continue;
    const PipelinePlan& plan = *now.plans[pass];
    if (PipelinePtr kept = pipelines.find(plan.key)) now.there[plan.key] = std::move(kept);
    std::vector<Scratch> scratches;
    if (device.info().isCpu) scratches = newScratches(now.built->layout, pass, plan, now.built->runs, input);
    const auto same = std::find_if(now.steps.begin(), now.steps.end(),
                                   [&](const BuildStep& step) { return step.plan.key == plan.key; });
    if (same != now.steps.end())
      same->warmUps.insert(same->warmUps.end(), scratches.begin(), scratches.end());
    else if (!now.there.contains(plan.key) || !scratches.empty())
      now.steps.push_back({plan, !now.there.contains(plan.key), std::move(scratches)});
  }
  now.made = now.steps.empty();
  if (!now.made) builder.start(now.steps);
  coming = std::move(now);
  return {};
}

Result<void> PluginEffect::State::goOn(const render::EffectInput& input) {
  if (!coming->made) {
    if (!builder.done()) return {};
    auto made = builder.take();
    if (!made) return made.error();
    coming->there.merge(*made);
    coming->made = true;
  }
  bool fetched = false;
  for (std::size_t n = 0; n < kFetchedPerFrame && coming->warmed < coming->steps.size(); ++n, ++coming->warmed) {
    const BuildStep& step = coming->steps[coming->warmed];
    for (const Scratch& scratch : step.warmUps) {
      compiled[step.plan.key].insert(scratch.key());
      auto made = WarmUp::create(device, scratch);
      if (!made) {
        log::debug("not compiled ahead: " + made.error().message);
        continue;
      }
      fetched = true;
      const PipelinePtr pipeline = coming->there.at(step.plan.key);
      const std::string name = step.plan.graphics ? step.plan.fullScreen.name : step.plan.compute.name;
      input.graph.pass("compile " + name, plugin.id())
          .keep()
          .run([pipeline, warmUp = std::shared_ptr<WarmUp>(made.take())](render::PassContext& context) {
            warmUp->record(context.commands(), *pipeline);
          });
    }
  }
  if (fetched) return {};  // so that this frame does not draw with the new layout besides
  return swap();
}

Result<void> PluginEffect::State::swap() {
  if (auto furnished = furnish(*coming->built); !furnished) return furnished;
  coming->built->pipelines = pipelines.adopt(coming->plans, std::move(coming->there));
  std::erase_if(compiled, [this](const auto& entry) { return !pipelines.has(entry.first); });
  before.emplace(*asked, built);
  built = std::move(coming->built);
  if (askedNext) asked = *std::exchange(askedNext, std::nullopt);
  coming.reset();
  reset = true;
  return {};
}

void PluginEffect::buildInBackground(bool on) {
  State& s = *state_;
  s.background = on;
  if (on) return;
  s.forgetComing();
  s.askedNext.reset();
}

PluginEffect::Background PluginEffect::background() const {
  const State& s = *state_;
  if (s.redraw) return Background::kReady;
  if (!s.coming) return Background::kIdle;
  return s.coming->made || s.builder.done() ? Background::kReady : Background::kBuilding;
}

bool PluginEffect::readsShadowMoments() const {
  const auto reads = [](const std::shared_ptr<Built>& of) {
    return of && std::any_of(of->layout.passes.begin(), of->layout.passes.end(), [](const LayoutPass& pass) {
             return std::any_of(pass.bindings.begin(), pass.bindings.end(),
                                [](const TyBinding& b) { return b.source == TY_SOURCE_SHADOW_MOMENTS; });
           });
  };
  return reads(state_->built) || (state_->coming && reads(state_->coming->built));
}

void PluginEffect::frameSubmitted() {
  state_->open = false;
  state_->before.reset();
}

void PluginEffect::frameDropped(const Error& reason) {
  State& s = *state_;
  if (!std::exchange(s.open, false)) return;
  s.pending.pop_back();
  s.refs.reset();
  s.reset = true;
  if (!s.before) return;
  s.failure = failed("plugin '" + s.plugin.id() + "': " + reason.message + "; the settings before go on");
  s.refused = s.asked->structure;
  s.asked = std::move(s.before->first);
  s.built = std::move(s.before->second);
  s.before.reset();
  s.redraw = true;
}

}  // namespace tyndall::host
