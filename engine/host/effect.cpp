// One plugin as an Effect: layout, prepare, passes, in that order each frame.
#include "base/assert.hpp"
#include "base/log.hpp"
#include "effect_state.hpp"

namespace tyndall::host {
namespace {

/// A role of a later version is none that the host knows.
render::ViewRole roleOf(std::uint32_t role) {
  switch (role) {
    case TY_VIEW_ROWS: return render::ViewRole::kRows;
    case TY_VIEW_ROW_DEPTHS: return render::ViewRole::kRowDepths;
    case TY_VIEW_ROW_PLACE: return render::ViewRole::kRowPlace;
    case TY_VIEW_LIGHT_RAY_START: return render::ViewRole::kLightRayStart;
    case TY_VIEW_LIGHT_RAY_END: return render::ViewRole::kLightRayEnd;
    case TY_VIEW_REFERENCE: return render::ViewRole::kReference;
    case TY_VIEW_WALK_RANKS: return render::ViewRole::kWalkRanks;
    case TY_VIEW_WALK_LEVEL: return render::ViewRole::kWalkLevel;
    case TY_VIEW_WALK_LEVEL_ACROSS: return render::ViewRole::kWalkLevelAcross;
    default: return render::ViewRole::kPlain;
  }
}

}  // namespace

Result<std::unique_ptr<PluginEffect>> PluginEffect::create(gpu::Device& device, Plugin& plugin,
                                                           const params::Table& table) {
  for (const params::Parameter& p : plugin.parameters())
    TY_ASSERT(table.find(p.id) != nullptr, "the table lacks " + p.id + ": add the plugin's parameters first");
  std::unique_ptr<PluginEffect> effect(new PluginEffect);
  effect->state_ = std::make_unique<State>(device, plugin, table);
  return effect;
}

PluginEffect::~PluginEffect() = default;

Result<render::ImageRef> PluginEffect::addPasses(const render::EffectInput& input) {
  State& s = *state_;
  s.refs.reset();
  s.reset = s.reset || input.reset;
  // Nobody reports finished frames: forget the oldest, its slot is about to be used again.
  if (s.pending.size() >= kFrameSlots) s.pending.pop_front();
  State::Pending& pending = s.pending.emplace_back();
  pending.slot = static_cast<std::uint32_t>(s.frame++ % kFrameSlots);

  s.open = true;
  s.before.reset();
  s.redraw = false;
  if (!s.bring(makeStructure(input, s.plugin.parameters(), s.table), input)) return render::ImageRef{};
  if (s.built->layout.passes.empty() || !s.prepare(input)) return render::ImageRef{};

  s.built->uniforms.commit(pending.slot);
  s.refs = addFramePasses(input, s.built, s.plugin.id(), pending.slot);
  pending.built = s.built;
  pending.refs = s.refs;
  for (const Automatic& a : s.asked->automatics) {
    const auto choice = s.tuner.current(a.key, a.tunable.variants);
    if (choice.settled) continue;
    if (s.built->structure.values[a.tunable.parameter] != a.tunable.variants[choice.variant])
      break;  // it is still being made
    pending.timedLights = s.lightsOf(a.tunable.passes);
    pending.timedKey = a.key;
    pending.timedVariant = choice.variant;
    pending.timedPasses = a.tunable.passes;
    break;
  }
  return s.refs->output;
}

render::Effect::DebugImage PluginEffect::debugImage(const std::string& name) {
  const State& s = *state_;
  if (!s.refs || !s.built) return {};
  for (const LayoutDebugView& view : s.built->layout.debugViews) {
    if (view.name != name) continue;
    DebugImage image;
    image.channel = view.d.channel;
    image.low = view.d.low;
    image.high = view.d.high;
    image.view = {view.d.mip, 1, view.d.layer, 1, false};
    if (view.d.source == TY_SOURCE_OUTPUT)
      image.image = s.refs->output;
    else if (view.d.source == TY_SOURCE_IMAGE && s.refs->imageHasContents[view.d.index])
      image.image = s.refs->images[view.d.index];
    else if (view.d.source != TY_SOURCE_IMAGE && view.d.index < s.refs->shadowMaps.size() &&
             view.d.layer < (s.built->structure.lightKinds[view.d.index] == TY_LIGHT_POINT ? 6u : 1u))
      image.image = view.d.source == TY_SOURCE_SHADOW_MAP ? s.refs->shadowMaps[view.d.index]
                                                          : s.refs->shadowMoments[view.d.index];
    return image;
  }
  return {};
}

std::vector<PluginDebugView> PluginEffect::debugViews() const {
  State& s = *state_;
  std::vector<PluginDebugView> views;
  if (s.built) {
    for (const LayoutDebugView& view : s.built->layout.debugViews)
      views.push_back({view.name, view.doc, roleOf(view.d.role)});
    return views;
  }
  Structure structure;
  if (auto layout = s.preview(structure))
    for (const LayoutDebugView& view : layout->debugViews) views.push_back({view.name, view.doc, roleOf(view.d.role)});
  return views;
}

void PluginEffect::frameFinished(const std::vector<render::PassTime>& passes) {
  State& s = *state_;
  if (s.pending.empty()) return;
  const State::Pending frame = std::move(s.pending.front());
  s.pending.pop_front();
  s.bytes = frame.built ? bytesUsed(*frame.built, *frame.refs) : 0;
  s.moved = frame.built ? host::bytesMoved(*frame.built, *frame.refs) : std::optional<std::uint64_t>{};
  s.lightBytes = frame.built ? bytesOfLights(*frame.built, *frame.refs) : std::vector<std::uint64_t>{};
  if (!frame.built) return;
  if (const auto& counters = frame.built->layout.counters; counters && !counters->names.empty()) {
    s.counters.clear();
    const std::byte* from = frame.built->resources.counterSlots[frame.slot].mapped();
    for (const std::string& name : counters->names) {
      std::uint32_t count = 0;
      std::memcpy(&count, from, sizeof count);
      from += sizeof count;
      s.counters.emplace_back(name, count);
    }
  }
  if (frame.timedKey.empty()) return;
  double milliseconds = 0;
  bool any = false;
  for (const render::PassTime& time : passes)
    if (time.owner == s.plugin.id())
      for (const std::string& name : frame.timedPasses)
        if (isRunOf(time.name, name)) milliseconds += time.milliseconds, any = true;
  if (any) s.tuner.add(frame.timedKey, frame.timedVariant, milliseconds, frame.timedLights);
}

std::vector<std::pair<std::string, std::uint64_t>> PluginEffect::counters() const { return state_->counters; }

std::vector<std::pair<std::string, std::string>> PluginEffect::resolved() const {
  State& s = *state_;
  std::vector<std::pair<std::string, std::string>> in_use;
  if (!s.asked) return in_use;
  for (const Automatic& a : s.asked->automatics) {
    const params::Parameter& p = s.plugin.parameters()[a.tunable.parameter];
    in_use.emplace_back(p.id,
                        params::toText(p, a.tunable.variants[s.tuner.current(a.key, a.tunable.variants).variant]));
  }
  return in_use;
}

std::vector<std::pair<std::string, std::string>> PluginEffect::remembered() const {
  State& s = *state_;
  // The last call of the plugin's layout() must stay the one that `built` was made from.
  std::vector<Automatic> automatics;
  if (s.built) {
    automatics = s.asked->automatics;
  } else {
    Structure structure;
    const auto layout = s.preview(structure);
    if (!layout) return {};
    automatics = s.automaticsOf(structure, *layout);
  }
  std::vector<std::pair<std::string, std::string>> known;
  for (const Automatic& a : automatics) {
    const params::Parameter& p = s.plugin.parameters()[a.tunable.parameter];
    const double* fastest = s.tuner.remembered(a.key);
    const bool valid = fastest && std::find(a.tunable.variants.begin(), a.tunable.variants.end(), *fastest) !=
                                      a.tunable.variants.end();
    known.emplace_back(p.id, valid ? params::toText(p, *fastest) : "");
  }
  return known;
}

std::vector<std::string> PluginEffect::reloadShaders() {
  State& s = *state_;
  bool changed = false;
  auto lines = s.pipelines.reload(changed);
  if (!changed) return lines;
  // The new code may be what was missing, and what is coming would be the old one's.
  s.forgetComing();
  s.askedNext.reset();
  s.failure.reset();
  if (!s.built) {
    s.asked.reset();
    return lines;
  }
  auto plans = s.pipelines.plan(s.built->layout);
  auto pipelines = plans ? s.pipelines.of(*plans) : plans.error();
  if (pipelines)
    s.built->pipelines = pipelines.take();
  else
    lines.push_back(pipelines.error().message + "; the last good pipeline stays");
  return lines;
}

std::uint64_t PluginEffect::memoryBytes() const { return state_->bytes; }
std::optional<std::uint64_t> PluginEffect::bytesMoved() const { return state_->moved; }
std::vector<std::uint64_t> PluginEffect::lightMemoryBytes() const { return state_->lightBytes; }
const std::optional<Error>& PluginEffect::failure() const {
  return state_->failure ? state_->failure : state_->unprepared;
}

}  // namespace tyndall::host
