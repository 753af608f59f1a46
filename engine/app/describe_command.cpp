// tyndall describe: plugins, techniques, parameters, debug views. Works without a GPU, but for the plugin's debug
// views.
#include <algorithm>

#include "app/print.hpp"
#include "app/session.hpp"
#include "commands.hpp"
#include "settings.hpp"
#include "stats.hpp"

namespace tyndall::app {
namespace {

/// Views of the engine, then those of every technique of the effect, and what its automatic parameters stand for here.
/// Without a device the latter two are left out with a note; a device that was asked for by name has to be there.
Result<std::vector<DebugViewText>> debugViews(std::unique_ptr<Catalogue>& catalogue, const std::string& deviceName,
                                              std::vector<AutomaticText>& automatics, std::vector<std::string>& notes) {
  std::vector<DebugViewText> views;
  for (const render::DebugViewInfo& view : render::Renderer::debugViews())
    views.push_back({view.name, "engine", view.doc, {}});
  gpu::DeviceOptions options;
  options.name = deviceName;
  auto device = gpu::Device::create(options);
  if (!device) {
    if (!deviceName.empty() && device.error().kind == ErrorKind::kBadCall) return device.error();
    notes.push_back("the plugin's debug views are left out: " + device.error().message);
    return views;
  }
  host::Plugin& plugin = catalogue->effectPlugin();
  params::Table& table = catalogue->table();
  auto effect = host::PluginEffect::create(**device, plugin, table);
  if (!effect) {
    notes.push_back("the plugin's debug views are left out: " + effect.error().message);
    return views;
  }
  const auto add = [&](const std::string& technique) {
    for (const host::PluginDebugView& view : (*effect)->debugViews()) {
      auto known = std::find_if(views.begin(), views.end(), [&](const DebugViewText& other) {
        return other.name == view.name && other.owner == plugin.id();
      });
      if (known == views.end()) known = views.insert(known, {view.name, plugin.id(), view.doc, {}});
      if (!technique.empty()) known->techniques.push_back(technique);
    }
    for (const auto& [parameter, value] : (*effect)->remembered()) automatics.push_back({technique, parameter, value});
  };
  if (plugin.selector() >= plugin.parameters().size()) {
    add("");
    return views;
  }
  const std::string selector = plugin.parameters()[plugin.selector()].id;
  const double before = table.value(selector);
  for (const host::TechniqueInfo& technique : plugin.techniques())
    if (table.setText(selector, technique.id)) add(technique.id);
  (void)table.set(selector, before);  // it was a value of this table a moment ago
  return views;
}

std::string range(const params::Parameter& p) {
  if (p.type == params::Type::kBool) return "true, false";
  if (p.type != params::Type::kEnum) return params::toText(p, p.min) + " to " + params::toText(p, p.max);
  std::string text;
  for (std::size_t i = 0; i < p.choices.size(); ++i)
    text += (i ? ", " : "") + p.choices[i] + (i < p.built.size() && !p.built[i] ? " (not built yet)" : "");
  return text;
}

std::string describeText(const Catalogue& catalogue, const std::vector<DebugViewText>& views,
                         const std::vector<AutomaticText>& automatics) {
  std::string text = "plugins\n";
  for (const auto& plugin : catalogue.plugins()) {
    text += "  " + plugin->id() + " " + plugin->version() + " - " + plugin->name() + " (" + plugin->path().string() +
            ")\n    " + plugin->doc() + "\n";
    for (const host::TechniqueInfo& technique : plugin->techniques())
      text += "    technique " + technique.id + " - " + technique.name + ". " + technique.doc + "\n";
  }
  text += "\nparameters\n";
  for (const params::Parameter& p : catalogue.table().parameters()) {
    text += "  " + p.id + " = " + params::toText(p, p.defaultValue) + (p.unit.empty() ? "" : " " + p.unit) + "   [" +
            range(p) + "]\n    " + p.doc + "\n";
  }
  if (!automatics.empty()) text += "\nfastest on this device (1280x720, present sizes)\n";
  for (const AutomaticText& a : automatics)
    text += "  " + (a.technique.empty() ? "" : a.technique + ": ") + a.parameter + "=auto is " +
            (a.value.empty() ? "not measured yet; the first frames that are rendered do it" : a.value) + "\n";
  text += "\ndebug views\n";
  for (const DebugViewText& view : views) {
    std::string of;
    for (const std::string& technique : view.techniques) of += (of.empty() ? ": " : ", ") + technique;
    text += "  " + view.name + " (" + view.owner + of + ") - " + view.doc + "\n";
  }
  return text;
}

}  // namespace

Result<void> runDescribe(const DescribeOptions& options) {
  auto catalogue = loadSettings({{}, {}, options.pluginFolder});
  if (!catalogue) return catalogue.error();
  std::vector<std::string> notes;
  std::vector<AutomaticText> automatics;
  auto views = debugViews(*catalogue, options.device, automatics, notes);
  if (!views) return views.error();
  if (auto done = print(options.json ? describeJson(**catalogue, *views, automatics)
                                     : describeText(**catalogue, *views, automatics));
      !done)
    return done;
  tell((*catalogue)->warnings(), notes);
  return {};
}

}  // namespace tyndall::app
