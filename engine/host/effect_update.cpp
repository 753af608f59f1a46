// From what is asked for to a layout made real, and the call of prepare().
#include <algorithm>

#include "effect_state.hpp"

namespace tyndall::host {

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
  return ask(structure);
}

std::vector<PluginEffect::State::Automatic> PluginEffect::State::automaticsOf(const Structure& wanted, const Layout& layout) const {
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
  auto resources = makeResources(device, next->layout);
  if (!resources) return resources.error();
  next->resources = resources.take();
  auto uniforms = UniformRing::create(
      device, next->layout, static_cast<std::uint32_t>(next->structure.lightKinds.size()), plugin.id() + " uniforms");
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

/// Brings `built` up to what is asked for. The last call of the plugin's layout() is always the one `built` was made
/// from.
Result<void> PluginEffect::State::update(const Structure& wanted, bool castersOffered) {
  if (!asked || !asked->sameLayout(wanted)) {
    asked = wanted;
    automatics.clear();
    built.reset();
    auto layout = ask(wanted);
    if (!layout) return layout.error();
    automatics = automaticsOf(wanted, *layout);
  }
  Structure resolved = wanted;
  resolve(resolved);
  if (built && built->structure.sameLayout(resolved)) return {};
  built.reset();  // before the new one is made: both at once may not fit
  return build(std::move(resolved), castersOffered);
}

std::set<std::uint32_t> PluginEffect::State::lightsOf(const std::vector<std::string>& passes) const {
  std::set<std::uint32_t> lights;
  for (const PassRun& run : built->runs)
    if (std::find(passes.begin(), passes.end(), built->layout.passes[run.pass].name) != passes.end() &&
        !built->uniforms.skipped(run.pass, run.light == TY_NONE ? 0 : run.light))
      lights.insert(run.light);
  return lights;
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

}  // namespace tyndall::host
