// One plugin as an Effect: layout, prepare, passes, in that order each frame.
#include <deque>

#include "base/assert.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "built.hpp"
#include "plugin_state.hpp"
#include "tuner.hpp"

namespace tyndall::host {

struct PluginEffect::State {
  State(gpu::Device& d, Plugin& p, const params::Table& t)
      : device(d), plugin(p), table(t), pipelines(d, p.path().parent_path() / p.id()),
        tuner(TunerStore(cacheFolder().empty() ? std::filesystem::path{} : cacheFolder() / "tunables.json")) {}

  /// A tunable whose parameter is on automatic, in the layout for the structure that was asked for.
  struct Automatic { std::string key; LayoutTunable tunable; };
  /// What is known of a frame whose passes were declared, until frameFinished() tells of it.
  struct Pending {
    std::shared_ptr<Built> built;  ///< null: nothing ran
    std::uint32_t slot = 0;
    std::string timedKey;          ///< the tunable that this frame times, or ""
    std::size_t timedVariant = 0;
    std::vector<std::string> timedPasses;
  };

  Result<Layout> ask(const Structure& structure);
  Result<void> build(Structure structure, bool castersOffered);
  Result<void> update(const Structure& asked, bool castersOffered);
  bool prepare(const render::EffectInput& input, const Structure& asked);
  void resolve(Structure& structure);

  gpu::Device& device;
  Plugin& plugin;
  const params::Table& table;
  Pipelines pipelines;
  Tuner tuner;

