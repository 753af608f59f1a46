// From what is asked for to a layout made real, and the call of prepare().
#include <algorithm>

#include "base/log.hpp"
#include "effect_state.hpp"

namespace tyndall::host {

namespace {

std::string deviceName(const gpu::DeviceInfo& info) { return info.name + '|' + info.driver; }

}  // namespace

/// Asks the plugin and copies and checks what it says.
Result<Layout> PluginEffect::State::ask(TyInstance* instance, const Structure& structure) {
  Plugin::State& p = plugin.state();
  const TyDevice deviceAbi = makeDevice(device.info());
  const TyStructure structureAbi = structure.abi();
  p.log.hold();
  const TyLayout* const answer = [&] {
    const PluginCall call(p.called(), "layout()");
    return p.plugin.layout(instance, &deviceAbi, &structureAbi);
  }();
  if (answer == nullptr) return failed("it gave no layout" + p.log.reason());
  p.log.letGo();
  auto layout = copyLayout(answer);
  if (!layout) return layout;
  if (auto good = checkLayout(*layout, makeLimits(device.info()), structure.context()); !good) return good.error();
  const auto& parameters = plugin.parameters();
  for (const LayoutTunable& t : layout->tunables)
    for (const double variant : t.variants)
      if (auto good = params::check(parameters[t.parameter], variant); !good)
        return failed("tunable variant of " + good.error().message);
  return layout;
}

Result<Layout> PluginEffect::State::preview(Structure& structure) {
  structure.width = 1280;
  structure.height = 720;
  structure.lightKinds = {TY_LIGHT_DIRECTIONAL};
  structure.shadowSizes = {2048};
  structure.shadowMoments = TY_FORMAT_RGBA16_UNORM;
  structure.lightCookies = {0};
  structure.cookies = true;
  for (const params::Parameter& p : plugin.parameters()) {
    structure.values.push_back(table.value(p.id));
    structure.structural.push_back(p.structural);
  }
  return ask(plugin.state().instance, structure);
}

std::vector<Automatic> PluginEffect::State::automaticsOf(const Structure& wanted, const Layout& layout) const {
  std::vector<Automatic> found;
  // Techniques may share a kernel with other constants.
  std::string owner = plugin.id() + ' ' + plugin.version();
  if (plugin.selector() < plugin.parameters().size())
    owner += ' ' + params::toText(plugin.parameters()[plugin.selector()], wanted.values[plugin.selector()]);
  for (const LayoutTunable& t : layout.tunables) {
    const params::Parameter& p = plugin.parameters()[t.parameter];
    if (wanted.values[t.parameter] == t.automatic)
      found.push_back({tunableKey(owner, deviceName(device.info()), p.id, t, layout), t});
  }
  return found;
}

Structure PluginEffect::State::resolved(const Structure& wanted, const std::vector<Automatic>& list) {
  Structure structure = wanted;
  for (const Automatic& a : list)
    structure.values[a.tunable.parameter] = a.tunable.variants[tuner.current(a.key, a.tunable.variants).variant];
  return structure;
}

Result<std::shared_ptr<Built>> PluginEffect::State::describe(TyInstance* instance, Structure structure,
                                                             bool castersOffered) {
  auto layout = ask(instance, structure);
  if (!layout) return layout.error();
  auto next = std::make_shared<Built>();
  next->instance = instance;
  next->structure = std::move(structure);
  next->layout = layout.take();
  next->runs = expandPasses(next->layout, next->structure.lightKinds);
  for (const LayoutPass& pass : next->layout.passes) {
    if (pass.d.kind == TY_PASS_CASTERS && !castersOffered)
      return failed("pass '" + pass.name + "': draws shadow casters, which this renderer does not offer");
    auto uses = usesOf(next->layout, pass);
    if (!uses) return uses.error();
    next->uses.push_back(uses.take());
    next->moved.push_back(host::bytesMoved(next->layout, pass, next->outputBytes()));
  }
  return next;
}

Result<void> PluginEffect::State::furnish(Built& next) {
  auto resources = makeResources(device, next.layout);
  if (!resources) return resources.error();
  next.resources = resources.take();
  auto uniforms = UniformRing::create(device, next.layout, static_cast<std::uint32_t>(next.structure.lightKinds.size()),
                                      plugin.id() + " uniforms");
  if (!uniforms) return uniforms.error();
  next.uniforms = uniforms.take();
  return {};
}

Result<void> PluginEffect::State::build(TyInstance* instance, Structure structure, const render::EffectInput& input) {
  auto next = describe(instance, std::move(structure), static_cast<bool>(input.drawCasters));
  if (!next) return next.error();
  auto plans = pipelines.plan((*next)->layout);
  if (!plans) return plans.error();
  auto made = pipelines.of(*plans);
  if (!made) return made.error();
  (*next)->pipelines = made.take();
  if (auto furnished = furnish(**next); !furnished) return furnished;
  built = next.take();
  noteCompiled(*built, *plans, input);
  reset = true;
  return {};
}

/// Brings `built` up to the table's values, now or in time. False: there is nothing to draw with.
bool PluginEffect::State::bring(const Structure& wanted, const render::EffectInput& input) {
  const auto refuse = [&](const Error& error, const char* consequence) {
    failure = failed("plugin '" + plugin.id() + "': " + error.message);
    refused = wanted;
    log::error(failure->message + consequence);
  };
  constexpr const char* kOff = "; it is off until its settings change";
  if (!failure || !refused.sameLayout(wanted)) {
    failure.reset();
    const bool beside = background && built;
    if (auto updated = beside ? updateInBackground(wanted, input) : update(wanted, input); !updated) {
      forgetComing();
      askedNext.reset();
      if (!beside) built.reset();
      refuse(updated.error(), beside ? "; the settings before go on" : kOff);
    }
  }
  if (!background || !built) return !failure && built;
  if (auto kept = keepUp(wanted, input); !kept) {
    built.reset();
    refuse(kept.error(), kOff);
  }
  return built != nullptr;
}

/// Brings `built` up to what is asked for.
Result<void> PluginEffect::State::update(const Structure& wanted, const render::EffectInput& input) {
  TyInstance* const instance = plugin.state().instance;
  if (!asked || !asked->structure.sameLayout(wanted)) {
    asked = Asked{wanted, {}};
    built.reset();
    auto layout = ask(instance, wanted);
    if (!layout) return layout.error();
    asked->automatics = automaticsOf(wanted, *layout);
  }
  Structure structure = resolved(wanted, asked->automatics);
  if (built && built->structure.sameLayout(structure)) return {};
  built.reset();  // before the new one is made: both at once may not fit
  return build(instance, std::move(structure), input);
}

std::set<std::uint32_t> PluginEffect::State::lightsOf(const std::vector<std::string>& passes) const {
  std::set<std::uint32_t> lights;
  for (const PassRun& run : built->runs)
    if (std::find(passes.begin(), passes.end(), built->layout.passes[run.pass].name) != passes.end() &&
        !built->uniforms.skipped(run.pass, run.light == TY_NONE ? 0 : run.light))
      lights.insert(run.light);
  return lights;
}

bool PluginEffect::State::prepare(const render::EffectInput& input) {
  // Of structural parameters, the values that the layout was made for: the table may be ahead of it.
  std::vector<double> values = built->structure.values;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!built->structure.structural[i]) values[i] = table.value(plugin.parameters()[i].id);
  const TyView view = makeView(input.view);
  std::vector<TyLight> lights;
  for (const render::ShadowedLight& light : input.lights) lights.push_back(makeLight(light));
  TyFrame abi{};
  abi.struct_size = sizeof abi;
  abi.reset = reset ? 1 : 0;
  abi.view = &view;
  abi.lights = lights.data();
  abi.light_count = static_cast<std::uint32_t>(lights.size());
  abi.values = values.data();
  abi.value_count = static_cast<std::uint32_t>(values.size());
  Plugin::State& p = plugin.state();
  {
    const PluginCall call(p.called(), "prepare()");
    if (!p.plugin.prepare(built->instance, &abi, &built->uniforms.begin())) {
      if (!unprepared) {
        unprepared = failed("plugin '" + plugin.id() + "': prepare() failed");
        log::error(unprepared->message + "; frames are drawn without it until it succeeds");
      }
      return false;
    }
  }
  unprepared.reset();
  reset = false;
  return true;
}

}  // namespace tyndall::host
