#include "app/catalogue.hpp"

#include <algorithm>
#include <cstdlib>

#include "base/file.hpp"

namespace tyndall::app {
namespace fs = std::filesystem;

namespace {

constexpr const char* kEffectId = "volumetrics";

bool contains(const std::vector<std::string>& list, const std::string& text) {
  return std::find(list.begin(), list.end(), text) != list.end();
}

}  // namespace

fs::path pluginFolder(const fs::path& asked) {
  if (!asked.empty()) return asked;
  if (const char* folder = std::getenv("TYNDALL_PLUGIN_DIR"); folder && *folder) return folder;
  return executableFolder() / "plugins";
}

Result<std::unique_ptr<Catalogue>> Catalogue::load(const fs::path& folder) {
  host::PluginSet set = host::loadPlugins(folder);
  const auto isEffect = [](const auto& plugin) { return plugin->id() == kEffectId; };
  auto effect = std::find_if(set.plugins.begin(), set.plugins.end(), isEffect);
  if (effect == set.plugins.end()) {
    // The reason why the plugin itself is not usable says more than that it is missing.
    if (!set.errors.empty()) return set.errors.front();
    if (set.plugins.size() != 1)
      return failed("no volumetrics plugin in " + folder.string() +
                    "; put volumetrics.so there, or name its folder with --plugin-dir or TYNDALL_PLUGIN_DIR");
    effect = set.plugins.begin();
  }
  auto catalogue = std::unique_ptr<Catalogue>(new Catalogue);
  for (const Error& error : set.errors) catalogue->warnings_.push_back(error.message);
  if (auto added = catalogue->table_.add(params::engineParameters()); !added) return added.error();
  const host::Plugin* chosen = effect->get();
  for (auto& plugin : set.plugins) {
    if (auto added = catalogue->table_.add(plugin->parameters()); !added) {
      if (plugin.get() == chosen) return failed(plugin->path().string() + ": " + added.error().message);
      catalogue->warnings_.push_back(plugin->path().string() + ": " + added.error().message);
      continue;
    }
    if (plugin.get() == chosen) catalogue->effect_ = catalogue->plugins_.size();
    catalogue->plugins_.push_back(std::move(plugin));
  }
  return catalogue;
}

std::string Catalogue::techniqueName() const {
  const host::Plugin& plugin = effectPlugin();
  if (plugin.selector() >= plugin.parameters().size()) return plugin.id();
  const params::Parameter& selector = plugin.parameters()[plugin.selector()];
  return params::toText(selector, table_.value(selector.id));
}

const host::TechniqueInfo* Catalogue::technique() const {
  const std::string name = techniqueName();
  const bool only =
      effectPlugin().selector() >= effectPlugin().parameters().size() && effectPlugin().techniques().size() == 1;
  for (const host::TechniqueInfo& info : effectPlugin().techniques())
    if (only || info.id == name) return &info;
  return nullptr;
}

bool Catalogue::readsShadowMoments() const {
  if (params::toText(*table_.find("shadows.mode"), table_.value("shadows.mode")) == "moments") return true;
  const std::string& plugin = effectPlugin().id();
  const host::TechniqueInfo* chosen = technique();
  if (!chosen || (table_.find(plugin + ".enabled") && table_.value(plugin + ".enabled") == 0)) return false;
  const std::string filtered = plugin + ".filtered_resampling";
  return contains(chosen->reads, filtered) && table_.value(filtered) != 0;
}

std::vector<std::string> Catalogue::unusedSettings() const {
  const host::Plugin& plugin = effectPlugin();
  const host::TechniqueInfo* chosen = technique();
  const std::string enabledId = plugin.id() + ".enabled";
  const bool enabled = !table_.find(enabledId) || table_.value(enabledId) != 0;
  std::vector<std::string> unused;
  for (const std::string& id : table_.assigned()) {
    const params::Parameter& parameter = *table_.find(id);
    if (parameter.owner == "engine") {
      // The engine reads all of its own, but for the precision of moment shadow maps where there are none.
      if (id == "shadows.precision" && !readsShadowMoments()) unused.push_back(id);
      continue;
    }
    if (parameter.owner != plugin.id()) {
      unused.push_back(id);
      continue;
    }
    const bool steers = id == enabledId || (plugin.selector() < plugin.parameters().size() &&
                                            id == plugin.parameters()[plugin.selector()].id);
    if (!steers && !(enabled && chosen && contains(chosen->reads, id))) unused.push_back(id);
  }
  return unused;
}

Result<void> Catalogue::replaceEffectPlugin(std::unique_ptr<host::Plugin> plugin) {
  if (plugin->id() != effectPlugin().id())
    return failed(plugin->path().string() + ": is now plugin '" + plugin->id() + "'; '" + effectPlugin().id() +
                  "' is in use");
  table_.remove(effectPlugin().id());
  if (auto added = table_.add(plugin->parameters()); !added) {
    // The old table was accepted before, among the same neighbours.
    (void)table_.add(effectPlugin().parameters());
    return failed(plugin->path().string() + ": " + added.error().message);
  }
  plugins_[effect_] = std::move(plugin);
  return {};
}

}  // namespace tyndall::app