  std::optional<Structure> asked;      ///< what `automatics`, `built` and `failure` belong to
  std::vector<Automatic> automatics;
  std::shared_ptr<Built> built;
  std::optional<Error> failure;
  bool reset = true;                   ///< no prepare() has succeeded since the last cut or new layout
  std::uint64_t frame = 0;
  std::deque<Pending> pending;
  std::shared_ptr<const FrameRefs> refs;  ///< of the last addPasses
  std::vector<std::pair<std::string, std::uint64_t>> counters;
};

namespace {

std::string deviceName(const gpu::DeviceInfo& info) { return info.name + '|' + info.driver; }

}  // namespace

/// Asks the plugin and copies and checks what it says.
Result<Layout> PluginEffect::State::ask(const Structure& structure) {
  Plugin::State& p = plugin.state();
  const TyDevice deviceAbi = makeDevice(device.info());
  const TyStructure structureAbi = structure.abi();
  auto layout = copyLayout(p.plugin.layout(p.instance, &deviceAbi, &structureAbi));
  if (!layout) return layout;
  if (auto good = checkLayout(*layout, makeLimits(device.info()), structure.context()); !good) return good.error();
  const auto& parameters = plugin.parameters();
  for (const LayoutTunable& t : layout->tunables)
    for (const double variant : t.variants)
      if (auto good = params::check(parameters[t.parameter], variant); !good) return failed("tunable variant of " + good.error().message);
  return layout;
}

Result<void> PluginEffect::State::build(Structure structure, bool castersOffered) {
  auto layout = ask(structure);
  if (!layout) return layout.error();
  auto next = std::make_shared<Built>();
  next->structure = std::move(structure);
  next->layout = layout.take();
  next->runs = expandPasses(next->layout, next->structure.lightKinds);
  for (const LayoutPass& pass : next->layout.passes) {
    if (pass.d.kind == TY_PASS_CASTERS && !castersOffered)
      return failed("pass '" + pass.name + "': draws shadow casters, which this renderer does not offer");
    auto uses = usesOf(next->layout, pass);
    if (!uses) return uses.error();
    next->uses.push_back(uses.take());
  }
  auto made = pipelines.of(next->layout);
  if (!made) return made.error();
  next->pipelines = made.take();
  auto resources = makeResources(device, next->layout, next->structure.width, next->structure.height);
  if (!resources) return resources.error();
  next->resources = resources.take();
  auto uniforms = UniformRing::create(device, next->layout, static_cast<std::uint32_t>(next->structure.lightKinds.size()), plugin.id() + " uniforms");
  if (!uniforms) return uniforms.error();
  next->uniforms = uniforms.take();
  built = std::move(next);
  reset = true;
  return {};
}

/// Puts the variant in use in the place of each automatic value. One tunable is timed at a time.
void PluginEffect::State::resolve(Structure& structure) {
  for (const Automatic& a : automatics)
    structure.values[a.tunable.parameter] = a.tunable.variants[tuner.current(a.key, a.tunable.variants).variant];
}

/// Brings `built` up to what is asked for. The last call of the plugin's layout() is always the one `built` was made from.
Result<void> PluginEffect::State::update(const Structure& wanted, bool castersOffered) {
  if (!asked || !asked->sameLayout(wanted)) {
    asked = wanted;
    automatics.clear();
    built.reset();
    auto layout = ask(wanted);
    if (!layout) return layout.error();
    for (const LayoutTunable& t : layout->tunables) {
      const params::Parameter& p = plugin.parameters()[t.parameter];
      if (wanted.values[t.parameter] == t.automatic)
        automatics.push_back({tunableKey(plugin.id() + ' ' + plugin.version(), deviceName(device.info()), p.id, t, *layout), t});
    }
  }
  Structure resolved = wanted;
  resolve(resolved);
  if (built && built->structure.sameLayout(resolved)) return {};
  built.reset();  // before the new one is made: both at once may not fit
  return build(std::move(resolved), castersOffered);
}

bool PluginEffect::State::prepare(const render::EffectInput& input, const Structure& wanted) {
  Structure resolved = wanted;
  resolve(resolved);
  const TyView view = makeView(input.view);
  std::vector<TyLight> lights;
  for (const render::ShadowedLight& light : input.lights) lights.push_back(makeLight(light));
  TyFrame abi{};
  abi.struct_size = sizeof abi;
  abi.reset = reset ? 1 : 0;
  abi.view = &view;
  abi.lights = lights.data();
  abi.light_count = static_cast<std::uint32_t>(lights.size());
  abi.values = resolved.values.data();
  abi.value_count = static_cast<std::uint32_t>(resolved.values.size());
  Plugin::State& p = plugin.state();
  if (!p.plugin.prepare(p.instance, &abi, &built->uniforms.begin())) return false;
  reset = false;
  return true;
}

Result<std::unique_ptr<PluginEffect>> PluginEffect::create(gpu::Device& device, Plugin& plugin, const params::Table& table) {
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

  const Structure wanted = makeStructure(input, s.plugin.parameters(), s.table);
  if (s.failure && s.asked && s.asked->sameLayout(wanted)) return render::ImageRef{};
  s.failure.reset();
  if (auto updated = s.update(wanted, static_cast<bool>(input.drawCasters)); !updated) {
    s.failure = failed("plugin '" + s.plugin.id() + "': " + updated.error().message);
    log::error(s.failure->message + "; it is off until its settings change");
    s.built.reset();
    return render::ImageRef{};
  }
  if (s.built->layout.passes.empty() || !s.prepare(input, wanted)) return render::ImageRef{};

  s.built->uniforms.commit(pending.slot);
  s.refs = addFramePasses(input, s.built, s.plugin.id(), pending.slot);
  pending.built = s.built;
  for (const State::Automatic& a : s.automatics) {
    const auto choice = s.tuner.current(a.key, a.tunable.variants);
    if (choice.settled) continue;
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
    if (view.d.source == TY_SOURCE_OUTPUT) image.image = s.refs->output;
    else if (view.d.source == TY_SOURCE_IMAGE && s.refs->imageHasContents[view.d.index]) image.image = s.refs->images[view.d.index];
    else if (view.d.source == TY_SOURCE_SHADOW_MAP && view.d.index < s.refs->shadowMaps.size() &&
             view.d.layer < (s.built->structure.lightKinds[view.d.index] == TY_LIGHT_POINT ? 6u : 1u))
      image.image = s.refs->shadowMaps[view.d.index];
    return image;
  }
  return {};
}

std::vector<PluginDebugView> PluginEffect::debugViews() const {
  State& s = *state_;
  std::vector<PluginDebugView> views;
  if (s.built) {
    for (const LayoutDebugView& view : s.built->layout.debugViews) views.push_back({view.name, view.doc});
    return views;
  }
  // A picture and a sun as they might be; nothing is made from this layout.
  Structure structure;
  structure.width = 1280;
  structure.height = 720;
  structure.lightKinds = {TY_LIGHT_DIRECTIONAL};
  structure.shadowSizes = {2048};
  for (const params::Parameter& p : s.plugin.parameters()) {
    structure.values.push_back(s.table.value(p.id));
    structure.structural.push_back(p.structural);
  }
  if (auto layout = s.ask(structure))
    for (const LayoutDebugView& view : layout->debugViews) views.push_back({view.name, view.doc});
  return views;
}

void PluginEffect::frameFinished(const std::vector<render::PassTime>& passes) {
  State& s = *state_;
  if (s.pending.empty()) return;
  const State::Pending frame = std::move(s.pending.front());
  s.pending.pop_front();
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
  if (any) s.tuner.add(frame.timedKey, frame.timedVariant, milliseconds);
}

std::vector<std::pair<std::string, std::uint64_t>> PluginEffect::counters() const { return state_->counters; }

std::vector<std::pair<std::string, std::string>> PluginEffect::resolved() const {
  State& s = *state_;
  std::vector<std::pair<std::string, std::string>> in_use;
  for (const State::Automatic& a : s.automatics) {
    const params::Parameter& p = s.plugin.parameters()[a.tunable.parameter];
    in_use.emplace_back(p.id, params::toText(p, a.tunable.variants[s.tuner.current(a.key, a.tunable.variants).variant]));
  }
  return in_use;
}

std::vector<std::string> PluginEffect::reloadShaders() {
  State& s = *state_;
  bool changed = false;
  auto lines = s.pipelines.reload(changed);
  if (!changed) return lines;
  if (s.failure) s.failure.reset(), s.asked.reset();  // the new code may be what was missing
  if (!s.built) return lines;
  auto pipelines = s.pipelines.of(s.built->layout);
  if (pipelines) s.built->pipelines = pipelines.take();
  else lines.push_back(pipelines.error().message + "; the last good pipeline stays");
  return lines;
}

std::uint64_t PluginEffect::memoryBytes() const { return state_->built ? state_->built->resources.bytes : 0; }
const std::optional<Error>& PluginEffect::failure() const { return state_->failure; }

}  // namespace tyndall::host
